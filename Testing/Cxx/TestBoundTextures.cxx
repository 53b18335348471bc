// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The textures bound while a volume is drawn are counted twice: texture units that VTK lends out at the
// same time, and texture units at which the driver has a texture after the frame. With every setting at
// its default both counts are those of VTK's own mapper; with a model they are higher by the textures
// that the model is documented to have, which shows that the counters see them.

#include "TestScene.h"
#include "vtkAmbientCovarianceFilter.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureUnitManager.h"

#include <functional>
#include <set>

namespace
{
// Lends texture units as VTK does, and remembers how many were out at once.
class CountedTextureUnits : public vtkTextureUnitManager
{
public:
  static CountedTextureUnits* New();
  vtkTypeMacro(CountedTextureUnits, vtkTextureUnitManager);

  using vtkTextureUnitManager::Allocate;
  int Allocate() override
  {
    const int unit = this->Superclass::Allocate();
    this->Lent.insert(unit);
    this->Most = std::max(this->Most, this->GetNumberOfLentUnits());
    return unit;
  }
  void Free(int unit) override
  {
    this->Lent.erase(unit);
    this->Superclass::Free(unit);
  }

  // Forgets the peak of the frames before.
  void StartFrame() { this->Most = this->GetNumberOfLentUnits(); }
  int GetMostLentUnits() const { return this->Most; }
  int GetNumberOfLentUnits() const { return static_cast<int>(this->Lent.size()); }

protected:
  CountedTextureUnits() = default;
  ~CountedTextureUnits() override = default;

private:
  CountedTextureUnits(const CountedTextureUnits&) = delete;
  void operator=(const CountedTextureUnits&) = delete;

  int Most = 0;
  std::set<int> Lent;
};
vtkStandardNewMacro(CountedTextureUnits);

struct Count
{
  int Lent;  // units lent out at once during the frame
  int Bound; // units with a texture after it
  int Kept;  // units that are not given back after it

  bool operator==(const Count& other) const
  {
    return this->Lent == other.Lent && this->Bound == other.Bound && this->Kept == other.Kept;
  }
  Count operator+(int textures) const
  {
    return { this->Lent + textures, this->Bound + textures, this->Kept };
  }
};

std::string Text(const Count& count)
{
  return std::to_string(count.Lent) + " lent, " + std::to_string(count.Bound) + " bound, " +
    std::to_string(count.Kept) + " kept";
}

bool IsBound(GLenum unit)
{
  glActiveTexture(unit);
  for (const GLenum target : { GL_TEXTURE_BINDING_1D, GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_3D,
         GL_TEXTURE_BINDING_BUFFER, GL_TEXTURE_BINDING_CUBE_MAP, GL_TEXTURE_BINDING_2D_ARRAY,
         GL_TEXTURE_BINDING_RECTANGLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE })
  {
    GLint texture = 0;
    glGetIntegerv(target, &texture);
    if (texture != 0)
    {
      return true;
    }
  }
  return false;
}

// Counts from the first frame of the volume on.
class TextureCounter
{
public:
  explicit TextureCounter(TestScene& scene)
    : Scene(scene)
    , Window(vtkOpenGLRenderWindow::SafeDownCast(scene.Window))
  {
    scene.Volume->VisibilityOff();
    scene.Window->Render(); // makes the context
    this->Units->Initialize();
    this->Window->GetState()->SetTextureUnitManager(this->Units);
    scene.Volume->VisibilityOn();
  }

