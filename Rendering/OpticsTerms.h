// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The terms of a mapper, and those that a frame is drawn with.

#ifndef OpticsTerms_h
#define OpticsTerms_h

#include "EmptySpaceTerm.h"
#include "FrameAbort.h"
#include "FrameTerm.h"
#include "IntegrationTerm.h"
#include "LightingTransferFunctionTerm.h"
#include "LineVoxelTerm.h"
#include "MultiSampleTerm.h"
#include "OcclusionTerm.h"
#include "PieceTerm.h"
#include "ReflectanceTerm.h"
#include "ShadowTerm.h"
#include "TransferFunctionTerm.h"
#include "vtkOpticsShaderPass.h"
#include "vtkOpticsVolumeMapper.h"
#include "vtkOpticsVolumeProperty.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

class vtkOpticsVolumeMapper::Implementation
{
public:
  std::vector<OpticsTerm*> Prepare(const OpticsScene& scene);
  void LeaveOtherWindow(vtkOpticsVolumeMapper* mapper, vtkRenderWindow* window);
  bool Sweeps(const OpticsScene& scene, const std::vector<OpticsTerm*>& active);
  void FillBlocks(
    OpticsScene scene, const std::vector<OpticsTerm*>& active, const std::function<void()>& draw);

  // In the order of preparation: first what others build on.
  FrameTerm Frames;
  TransferFunctionTerm TransferFunctions;
  ReflectanceTerm Reflectance{ this->Frames };
  IntegrationTerm Integration{ this->Frames };
  LightingTransferFunctionTerm LightingTransferFunction{ this->Frames };
  MultiSampleTerm MultiSample{ this->Frames };
  EmptySpaceTerm EmptySpace;
  LineVoxelTerm Lines;
  OcclusionTerm Occlusion;
  ShadowTerm Shadows;
  PieceTerm Piece;
  std::vector<OpticsTerm*> All = { &this->Frames, &this->TransferFunctions, &this->Reflectance,
    &this->LightingTransferFunction, &this->MultiSample, &this->Integration, &this->Lines, &this->Occlusion,
    &this->Shadows, &this->EmptySpace, &this->Piece };
  vtkNew<vtkOpticsVolumeProperty> PlainOptics; // of volumes whose property is VTK's
  vtkNew<vtkOpticsShaderPass> Pass;
  vtkSmartPointer<vtkOpticsVolumeProperty> Optics;
  vtkWeakPointer<vtkRenderWindow> LastWindow;
  std::unique_ptr<ScissorScope> Scissor; // of a frame that can be aborted
  std::set<std::string> Said;
  std::string ActiveTerms;
};

#endif
