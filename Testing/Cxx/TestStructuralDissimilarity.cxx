// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The structural score on synthetic pictures alone: it is fixed here, before it meets a rendering.

#include "Check.h"

#include "AnalyticFields.h"
#include "vtkStructuralDissimilarity.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <string>

namespace
{
Check check;

using Picture = std::function<double(int, int)>;
const int Size = 128;

vtkSmartPointer<vtkImageData> MakeImage(
  const Picture& luminance, int width = Size, int height = Size, int type = VTK_FLOAT, int components = 1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(type, components);
  const double white = type == VTK_UNSIGNED_CHAR ? 255.0 : 1.0;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (int c = 0; c < components; ++c)
      {
        image->SetScalarComponentFromDouble(
          x, y, 0, c, std::round(luminance(x, y) * 65280.0) / 65280.0 * white);
      }
    }
  }
  return image;
}

double Score(vtkImageData* reference, vtkImageData* picture, int scales = 5, double weight = 1.0)
{
  vtkNew<vtkStructuralDissimilarity> measure;
  measure->SetReferenceData(reference);
  measure->SetPictureData(picture);
  measure->SetNumberOfScales(scales);
  measure->SetHomogeneityWeight(weight);
  measure->Update();
  return measure->GetScore();
}

double Flat(int, int)
{
  return 0.4;
}
double Ramp(int x, int y)
{
  return 0.1 + 0.5 * (x + 0.3 * y) / (1.3 * Size);
}
double ShadedBall(int x, int y)
{
  const double u = (x - 63.5) / 50.0;
  const double v = (y - 63.5) / 50.0;
  const double z2 = 1.0 - u * u - v * v;
  return z2 > 0.0 ? 0.1 + 0.5 * std::sqrt(z2) : 0.0;
}
double Texture(int x, int y)
{
  return 0.4 + 0.15 * analytic::LatticeNoise<double>({ x + 0.5, y + 0.5, 0.5 }, 9.0, 5);
}

// Highlights drawn out along curves: `count` bent streaks, 4 pixels wide and 90 long, placed from the
// middle outwards so that the first lie on the ball.
double Streaks(int x, int y, int count)
{
  double sum = 0.0;
  for (int n = 0; n < count; ++n)
  {
    const int fromMiddle = (n + 1) / 2;
    const double place = fromMiddle * (n % 2 ? 12.5 : -12.5);
    const double middle = 63.5 + place + 6.0 * std::sin(y / 18.0 + n);
    const double across = (x - middle) / 2.0;
    const double along = (y - 63.5) / 45.0;
    sum += std::abs(along) < 1.0 ? std::exp(-across * across) * (1.0 - along * along) : 0.0;
  }
  return sum;
}

double Energy(const Picture& added)
{
  double sum = 0.0;
  for (int i = 0; i < Size * Size; ++i)
  {
    const double value = added(i % Size, i / Size);
    sum += value * value;
  }
  return sum;
}

double WhiteNoise(int x, int y)
{
  return analytic::HashNoise(x, y, 11, 3);
}

Picture Sum(const Picture& a, const Picture& b, double factor)
{
  return [a, b, factor](int x, int y) { return a(x, y) + factor * b(x, y); };
}

struct Named
{
  const char* name;
  Picture picture;
};
const Named References[] = { { "flat", Flat }, { "ramp", Ramp }, { "shaded ball", ShadedBall },
  { "texture", Texture } };

void TestIdentity()
{
  for (const Named& reference : References)
  {
    for (int type : { VTK_FLOAT, VTK_DOUBLE, VTK_UNSIGNED_CHAR })
    {
      auto image = MakeImage(reference.picture, Size, Size, type, 3);
      auto same = MakeImage(reference.picture, Size, Size, type, 3);
      check.That(Score(image, same) == 0.0, std::string("identical pictures score 0: ") + reference.name);
    }
  }
}

// The requirement that gives the measure its scales: streaks above noise of the same energy, at
// every strength that leaves the picture in [0, 1], in every surrounding. The noise covers all of it.
void TestStructureAboveNoise()
{
  for (const Named& reference : References)
  {
    auto image = MakeImage(reference.picture);
    for (int count : { 1, 3, 8 })
    {
      const Picture streaks = [count](int x, int y) { return Streaks(x, y, count); };
      const double equalEnergy = std::sqrt(Energy(streaks) / Energy(WhiteNoise));
      for (double strength : { 0.02, 0.05, 0.1, 0.2, 0.4 })
      {
        const double structure = Score(image, MakeImage(Sum(reference.picture, streaks, strength)));
        const double noise =
          Score(image, MakeImage(Sum(reference.picture, WhiteNoise, strength * equalEnergy)));
        std::cout << reference.name << ", " << count << " streaks of " << strength << ": structure "
                  << structure << ", noise " << noise << "\n";
        check.That(structure > noise, "structure scores above noise of the same energy");
      }
    }
  }
}

