// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The fragment shader that a mapper draws with, as OpenGL gets it.

#ifndef ShaderText_h
#define ShaderText_h

#include "vtkAbstractVolumeMapper.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <string>

namespace
{
// Filled from the second frame on: VTK sends the event in frames that do not build the shader. (The mapper
// of tetrahedra sends it in every frame.)
class ShaderText
{
public:
  explicit ShaderText(vtkAbstractVolumeMapper* mapper)
  {
    this->Command->SetClientData(&this->Text);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* text, void* program) {
      *static_cast<std::string*>(text) =
        static_cast<vtkShaderProgram*>(program)->GetFragmentShader()->GetSource();
    });
    mapper->AddObserver(vtkCommand::UpdateShaderEvent, this->Command);
  }

  std::string Text;

private:
  vtkNew<vtkCallbackCommand> Command;
};
}

#endif
