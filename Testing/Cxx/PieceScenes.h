// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Four pieces of a volume with the ghost layers that their mappers name, drawn one behind the other, and the whole. A pixel
// differs if bytes can show it.

#ifndef PieceScenes_h
#define PieceScenes_h

#include "TestScene.h"

#include "vtkAmbientCovarianceFilter.h"

#include <functional>

namespace
{
const double Visible = 1.0 / 255.0;
// Rounding of float moves a face by a hundred thousandth of a step: so rarely a sample is in both pieces, or in none.
const double Rare = 1.0e-4;
const int Middle = 13; // of 32 points on each axis: no plane of symmetry

struct Choice
{
  const char* Name;
  std::function<void(TestScene&)> Apply;
};

// Translucent, so that no ray ends early, and dim enough for the target of bytes that nothing here draws into.
inline void SetUp(TestScene& scene, const Choice& choice)
{
  scene.Property->SetScalarOpacityUnitDistance(0.5);
  scene.Property->SetAmbient(0.1);
  scene.Property->SetDiffuse(0.5);
  scene.Property->SetSpecular(0.2);
  scene.Optics->SetFramePrecision(32);
  scene.Optics->GetAmbientCovarianceFilter()->SetScalarRange(0.0, 1.0);
  scene.Optics->GetAmbientCovarianceFilter()->SetRadius(3.0);
  choice.Apply(scene);
}

// How the parts of the whole are made.
struct Cut
{
  int MissingLayers = 0;
  bool KnowsWhole = true;
  bool KnowsPiece = true; // or the input without ghost layers, as VTK's mapper takes it
};

// A scene of four volumes in place of the one, from the farthest to the nearest.
class Pieces
{
public:
  Pieces(const Choice& choice, const Cut& cut)
  {
    SetUp(this->Scene, choice);
    this->Scene.Renderer->RemoveVolume(this->Scene.Volume);
    this->Scene.Source->Update();
    for (int piece = 0; piece < 4; ++piece)
    {
      this->AddPiece(choice, cut, piece % 2 == 1, piece < 2);
    }
  }

  TestScene Scene;

private:
  void AddPiece(const Choice& choice, const Cut& cut, bool isUpperX, bool isUpperY)
  {
    TestScene settings; // of which the mapper and the volume are taken
    SetUp(settings, choice);
    vtkImageData* whole = this->Scene.Source->GetOutput();
    int drawn[6];
    whole->GetExtent(drawn);
    drawn[isUpperX ? 0 : 1] = Middle;
    drawn[isUpperY ? 2 : 3] = Middle;
    const int asked = settings.Optics->GetGhostLayers(settings.Property) - cut.MissingLayers;
    const int layers = cut.KnowsPiece ? asked : 0;
    int extent[6];
    for (int side = 0; side < 6; ++side)
    {
      const int end = whole->GetExtent()[side];
      extent[side] =
        side % 2 == 0 ? std::max(drawn[side] - layers, end) : std::min(drawn[side] + layers, end);
    }
    vtkNew<vtkImageData> image;
    image->DeepCopy(whole);
    image->Crop(extent);
    settings.Optics->SetInputData(image);
    if (vtkImageData* mask = settings.Optics->GetMaskInput())
    {
      vtkNew<vtkImageData> part;
      part->DeepCopy(mask);
      part->Crop(extent);
      settings.Optics->SetMaskInput(part);
    }
    if (cut.KnowsPiece)
    {
      settings.Optics->SetDrawnExtent(drawn);
    }
    if (cut.KnowsPiece && cut.KnowsWhole)
    {
      settings.Optics->SetWholeExtent(whole->GetExtent());
    }
    settings.Renderer->RemoveVolume(settings.Volume);
    this->Scene.Renderer->AddVolume(settings.Volume);
  }
};

inline double ShareOfPixels(const std::vector<float>& a, const std::vector<float>& b)
{
  if (a.size() != b.size() || !AreFinite(a) || !AreFinite(b))
  {
    return 1.0;
  }
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); i += 4)
  {
    different += !std::equal(a.begin() + i, a.begin() + i + 4, b.begin() + i,
      [](float one, float other) { return std::abs(one - other) <= Visible; });
  }
  return 4.0 * static_cast<double>(different) / static_cast<double>(a.size());
}

inline double MeanOfPixels(const std::vector<float>& a, const std::vector<float>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += std::abs(double(a[i]) - double(b[i]));
  }
  return sum / static_cast<double>(a.size());
}

// By default the share of the pixels that differ.
inline double Compare(
  const Choice& choice, const Cut& cut, const std::function<void(TestScene&)>& change = [](TestScene&) {},
  double (*measure)(const std::vector<float>&, const std::vector<float>&) = ShareOfPixels)
{
  TestScene whole;
  SetUp(whole, choice);
  change(whole);
  Pieces pieces(choice, cut);
  change(pieces.Scene);
  return measure(whole.RenderFloat(), pieces.Scene.RenderFloat());
}

inline double MeanDifference(const Choice& choice, const Cut& cut)
{
  return Compare(
    choice, cut, [](TestScene&) {}, MeanOfPixels);
}
}

#endif
