// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The analytic fields: exact gradients against finite differences, closed values, range, pieces.

#include "Check.h"

#include "AnalyticFields.h"
#include "vtkAnalyticVolumeSource.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{
Check check;

// Fourth-order differences; their own error bounds the tolerance.
double Difference(const analytic::AnalyticField& field, analytic::Vector p, int axis)
{
  const double h = 1.0e-4;
  auto at = [&](double offset) {
    analytic::Vector moved = p;
    moved[axis] += offset;
    return field.Value(moved);
  };
  return (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
}

void TestGradients()
{
  for (int type = 0; type < analytic::NumberOfFields; ++type)
  {
    analytic::Parameters parameters;
    parameters.axis = { 0.3, -0.5, 0.8 };
    const analytic::AnalyticField field(type, parameters);
    double worst = 0.0;
    for (int n = 0; n < 2000; ++n)
    {
      const analytic::Vector p = { analytic::HashNoise(n, 0, 7, 3), analytic::HashNoise(n, 1, 7, 3),
        analytic::HashNoise(n, 2, 7, 3) };
      const analytic::Dual exact = field.ValueAndGradient(p);
      check.That(exact.value == field.Value(p), "dual and plain values agree");
      for (int axis = 0; axis < 3; ++axis)
      {
        worst = std::max(worst, std::abs(exact.gradient[axis] - Difference(field, p, axis)));
      }
    }
    std::cout << "field " << type << ": largest difference from finite differences " << worst << "\n";
    // the noise bends a thousand times as sharply as the other fields
    check.That(worst < (type == analytic::NoisyHomogeneousField ? 5.0e-4 : 2.0e-5),
      "gradient agrees with finite differences");
  }
}

void TestClosedValues()
{
  using analytic::AnalyticField;
  auto near = [](double a, double b) { return std::abs(a - b) < 1.0e-14; };
  const AnalyticField signal(analytic::MarschnerLobbField);
  // at the origin cos(12 pi) = 1: (1 + 1/4 * 2)/(5/2)
  check.That(near(signal.Value({ 0.0, 0.0, 0.0 }), 0.6), "Marschner-Lobb at the origin");
  check.That(near(signal.Value({ 0.0, 0.0, 1.0 }), 0.2), "Marschner-Lobb at the top");
  const AnalyticField sphere(analytic::SphereField);
  check.That(near(sphere.Value({ 0.3, 0.4, 0.0 }), 0.5), "one half on the sphere");
  const AnalyticField ellipsoid(analytic::EllipsoidField);
  check.That(near(ellipsoid.Value({ 0.0, 0.0, 0.8 }), 0.5), "one half on the ellipsoid");
  const AnalyticField cylinder(analytic::CylinderField);
  check.That(near(cylinder.Value({ 0.3, 0.4, -0.9 }), 0.5), "one half on the cylinder");
  const AnalyticField torus(analytic::TorusField);
  check.That(near(torus.Value({ 0.5, 0.0, 0.2 }), 0.5), "one half on the torus");
  const AnalyticField ramp(analytic::LinearRampField);
  check.That(near(ramp.Value({ 0.2, 0.3, 0.5 }), 0.75), "the ramp");
  analytic::Parameters weak;
  weak.strength = 0.05;
  const AnalyticField charge(analytic::CoulombPotentialField);
  const AnalyticField weakCharge(analytic::CoulombPotentialField, weak);
  check.That(near(charge.Value({ 0.0, 0.0, 0.0 }), 1.0), "the charge");
  check.That(near(charge.Value({ 0.0, 0.0, 0.2 * std::sqrt(3.0) }), 0.5), "one half near the charge");
  check.That(near(charge.Value({ 0.4, -0.8, 0.2 }), weakCharge.Value({ 0.1, -0.2, 0.05 })), "a scaled copy");
  const AnalyticField orbital(analytic::HydrogenOrbitalField);
  check.That(near(orbital.Value({ 0.0, 0.0, -0.5 }), 1.0), "the largest density of 3d_z2");
  check.That(near(orbital.Value({ 0.5, 0.0, 0.0 }), 0.25), "the ring has a quarter of it");
  const double node = 0.3; // z^2 = r^2/3
  check.That(near(orbital.Value({ node, node, node }), 0.0), "no density on the cone between them");
  const AnalyticField ball(analytic::BuckyballField);
  const std::vector<analytic::Vector> atoms = analytic::MakeBuckyball(0.5);
  check.That(atoms.size() == 60, "60 atoms");
  for (const analytic::Vector& atom : atoms)
  {
    check.That(near(atom[0] * atom[0] + atom[1] * atom[1] + atom[2] * atom[2], 0.25), "on a sphere");
    check.That(near(ball.Value(atom), 1.0), "1 at an atom");
  }
  check.That(near(ball.Value({ 0.0, 0.0, 0.0 }), 0.0), "an empty middle");
}

void TestRanges()
{
  for (int type = 0; type < vtkAnalyticVolumeSource::NumberOfFields; ++type)
  {
    vtkNew<vtkAnalyticVolumeSource> source;
    source->SetField(type);
    source->Update();
    double range[2];
    source->GetOutput()->GetScalarRange(range);
    std::cout << source->GetFieldAsString() << ": [" << range[0] << ", " << range[1] << "]\n";
    check.That(range[0] >= 0.0 && range[1] <= 1.0 && range[0] < range[1], "scalars in [0, 1]");
  }
}

// A piece equals the same part of the whole, bit for bit.
void TestPieces()
{
  vtkNew<vtkAnalyticVolumeSource> source;
  source->SetFieldToVortexTubes();
  source->SetDimensions(33, 21, 17);
  source->Update();
  vtkNew<vtkImageData> whole;
  whole->DeepCopy(source->GetOutput());
  source->Modified();
  int extent[6] = { 5, 20, 3, 11, 8, 16 };
  source->UpdateExtent(extent);
  vtkImageData* piece = source->GetOutput();
  int same = 0;
  for (int z = extent[4]; z <= extent[5]; ++z)
  {
    for (int y = extent[2]; y <= extent[3]; ++y)
    {
      for (int x = extent[0]; x <= extent[1]; ++x)
      {
        same +=
          piece->GetScalarComponentAsDouble(x, y, z, 0) == whole->GetScalarComponentAsDouble(x, y, z, 0);
      }
    }
  }
  check.That(same == 16 * 9 * 9, "a piece equals the whole");
  check.That(piece->GetNumberOfPoints() == 16 * 9 * 9, "a piece is no larger than asked for");
}

void TestTypes()
{
  const int types[] = { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT,
    VTK_UNSIGNED_INT, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG, VTK_FLOAT, VTK_DOUBLE };
  for (int type : types)
  {
    vtkNew<vtkAnalyticVolumeSource> source;
    source->SetFieldToLinearRamp();
    source->SetDimensions(1, 1, 3);
    source->SetOutputScalarType(type);
    source->Update();
    vtkImageData* output = source->GetOutput();
    check.That(output->GetScalarType() == type, "the scalar type asked for");
    const double top = output->GetScalarComponentAsDouble(0, 0, 2, 0);
    const double middle = output->GetScalarComponentAsDouble(0, 0, 1, 0);
    check.That(output->GetScalarComponentAsDouble(0, 0, 0, 0) == 0.0, "0 at the bottom");
    check.That(type >= VTK_FLOAT && type <= VTK_DOUBLE ? top == 1.0 : top >= 127.0, "the range's end");
    check.That(std::abs(middle - top / 2.0) <= 0.5, "one half in the middle");
  }
}

struct Progress
{
  int events = 0;
  int abortAt = 1000;
};

void Advance(vtkObject* caller, unsigned long, void* data, void*)
{
  auto* progress = static_cast<Progress*>(data);
  if (++progress->events == progress->abortAt)
  {
    static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
  }
}

void TestProgressAndAbort()
{
  for (int abortAt : { 1000, 3 })
  {
    Progress progress;
    progress.abortAt = abortAt;
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(Advance);
    command->SetClientData(&progress);
    vtkNew<vtkAnalyticVolumeSource> source;
    source->AddObserver(vtkCommand::ProgressEvent, command);
    source->Update();
    check.That(abortAt == 3 ? progress.events <= 5 : progress.events >= 20, "progress and abort");
  }
}
}

int TestAnalyticVolumeSource(int, char*[])
{
  TestGradients();
  TestClosedValues();
  TestRanges();
  TestPieces();
  TestTypes();
  TestProgressAndAbort();
  return check.ExitCode();
}