void TestMonotone()
{
  for (const Named& reference : References)
  {
    auto image = MakeImage(reference.picture);
    double former = 0.0;
    for (double strength : { 0.01, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8 })
    {
      const Picture streaks = [](int x, int y) { return Streaks(x, y, 5); };
      const double score = Score(image, MakeImage(Sum(reference.picture, streaks, strength)));
      check.That(score > former, std::string("stronger streaks score higher: ") + reference.name);
      former = score;
    }
    former = 0.0;
    for (int count = 1; count <= 8; ++count)
    {
      const Picture streaks = [count](int x, int y) { return Streaks(x, y, count); };
      const double score = Score(image, MakeImage(Sum(reference.picture, streaks, 0.3)));
      check.That(score > former, std::string("more streaks score higher: ") + reference.name);
      former = score;
    }
  }
}

void TestRange()
{
  auto texture = MakeImage(Texture);
  auto inverse = MakeImage([](int x, int y) { return 0.8 - Texture(x, y); });
  const double score = Score(texture, inverse);
  check.That(score > 0.5 && score <= 1.0, "the inverse scores above one half, at most 1");
  auto brighter = MakeImage([](int x, int y) { return Texture(x, y) + 0.25; });
  check.That(Score(texture, brighter) < 1.0e-9, "brightness is not structure");
  auto flat = MakeImage(Flat);
  auto black = MakeImage([](int, int) { return 0.0; });
  check.That(Score(flat, black) < 1.0e-9, "constant pictures have the same structure");
  check.That(Score(flat, texture, 5, 0.0) < 1.0e-5, "without weight a homogeneous reference is blind");
  check.That(Score(flat, texture) > 0.1, "with it, structure in a homogeneous reference counts");
}

void TestSizesAndTypes()
{
  const int sizes[][2] = { { 1, 1 }, { 1, 7 }, { 2, 2 }, { 3, 1 }, { 5, 17 }, { 33, 64 } };
  for (const auto& size : sizes)
  {
    auto a = MakeImage(Texture, size[0], size[1]);
    auto b = MakeImage(ShadedBall, size[0], size[1]);
    const double score = Score(a, b);
    check.That(score >= 0.0 && score <= 1.0, "any size gives a score in [0, 1]");
    check.That(Score(a, a) == 0.0, "identical pictures of any size");
  }
  auto gray = MakeImage(Texture);
  const double expected = Score(gray, MakeImage(ShadedBall));
  for (int components : { 2, 3, 4 })
  {
    const double score = Score(gray, MakeImage(ShadedBall, Size, Size, VTK_UNSIGNED_CHAR, components));
    check.That(std::abs(score - expected) < 5.0e-3, "components and types agree to their quantisation");
  }
  auto broken = MakeImage(Texture);
  broken->SetScalarComponentFromDouble(7, 7, 0, 0, std::numeric_limits<double>::quiet_NaN());
  check.That(std::isfinite(Score(gray, broken)), "a value that is not a number does not spread");
}

void TestMap()
{
  vtkNew<vtkStructuralDissimilarity> measure;
  measure->SetReferenceData(MakeImage(Flat));
  measure->SetPictureData(
    MakeImage([](int x, int y) { return 0.4 + (x > 90 ? 0.2 * WhiteNoise(x, y) : 0.0); }));
  measure->Update();
  vtkImageData* map = measure->GetOutput();
  check.That(map->GetDimensions()[0] == Size && map->GetDimensions()[1] == Size, "a map of the same size");
  const double far = map->GetScalarComponentAsDouble(5, 60, 0, 0);
  const double near = map->GetScalarComponentAsDouble(115, 60, 0, 0);
  check.That(near > 0.05 && far < 0.01 * near, "the map shows where something was added");
}

void Count(vtkObject*, unsigned long, void* count, void*)
{
  ++*static_cast<int*>(count);
}

// Pictures of different size: an error, and no score.
void TestErrors()
{
  int errors = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetCallback(Count);
  counter->SetClientData(&errors);
  vtkNew<vtkStructuralDissimilarity> measure;
  measure->AddObserver(vtkCommand::ErrorEvent, counter);
  measure->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, counter);
  measure->SetReferenceData(MakeImage(Flat, 8, 8));
  measure->SetPictureData(MakeImage(Flat, 8, 9));
  measure->Update();
  check.That(errors > 0 && measure->GetScore() == -1.0, "pictures of different size are an error");
}

void TestProgress()
{
  int events = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetCallback(Count);
  counter->SetClientData(&events);
  vtkNew<vtkStructuralDissimilarity> measure;
  measure->AddObserver(vtkCommand::ProgressEvent, counter);
  measure->SetReferenceData(MakeImage(Ramp));
  measure->SetPictureData(MakeImage(Texture));
  measure->Update();
  check.That(events >= 20, "progress is told");
}
}

int TestStructuralDissimilarity(int, char*[])
{
  TestIdentity();
  TestStructureAboveNoise();
  TestMonotone();
  TestRange();
  TestSizesAndTypes();
  TestMap();
  TestErrors();
  TestProgress();
  return check.ExitCode();
}
