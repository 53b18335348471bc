// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Lighting transfer functions of the command line: options, files, and the pane with the editor.

#ifndef Lighting_h
#define Lighting_h

#include "PictureSettings.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkContextActor;
class vtkContextScene;
class vtkGradientAlignedHistogram;
class vtkImageData;
class vtkLightingTransferFunction;
class vtkLightingTransferFunctionItem;
class vtkOpticsVolumeProperty;
class vtkPiecewiseFunction;
class vtkRenderer;

// Throw UserError.
std::string ReadLighting(const std::string& path); // JSON text
void WriteLighting(vtkLightingTransferFunction* function, const std::string& path);

// Sets what the property has of lighting transfer functions.
void Apply(const LightingSettings& lighting, vtkOpticsVolumeProperty* property);

// The editor on the histogram of a volume, in a renderer of its own.
class LightingPane
{
public:
  // opacity: for the lines between equal ones. function: what is edited; if it has no boundaries, they are
  // guessed, at most `guesses` of them.
  LightingPane(vtkImageData* image, vtkPiecewiseFunction* opacity, vtkLightingTransferFunction* function,
    double stepLength, int guesses);
  ~LightingPane();
  LightingPane(const LightingPane&) = delete;
  LightingPane& operator=(const LightingPane&) = delete;

  vtkRenderer* GetRenderer() { return this->Renderer; }
  vtkContextScene* GetScene();
  vtkLightingTransferFunctionItem* GetItem() { return this->Item; }

private:
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkContextActor> Actor;
  vtkNew<vtkGradientAlignedHistogram> Histogram;
  vtkNew<vtkLightingTransferFunctionItem> Item;
};

#endif
