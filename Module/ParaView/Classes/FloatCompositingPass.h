// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// ParaView composites the pictures of several processes in bytes, by sums that begin at 0 again behind 255; and what is
// brighter than it is opaque, as light on volumes may be, passes 255. This pass stands before ParaView's own: where a
// representation asks for it, pictures are drawn and composited by IceT in float and saturate in the end, as the bytes
// of a single process do. It takes four times the bytes to be exchanged.

#ifndef FloatCompositingPass_h
#define FloatCompositingPass_h

#include "FloatTarget.h"

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <vector>

class vtkIceTCompositePass;
class vtkPVDataRepresentation;
class vtkRenderer;

class FloatCompositingPass : public vtkRenderPass
{
public:
  static FloatCompositingPass* New();
  vtkTypeMacro(FloatCompositingPass, vtkRenderPass);

  /** While the representation is visible the renderer's pictures are composited in float; nothing where they are not
   * composited by IceT. All processes must ask alike. */
  static void Ask(vtkRenderer* renderer, vtkPVDataRepresentation* representation);

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /** Draws this process's picture: IceT calls back without an object. */
  void Draw(const double projection[16], int width, int height, float* pixels);

protected:
  FloatCompositingPass() = default;
  ~FloatCompositingPass() override = default;

private:
  FloatCompositingPass(const FloatCompositingPass&) = delete;
  void operator=(const FloatCompositingPass&) = delete;

  bool IsAsked(const vtkRenderState* state) const;
  void Composite(const vtkRenderState* state);

  vtkSmartPointer<vtkIceTCompositePass> Bytes; // ParaView's own, and what it was told
  std::vector<vtkWeakPointer<vtkPVDataRepresentation>> Representations;
  const vtkRenderState* State = nullptr; // while IceT draws
  FloatTarget Target;
};

#endif