  Count CountFrame()
  {
    this->Units->StartFrame();
    this->Scene.Window->Render();
    this->Window->MakeCurrent();
    GLint active = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    int bound = 0;
    for (int unit = 0; unit < this->Units->GetNumberOfTextureUnits(); ++unit)
    {
      bound += IsBound(GL_TEXTURE0 + unit);
    }
    glActiveTexture(active);
    return { this->Units->GetMostLentUnits(), bound, this->Units->GetNumberOfLentUnits() };
  }

private:
  TestScene& Scene;
  vtkOpenGLRenderWindow* Window;
  vtkNew<CountedTextureUnits> Units;
};

using Setting = std::function<void(TestScene&)>;

Count CountStock(const Setting& setting)
{
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  TestScene scene(mapper);
  setting(scene);
  return TextureCounter(scene).CountFrame();
}

// Another frame, of another camera: what the first one leaves behind must not add up.
void CheckFrames(Check& check, const std::string& name, TestScene& scene, const Count& expected)
{
  TextureCounter counter(scene);
  for (const char* frame : { "first", "second" })
  {
    const Count count = counter.CountFrame();
    check.That(count == expected, name + ", " + frame + " frame: " + Text(count) + ", not " + Text(expected));
    scene.Renderer->GetActiveCamera()->Azimuth(10.0);
  }
}

struct Row
{
  const char* Name;
  Setting Apply;
};

const Row Defaults[] = {
  { "shaded", [](TestScene&) {} },
  { "not shaded", [](TestScene& scene) { scene.Property->ShadeOff(); } },
  { "maximum intensity", [](TestScene& scene) { scene.Mapper->SetBlendModeToMaximumIntensity(); } },
  { "gradient opacity",
    [](TestScene& scene) {
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(0.0, 0.0);
      opacity->AddPoint(1.0, 1.0);
      scene.Property->SetGradientOpacity(opacity);
    } },
  { "jitter", [](TestScene& scene) { scene.Mapper->SetUseJittering(1); } },
};

struct ModelRow
{
  const char* Name;
  Setting Apply;
  int Textures; // of the term, beside VTK's
};

// Normals and the scalar's opacities; an anisotropic model has the frames, too. A sweep along eight directions
// reads two textures, and then the picture reads what it found.
const ModelRow Models[] = {
  { "None", [](TestScene& scene) { scene.Property->SetReflectanceModelToNone(); }, 0 },
  { "Blinn-Phong", [](TestScene& scene) { scene.Property->SetReflectanceModelToBlinnPhong(); }, 2 },
  { "Ward", [](TestScene& scene) { scene.Property->SetReflectanceModelToWard(); }, 3 },
  { "Ward, frames in world axes",
    [](TestScene& scene) {
      scene.Property->SetReflectanceModelToWard();
      scene.Optics->GetAmbientCovarianceFilter()->SetStorageToWorld();
    },
    4 },
  // gathering looks at the opacity function as it is, not at VTK's table for the step
  { "occlusion", [](TestScene& scene) { scene.Property->OcclusionOn(); }, 3 },
  { "occlusion, not gathered",
    [](TestScene& scene) {
      scene.Property->OcclusionOn();
      scene.Optics->SetVisibilityGatherSamples(0);
    },
    2 },
};

// A term that was there and is switched off holds no texture unit.
void CheckSwitchedOff(Check& check, const Count& stock)
{
  TestScene scene;
  TextureCounter counter(scene);
  scene.Property->SetReflectanceModelToWard();
  counter.CountFrame();
  scene.Property->SetReflectanceModelToVTK();
  const int lent = counter.CountFrame().Lent;
  check.That(lent == stock.Lent,
    "Ward, then VTK: " + std::to_string(lent) + " units lent, not " + std::to_string(stock.Lent));
}
}

int TestBoundTextures(int, char*[])
{
  Check check;
  for (const Row& row : Defaults)
  {
    const Count stock = CountStock(row.Apply);
    check.AtLeast(std::string(row.Name) + ": textures of VTK's own mapper", stock.Lent, 1);
    TestScene scene;
    row.Apply(scene);
    CheckFrames(check, row.Name, scene, stock);
  }
  const Count stock = CountStock(Defaults[0].Apply);
  for (const ModelRow& row : Models)
  {
    TestScene scene;
    row.Apply(scene);
    CheckFrames(check, row.Name, scene, stock + row.Textures);
  }
  CheckSwitchedOff(check, stock);
  return check.ExitCode();
}
