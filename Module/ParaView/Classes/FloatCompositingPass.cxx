// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FloatCompositingPass.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkFloatArray.h"
#include "vtkIceTCompositePass.h"
#include "vtkIceTContext.h"
#include "vtkImageProcessingPass.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPVDataRepresentation.h"
#include "vtkPVLogger.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <IceT.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(FloatCompositingPass);

namespace
{
FloatCompositingPass* Drawing = nullptr;

void DrawForIceT(
  const IceTDouble* projection, const IceTDouble*, const IceTFloat*, const IceTInt*, IceTImage result)
{
  Drawing->Draw(
    projection, icetImageGetWidth(result), icetImageGetHeight(result), icetImageGetColorf(result));
}

vtkOpenGLRenderWindow* WindowOf(const vtkRenderState* state)
{
  return static_cast<vtkOpenGLRenderWindow*>(state->GetRenderer()->GetRenderWindow());
}

// OpenGL's, and so IceT's, matrices are columns, VTK's are rows.
void CopyTransposed(const double from[16], double to[16])
{
  vtkMatrix4x4::Transpose(from, to);
}

// What ParaView's pass does for itself and shares with its subclasses.
struct Inside : vtkIceTCompositePass
{
  static void SetUp(vtkIceTCompositePass* pass, const vtkRenderState* state)
  {
    vtkIceTContext* context = pass->*(&Inside::IceTContext);
    context->SetController(pass->GetController());
    context->MakeCurrent();
    pass->SetEnableFloatValuePass(true); // the format of what IceT composites
    (pass->*(&Inside::SetupContext))(state);
    pass->SetEnableFloatValuePass(false);
  }

  // Where ParaView and its image processing look for what was composited.
  static vtkSynchronizedRenderers::vtkRawImage& Result(vtkIceTCompositePass* pass)
  {
    return *(pass->*(&Inside::LastRenderedRGBAColors));
  }

  static void Show(vtkIceTCompositePass* pass, const vtkRenderState* state)
  {
    (pass->*(&Inside::LastRenderedDepths))->SetNumberOfTuples(0);
    (pass->*(&Inside::LastRenderedRGBA32F))->SetNumberOfTuples(0);
    (pass->*(&Inside::DisplayResultsIfNeeded))(state);
    (pass->*(&Inside::CleanupContext))(state);
  }
};

IceTImage DrawFrame(vtkRenderer* renderer)
{
  IceTInt viewport[4]; // of all tiles
  icetGetIntegerv(ICET_GLOBAL_VIEWPORT, viewport);
  vtkCamera* camera = renderer->GetActiveCamera();
  const double aspect = static_cast<double>(viewport[2]) / viewport[3];
  double projection[16];
  CopyTransposed(camera->GetProjectionTransformMatrix(aspect, -1, 1)->GetData(), projection);
  double modelView[16];
  CopyTransposed(camera->GetModelViewTransformMatrix()->GetData(), modelView);
  const float background[4] = { 0.0F, 0.0F, 0.0F, 0.0F };
  icetDrawCallback(DrawForIceT);
  return icetDrawFrame(projection, modelView, background);
}

// Saturated, as what is drawn into bytes.
void CopySaturated(IceTImage image, vtkSynchronizedRenderers::vtkRawImage& bytes)
{
  if (icetImageGetColorFormat(image) == ICET_IMAGE_COLOR_NONE)
  {
    bytes.MarkInValid(); // the picture is another process's
    return;
  }
  bytes.Resize(icetImageGetWidth(image), icetImageGetHeight(image), 4);
  const float* pixels = icetImageGetColorcf(image);
  std::transform(
    pixels, pixels + 4 * icetImageGetNumPixels(image), bytes.GetRawPtr()->GetPointer(0), [](float share) {
      return static_cast<unsigned char>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F)));
    });
  bytes.MarkValid();
}

// Beside what ParaView's own pass says of IceT.
void LogBytes()
{
  IceTInt bytes = 0;
  icetGetIntegerv(ICET_BYTES_SENT, &bytes);
  vtkVLogF(PARAVIEW_LOG_RENDERING_VERBOSITY(), "ICET_BYTES_SENT: %d", bytes);
}

// The one that ParaView draws a renderer with, below its image processing.
vtkCameraPass* FindCameraPass(vtkRenderer* renderer)
{
  vtkRenderPass* pass = renderer->GetPass();
  while (auto* processing = vtkImageProcessingPass::SafeDownCast(pass))
  {
    pass = processing->GetDelegatePass();
  }
  return vtkCameraPass::SafeDownCast(pass);
}

