// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a mapper tells about the normals and frames that it computes.

#ifndef FrameEvents_h
#define FrameEvents_h

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"

namespace
{
class FrameEvents
{
public:
  explicit FrameEvents(vtkObject* mapper)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(Receive);
    mapper->AddObserver(vtkCommand::VolumeMapperComputeGradientsStartEvent, this->Command);
    mapper->AddObserver(vtkCommand::VolumeMapperComputeGradientsProgressEvent, this->Command);
    mapper->AddObserver(vtkCommand::VolumeMapperComputeGradientsEndEvent, this->Command);
  }
  ~FrameEvents() { this->Command->SetClientData(nullptr); }
  FrameEvents(const FrameEvents&) = delete;
  void operator=(const FrameEvents&) = delete;

  int Starts = 0;
  int Steps = 0;
  int Ends = 0;
  bool Rises = true;
  double Last = 0.0;

  // Aborts the window's frame as soon as the progress has come so far.
  vtkRenderWindow* Window = nullptr;
  double AbortAt = 2.0;

private:
  static void Receive(vtkObject*, unsigned long event, void* client, void* data)
  {
    if (auto* events = static_cast<FrameEvents*>(client))
    {
      events->Count(event, data);
    }
  }

  void Count(unsigned long event, void* data)
  {
    if (event == vtkCommand::VolumeMapperComputeGradientsStartEvent)
    {
      ++this->Starts;
      this->Last = 0.0;
    }
    else if (event == vtkCommand::VolumeMapperComputeGradientsEndEvent)
    {
      ++this->Ends;
    }
    else
    {
      const double progress = *static_cast<double*>(data);
      ++this->Steps;
      this->Rises = this->Rises && progress >= this->Last && progress <= 1.0;
      this->Last = progress;
      if (this->Window && progress >= this->AbortAt)
      {
        this->Window->SetAbortRender(1);
      }
    }
  }

  vtkNew<vtkCallbackCommand> Command;
};
}

#endif
