// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Clipping shares the length among the voxels; the result does not depend on order, pieces, threads; types,
// radii and colours by arrays; tolerance; a saved file gives the same picture without the lines.

#include "LineTesting.h"

#include "vtkAnalyticLineSource.h"
#include "vtkCamera.h"
#include "vtkExecutive.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"

#include <fstream>

namespace
{
vtkSmartPointer<vtkImageData> Copy(vtkAnisotropicLineVoxelizer* voxelizer)
{
  voxelizer->Update();
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->DeepCopy(voxelizer->GetOutput());
  return copy;
}

// The depth of degree 0, summed over all voxels, is that of the lengths within the box: 2 r l/(S/4), its mean
// over directions pi/4, times sqrt(4 pi).
void CheckLengths(Check& check)
{
  RandomDirections random(11);
  for (const glm::ivec3& size : { glm::ivec3(1), glm::ivec3(13, 8, 21), glm::ivec3(64, 1, 3) })
  {
    vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
    voxelizer->SetSampleDimensions(size.x, size.y, size.z);
    voxelizer->SetModelBounds(-1.0, 2.0, 0.0, 1.0, 0.0, 0.5);
    voxelizer->SetRadius(1e-4);
    voxelizer->ExactProductOff();
    voxelizer->SetMaximumOrder(2);
    std::vector<lines::Line> all;
    double length = 0.0;
    for (int i = 0; i < 200; ++i)
    {
      const glm::dvec3 a(random.Uniform(-1.0, 2.0), random.Uniform(), random.Uniform(0.0, 0.5));
      glm::dvec3 b(random.Uniform(-1.0, 2.0), random.Uniform(), random.Uniform(0.0, 0.5));
      b = i % 7 == 0 ? glm::dvec3(b.x, a.y, a.z) : b; // along an axis
      length += glm::length(b - a);
      // and on beyond the box: what lies outside does not count
      const bool leaves = i % 5 == 0;
      all.push_back({ a, b });
      if (leaves)
      {
        const glm::dvec3 top(a.x, a.y, 0.5);
        length += 0.5 - a.z;
        all.push_back({ a, top + glm::dvec3(0.0, 0.0, 7.0) });
      }
    }
    voxelizer->SetInputData(lines::MakeLines(all));
    voxelizer->Update();
    std::string error;
    const volumeoptics::LineVoxels voxels(voxelizer->GetOutput(), error);
    double sum = 0.0;
    for (vtkIdType v = 0; v < lines::CountOf(voxelizer->GetOutput(), "LineType0_Places"); ++v)
    {
      sum += voxels.Types[0].Values[4 * voxels.Types[0].VoxelStarts[v] + 3];
    }
    const double pi = TwoPi / 2.0;
    const double wanted = 2e-4 * length / (voxels.Grid.Surface() / 4.0) * pi / 4.0 * std::sqrt(4.0 * pi);
    check.Near("length", sum, wanted, 1e-5 * wanted); // roundings of float
  }
}

void CheckOrderPiecesAndThreads(Check& check)
{
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetSampleDimensions(20, 30, 16);
  voxelizer->SetCoefficientTolerance(0.0);
  std::vector<lines::Line> all = lines::RandomLines(20000, 5);
  voxelizer->SetInputData(lines::MakeLines(all));
  voxelizer->SetModelBounds(0.0, 1.0, 0.0, 1.0, 0.0, 1.0);
  const auto whole = Copy(voxelizer);
  std::reverse(all.begin(), all.end());
  voxelizer->SetInputData(lines::MakeLines(all));
  check.AtMost("order of the lines", lines::Difference(whole, Copy(voxelizer)), 1e-6);
  const auto forward = Copy(voxelizer);
  for (int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false }, [&]() {
      voxelizer->Modified();
      check.Near("threads", lines::Difference(forward, Copy(voxelizer)), 0.0, 0.0);
    });
  }

  vtkNew<vtkAnalyticLineSource> source;
  source->SetNumberOfSegments(30001);
  vtkNew<vtkAnisotropicLineVoxelizer> streaming;
  streaming->SetInputConnection(source->GetOutputPort());
  streaming->SetSampleDimensions(32, 32, 32);
  streaming->SetCoefficientTolerance(0.0);
  const auto one = Copy(streaming);
  check.AtLeast("voxels", lines::CountOf(one, "LineType0_Places"), 500.0);
  for (bool bounded : { false, true })
  {
    streaming->SetNumberOfPieces(7);
    const double* bounds = source->GetOutput()->GetBounds();
    source->UpdatePiece(0, 1, 0);
    double whole6[6];
    source->GetOutput()->GetBounds(whole6);
    bounded ? streaming->SetModelBounds(whole6) : streaming->SetModelBounds(1.0, -1.0, 1.0, -1.0, 1.0, -1.0);
    check.That(bounds != nullptr, "bounds");
    check.AtMost("pieces", lines::Difference(one, Copy(streaming)), 1e-6);
  }
  // as a part of a pipeline
  vtkNew<vtkAnisotropicVoxelEvaluator> evaluator;
  vtkNew<vtkCamera> camera;
  evaluator->SetCamera(camera);
  streaming->SetNumberOfPieces(3);
  evaluator->SetInputConnection(streaming->GetOutputPort());
  evaluator->Update();
  check.AtMost("pieces within a pipeline", lines::Difference(one, streaming->GetOutput()), 1e-6);
}

