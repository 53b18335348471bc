// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Scenes at random whose small gradients are hidden: the picture is that without skipping, which pays in some of them.
// Arguments: --seed (the first scene's), --scenes (their number).

#include "GradientScene.h"

namespace
{
class RandomGradients
{
public:
  explicit RandomGradients(unsigned int seed)
    : Random(seed)
  {
  }

  void Apply(TestScene& scene)
  {
    const int type = Types[this->Below(std::size(Types))];
    const std::vector<int> size = { this->Size(), this->Size(), this->Size() };
    const vtkSmartPointer<vtkImageData> image = MakeImage(this->Field(), type, size, this->Between(0.2, 1.5));
    UseImage(scene, image);
    const double magnitude = FindMagnitude(image, this->Between(0.85, 0.99));
    if (this->Below(2) == 0)
    {
      HideGradientsBelow(scene, magnitude);
    }
    else
    {
      Use2D(scene, 2 + this->Below(600), 2 + this->Below(1500), magnitude);
    }
    scene.Optics->SetMacrocellSize(2 + this->Below(2));
    scene.Mapper->SetSampleDistance(static_cast<float>(this->Between(0.01, 0.08)));
    scene.Property->SetShade(this->Below(2));
    scene.Renderer->GetActiveCamera()->Azimuth(this->Between(0.0, 360.0));
    scene.Renderer->GetActiveCamera()->Elevation(this->Between(-60.0, 60.0));
    scene.Renderer->ResetCameraClippingRange();
  }

private:
  int Below(std::size_t number) { return static_cast<int>(this->Random() % number); }
  double Between(double low, double high) { return low + (high - low) * (this->Random() / 4294967295.0); }
  int Size() { return 2 + this->Below(this->Below(6) == 0 ? 6 : 46); }

  // A wave of which the crests alone are left, and noise on one side.
  GradientField Field()
  {
    const double frequency = this->Between(0.5, 5.0), phase = this->Between(0.0, 6.0),
                 noise = this->Between(0.0, 0.3), border = this->Between(0.4, 1.2),
                 contrast = this->Between(0.02, 1.0), flat = this->Between(0.7, 0.97);
    const auto at = [=, random = std::mt19937(this->Random())](const double place[3]) mutable {
      const double wave =
        0.5 + 0.5 * std::sin(frequency * (place[0] + 0.6 * place[1] - 0.4 * place[2]) + phase);
      const double rough = place[2] > border ? noise * (random() / 4294967296.0 - 0.5) : 0.0;
      return contrast * (std::max(wave, flat) + rough);
    };
    return { "random", at };
  }

  std::mt19937 Random;
};

int Read(int argc, char* argv[], const std::string& name, int otherwise)
{
  const auto found = std::find(argv, argv + argc, name);
  return found < argv + argc - 1 ? std::stoi(found[1]) : otherwise;
}
}

int TestEmptySpaceGradientsAtRandom(int argc, char* argv[])
{
  Check check;
  const int first = Read(argc, argv, "--seed", 1), scenes = Read(argc, argv, "--scenes", 40);
  int skipping = 0;
  for (int seed = first; seed < first + scenes; ++seed)
  {
    SkippingScene scene;
    RandomGradients(seed).Apply(scene);
    const std::vector<unsigned char> with = scene.Render();
    skipping += Skips(scene.Optics) ? 1 : 0;
    scene.Optics->SkipEmptySpaceOff();
    check.That(with == scene.Render(), "seed " + std::to_string(seed) + ": the picture differs");
  }
  check.AtLeast("scenes that skip, of " + std::to_string(scenes), skipping, 0.1 * scenes);
  return check.ExitCode();
}
