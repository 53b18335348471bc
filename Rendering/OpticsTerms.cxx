// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OpticsTerms.h"

#include "SceneNeeds.h"
#include "SweepViews.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtk_glew.h"

#include <algorithm>

//------------------------------------------------------------------------------
std::vector<OpticsTerm*> vtkOpticsVolumeMapper::Implementation::Prepare(const OpticsScene& scene)
{
  std::vector<OpticsTerm*> active;
  this->ActiveTerms.clear();
  if (!scene.Scalars || !scene.Window)
  {
    return active;
  }
  OpticsFeatures features;
  for (OpticsTerm* term : this->All)
  {
    if (term->IsActive(scene) && term->Prepare(scene))
    {
      term->AddFeatures(scene, features);
      active.push_back(term);
      const std::string name = term->GetName();
      this->ActiveTerms += (this->ActiveTerms.empty() || name.empty() ? "" : ",") + name;
    }
    else
    {
      term->ReleaseGraphicsResources(scene.Window);
    }
  }
  if (this->ActiveTerms.empty())
  {
    active.clear(); // what is left is only what others would have built on
  }
  this->Pass->SetFeatures(features);
  return active;
}

//------------------------------------------------------------------------------
// VTK's mapper gives up what it holds in another window in the midst of a frame, the terms' with it:
// do so before they are prepared.
void vtkOpticsVolumeMapper::Implementation::LeaveOtherWindow(
  vtkOpticsVolumeMapper* mapper, vtkRenderWindow* window)
{
  if (this->LastWindow && this->LastWindow != window)
  {
    mapper->ReleaseGraphicsResources(this->LastWindow);
  }
  this->LastWindow = window;
}

//------------------------------------------------------------------------------
bool vtkOpticsVolumeMapper::Implementation::Sweeps(
  const OpticsScene& scene, const std::vector<OpticsTerm*>& active)
{
  const bool hasShadows = std::find(active.begin(), active.end(), &this->Shadows) != active.end();
  return (hasShadows || HasOcclusion(scene)) && !IsSelection(scene);
}

//------------------------------------------------------------------------------
// VTK has one block of a volume in partitions in its texture at a time, and a sweep needs all of them. So VTK draws all
// of them once where no pixel is.
void vtkOpticsVolumeMapper::Implementation::FillBlocks(
  OpticsScene scene, const std::vector<OpticsTerm*>& active, const std::function<void()>& draw)
{
  vtkOpenGLState* state = scene.Window->GetState();
  const vtkOpenGLState::ScopedglScissor scissor(state);
  const vtkOpenGLState::ScopedglEnableDisable test(state, GL_SCISSOR_TEST);
  state->SetEnumState(GL_SCISSOR_TEST, true);
  state->vtkglScissor(0, 0, 0, 0);
  scene.FillsBlocks = true;
  this->Pass->Attach(scene, active);
  draw();
  this->Pass->Detach();
}