// Two types beside each other with radius and colour of the cells.
void CheckArrays(Check& check)
{
  auto data =
    lines::MakeLines({ { { 0.2, 0.5, 0.5 }, { 0.8, 0.5, 0.5 } }, { { 0.5, 0.2, 0.5 }, { 0.5, 0.8, 0.5 } } });
  vtkNew<vtkIntArray> types;
  types->SetName("Kind");
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Thickness");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Paint");
  colors->SetNumberOfComponents(3);
  for (int i = 0; i < 2; ++i)
  {
    types->InsertNextValue(i == 0 ? 7 : 3);
    radii->InsertNextValue(0.01 * (i + 1));
    const unsigned char paint[3] = { static_cast<unsigned char>(i == 0 ? 255 : 0), 51, 102 };
    colors->InsertNextTypedTuple(paint);
  }
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(types), static_cast<vtkDataArray*>(radii),
         static_cast<vtkDataArray*>(colors) })
  {
    data->GetCellData()->AddArray(array);
  }
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  lines::SetUnitVoxel(voxelizer);
  voxelizer->SetInputData(data);
  voxelizer->SetLineTypeArray("Kind");
  voxelizer->SetRadiusArray("Thickness");
  voxelizer->SetColorArray("Paint");
  vtkNew<vtkProperty> material;
  material->SetAmbient(1.0);
  material->SetDiffuse(0.0);
  voxelizer->SetMaterial(3, material);
  voxelizer->SetMaterial(7, material);
  voxelizer->SetMaximumOrder(8);
  voxelizer->Update();
  std::string error;
  const volumeoptics::LineVoxels voxels(voxelizer->GetOutput(), error);
  check.That(error.empty() && voxels.Types.size() == 2, "two types: " + error);
  if (voxels.Types.size() != 2)
  {
    return;
  }
  double basis[volumeoptics::HarmonicBasis::LargestCount];
  volumeoptics::HarmonicBasis(8, false).Evaluate({ 0.0, 0.0, 1.0 }, basis);
  for (const volumeoptics::LineCoefficients& set : voxels.Types)
  {
    const auto voxel = volumeoptics::EvaluateVoxel(set, 0, basis, { 2.0, 1.0 });
    const double radius = set.Type == 7 ? 0.01 : 0.02;
    check.Near(
      "depth by radius and its scale", voxel.Depth, 2.0 * 2.0 * radius * 0.6 / 1.5, 1e-2 * voxel.Depth);
    check.Near("red", voxel.Color.x, set.Type == 7 ? 1.0 : 0.0, 1e-6);
    check.Near("green", voxel.Color.y, 0.2, 1e-6);
  }
  lines::Messages messages(voxelizer), ofExecutive(voxelizer->GetExecutive());
  voxelizer->SetRadiusArray("Missing");
  voxelizer->Update();
  check.That(messages.Has("\"Missing\""), "a missing array is an error");
  check.Near("left empty", voxelizer->GetOutput()->GetNumberOfCells(), 0.0, 0.0);
}

// The energy that is dropped is at most the tolerance.
void CheckTolerance(Check& check)
{
  vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
  voxelizer->SetSampleDimensions(8, 8, 8);
  voxelizer->SetInputData(lines::MakeLines(lines::RandomLines(300, 8)));
  voxelizer->SetMaximumOrder(8);
  vtkIdType before = VTK_ID_MAX;
  double whole = 0.0;
  for (double tolerance : { 0.0, 1e-5, 1e-3, 0.1 })
  {
    voxelizer->SetCoefficientTolerance(tolerance);
    voxelizer->Update();
    vtkDataArray* values = voxelizer->GetOutput()->GetFieldData()->GetArray("LineType0_Coefficients");
    double energy = 0.0;
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      energy += std::pow(values->GetComponent(i, 3), 2.0);
    }
    whole = tolerance == 0.0 ? energy : whole;
    check.AtLeast("energy kept", energy, (1.0 - tolerance) * whole * (1.0 - 1e-6));
    check.AtMost("coefficients", values->GetNumberOfTuples(), before - 1.0);
    before = values->GetNumberOfTuples();
  }
}

std::vector<unsigned char> Evaluate(vtkAlgorithmOutput* port)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(3.0, 2.0, 1.0);
  vtkNew<vtkAnisotropicVoxelEvaluator> evaluator;
  evaluator->SetInputConnection(port);
  evaluator->SetCamera(camera);
  evaluator->SetOutputScalarType(VTK_UNSIGNED_CHAR);
  evaluator->Update();
  vtkImageData* image = evaluator->GetOutput();
  const auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  return std::vector<unsigned char>(bytes, bytes + 4 * image->GetNumberOfPoints());
}

void CheckFile(Check& check)
{
  const std::string path = VOLUMEOPTICS_TEMPORARY "/TestLineVoxelizer.vti";
  std::vector<unsigned char> before;
  {
    vtkNew<vtkAnalyticLineSource> source;
    source->SetNumberOfSegments(5000);
    vtkNew<vtkAnisotropicLineVoxelizer> voxelizer;
    voxelizer->SetInputConnection(source->GetOutputPort());
    voxelizer->SetLineTypeArray("LineType");
    voxelizer->SetSampleDimensions(30, 20, 17);
    before = Evaluate(voxelizer->GetOutputPort());
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputConnection(voxelizer->GetOutputPort());
    writer->SetFileName(path.c_str());
    check.That(writer->Write() == 1, "written");
  }
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(path.c_str());
  const std::vector<unsigned char> after = Evaluate(reader->GetOutputPort());
  check.That(!after.empty() && before == after, "the file gives the same RGBA");
  check.AtLeast("opacity", *std::max_element(after.begin(), after.end()), 1.0);
}
}

int TestLineVoxelizer(int, char*[])
{
  Check check;
  CheckLengths(check);
  CheckOrderPiecesAndThreads(check);
  CheckArrays(check);
  CheckTolerance(check);
  CheckFile(check);
  return check.ExitCode();
}