// While it lives, the camera has another projection, and the renderer all of the window, black.
class SceneOfProcess
{
public:
  SceneOfProcess(vtkRenderer* renderer, const double projection[16])
    : Renderer(renderer)
    , OldProjection(renderer->GetActiveCamera()->GetExplicitProjectionTransformMatrix())
    , OldUse(renderer->GetActiveCamera()->GetUseExplicitProjectionTransformMatrix())
  {
    vtkNew<vtkMatrix4x4> rows;
    CopyTransposed(projection, rows->GetData());
    renderer->GetActiveCamera()->SetExplicitProjectionTransformMatrix(rows);
    renderer->GetActiveCamera()->UseExplicitProjectionTransformMatrixOn();
    renderer->GetViewport(this->Viewport);
    renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
    renderer->GetBackground(this->Background);
    renderer->SetBackground(0.0, 0.0, 0.0);
  }

  ~SceneOfProcess()
  {
    this->Renderer->SetBackground(this->Background);
    this->Renderer->SetViewport(this->Viewport);
    this->Renderer->GetActiveCamera()->SetExplicitProjectionTransformMatrix(this->OldProjection);
    this->Renderer->GetActiveCamera()->SetUseExplicitProjectionTransformMatrix(this->OldUse);
  }

private:
  vtkRenderer* Renderer;
  vtkSmartPointer<vtkMatrix4x4> OldProjection;
  bool OldUse;
  double Viewport[4];
  double Background[3];
};
}

//------------------------------------------------------------------------------
void FloatCompositingPass::Ask(vtkRenderer* renderer, vtkPVDataRepresentation* representation)
{
  vtkCameraPass* camera = FindCameraPass(renderer);
  if (!camera)
  {
    return;
  }
  vtkSmartPointer<FloatCompositingPass> pass = FloatCompositingPass::SafeDownCast(camera->GetDelegatePass());
  if (auto* bytes = vtkIceTCompositePass::SafeDownCast(camera->GetDelegatePass()))
  {
    pass = vtkSmartPointer<FloatCompositingPass>::New();
    pass->Bytes = bytes;
    camera->SetDelegatePass(pass);
  }
  if (pass)
  {
    pass->Representations.emplace_back(representation);
  }
}

//------------------------------------------------------------------------------
// Colours that stand for what is selected are no light; without an order there are no volumes.
bool FloatCompositingPass::IsAsked(const vtkRenderState* state) const
{
  return this->Bytes->GetUseOrderedCompositing() && this->Bytes->GetOrderedCompositingHelper() &&
    !state->GetRenderer()->GetSelector() &&
    std::any_of(this->Representations.begin(), this->Representations.end(),
      [](vtkPVDataRepresentation* one) { return one && one->GetView() && one->GetVisibility(); });
}

//------------------------------------------------------------------------------
void FloatCompositingPass::Render(const vtkRenderState* state)
{
  this->NumberOfRenderedProps = 0;
  if (this->IsAsked(state))
  {
    this->Composite(state);
  }
  else
  {
    this->Bytes->Render(state);
  }
}

//------------------------------------------------------------------------------
void FloatCompositingPass::Composite(const vtkRenderState* state)
{
  Inside::SetUp(this->Bytes, state);
  vtkOpenGLState* opengl = WindowOf(state)->GetState();
  const int* size = WindowOf(state)->GetActualSize();
  const vtkOpenGLState::ScopedglViewport viewport(opengl);
  const vtkOpenGLState::ScopedglScissor scissor(opengl);
  opengl->vtkglViewport(0, 0, size[0], size[1]);
  opengl->vtkglScissor(0, 0, size[0], size[1]);
  icetPhysicalRenderSize(size[0], size[1]);
  Drawing = this;
  this->State = state;
  CopySaturated(DrawFrame(state->GetRenderer()), Inside::Result(this->Bytes));
  this->State = nullptr;
  Drawing = nullptr;
  LogBytes();
  Inside::Show(this->Bytes, state);
}

//------------------------------------------------------------------------------
void FloatCompositingPass::Draw(const double projection[16], int width, int height, float* pixels)
{
  const SceneOfProcess scene(this->State->GetRenderer(), projection);
  this->Target.Begin(WindowOf(this->State));
  this->Bytes->GetRenderPass()->Render(this->State);
  this->Target.End(WindowOf(this->State), width, height, pixels);
}

//------------------------------------------------------------------------------
void FloatCompositingPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Target.Release(window);
  this->Bytes->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}
