// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StructuralScore.h"

#include "vtkStructuralDissimilarity.h"

#include <vtkNew.h>
#include <vtkPNGReader.h>

double StructuralScore(const std::string& picture, const std::string& reference)
{
  vtkNew<vtkPNGReader> readers[2];
  readers[0]->SetFileName(reference.c_str());
  readers[1]->SetFileName(picture.c_str());
  vtkNew<vtkStructuralDissimilarity> score;
  score->SetReferenceConnection(readers[0]->GetOutputPort());
  score->SetPictureConnection(readers[1]->GetOutputPort());
  score->Update();
  return score->GetScore();
}
