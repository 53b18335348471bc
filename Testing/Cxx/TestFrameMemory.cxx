// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Frames whose data, property, window and terms change keep the memory flat: the heap, the resident set, the mapper's
// textures, and the objects that the driver has.
//
//   vtkVolumeOpticsCxxTests TestFrameMemory [--frames N]
//
// draws N frames (1000 in the long run) and compares the last one with that at a tenth of them, or the 60th.

#include "CommandLine.h"
#include "FreedMemory.h"
#include "SmallScene.h"

#include "vtkLight.h"

#include <fstream>
#include <malloc.h>
#include <unistd.h>

namespace
{
// The frames repeat after so many: a program is linked once, and kept by VTK.
const int Period = 20;

struct Memory
{
  double Heap = 0.0;     // MiB
  double Resident = 0.0; // MiB
  double Terms = 0.0;    // KiB
  int Objects = 0;
};

// Textures, buffers, framebuffers and programs. Names are small numbers, and used again.
int CountObjects()
{
  int count = 0;
  for (GLuint name = 1; name < 20000; ++name)
  {
    count += glIsTexture(name) + glIsBuffer(name) + glIsFramebuffer(name) + glIsRenderbuffer(name) +
      glIsVertexArray(name) + glIsProgram(name) + glIsShader(name);
  }
  return count;
}

Memory Measure(TestScene& scene)
{
  Memory memory;
  const struct mallinfo2 heap = mallinfo2();
  memory.Heap = static_cast<double>(heap.uordblks + heap.hblkhd) / (1024.0 * 1024.0);
  long total = 0;
  long resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  memory.Resident =
    static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
  memory.Terms = static_cast<double>(scene.Optics->GetTermMemorySize());
  memory.Objects = CountObjects();
  return memory;
}

void ChangeProperty(TestScene& scene, int frame)
{
  vtkOpticsVolumeProperty* property = scene.Property;
  property->SetReflectanceModel(frame % 5);
  property->SetIntegrationSpace(frame / 2 % 2);
  property->SetClassification(frame % 4 == 3 ? 1 : 0);
  property->RemoveAllIsosurfaces();
  for (int i = 0; i < frame % 4; ++i)
  {
    property->AddIsosurface(0.4 + 0.1 * i, 0.5);
  }
  property->SetOcclusion(frame % 5 == 1);
  property->SetShadows(frame % 4 == 2);
  property->SetLightingTransferFunction(nullptr);
  if (frame % 4 == 0)
  {
    LightEverywhere(scene, 0.2, 0.7, 0.2);
  }
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(0.4, 0.0);
  scene.Opacity->AddPoint(0.6 + 0.01 * (frame % 10), 0.9);
}

// A new image, another size of it and of the window, another light.
void ChangeScene(TestScene& scene, int frame)
{
  const int size = 8 + 2 * (frame % 5);
  scene.Source->SetDimensions(size, size, size + 1);
  scene.Source->Update();
  vtkNew<vtkImageData> image;
  image->DeepCopy(scene.Source->GetOutput());
  scene.Mapper->SetInputData(image);
  scene.Window->SetSize(16 + 8 * (frame % 4), 16 + 4 * (frame % 5));
  scene.Optics->SetSkipEmptySpace(frame % 2 == 0);
  scene.Renderer->RemoveAllLights();
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(3.0, -2.0, 1.0 + frame % 5);
  scene.Renderer->AddLight(light);
}
}

int TestFrameMemory(int argc, char* argv[])
{
  Check check;
  const int frames = CommandLine(argc, argv).GetNumber("--frames", 0, 120) / Period * Period;
  const int first = std::max(frames / 10, 3 * Period) / Period * Period;
  SmallScene scene;
  scene.Optics->SetVisibilityGridSize(8);
  Memory before;
  for (int frame = 0; frame <= frames; ++frame)
  {
    ChangeProperty(scene, frame);
    ChangeScene(scene, frame);
    scene.Window->Render();
    before = frame == first ? Measure(scene) : before;
  }
  const Memory after = Measure(scene);
  std::cout << "frame " << first << " and " << frames << ": heap " << before.Heap << ", " << after.Heap
            << " MiB; resident " << before.Resident << ", " << after.Resident << " MiB; terms "
            << before.Terms << ", " << after.Terms << " KiB; objects " << before.Objects << ", "
            << after.Objects << "\n";
  if (!FreedMemoryIsKept)
  {
    check.AtMost("MiB that the heap grows by", after.Heap - before.Heap, 2.0);
    check.AtMost("MiB that the resident set grows by", after.Resident - before.Resident, 2.0);
  }
  check.Near("KiB of the terms' textures", after.Terms, before.Terms, 0.0);
  check.Near("objects of OpenGL", after.Objects, before.Objects, 0.0);
  check.AtLeast("objects of OpenGL that are counted", before.Objects, 10.0);
  return check.ExitCode();
}
