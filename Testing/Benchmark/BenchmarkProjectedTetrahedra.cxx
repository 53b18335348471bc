// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// What the integral in data space saves on projected tetrahedra, after [Kraus2005] section 6: its table
// has two dimensions (scalars in front and behind), that of physical space three (and the length).
// Memory of the table, time to build it and of a frame, and the error of the opacity: root mean square
// over all pixels, in codes of 255, from the picture with the finest table of two dimensions.
// Frames of all kinds alternate; medians, and the ratio to the first kind, a table of 3 dimensions.
//
//   BenchmarkProjectedTetrahedra [--points number] [--size pixels] [--frames number]
//
// The scene is that of its figure 8: a buckyball of points^3 (32: 148,955 tetrahedra).

#include "BenchmarkOptions.h"
#include "FrameTimes.h"
#include "BuckyballScene.h"
#include "StandaloneShaders.h"
#include "DataSpaceClassification.h"
#include "ProjectedTetrahedraPainter.h"
#include "TetrahedraVertices.h"
#include "vtkHeadlessRenderWindow.h"
#include "vtkPreIntegratedTable.h"

#include "vtkCamera.h"
#include "vtkCellCenterDepthSort.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace
{
const double UnitDistance = 0.02; // of physical space, on [-1, 1]^3
const int FinestTable = 1024;

std::string ReadText(const std::string& name)
{
  const std::ifstream file(std::string(BENCHMARK_FOLDER) + "/" + name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

double Seconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// The longest edge: no ray is longer in a cell.
double LongestSegment(vtkUnstructuredGrid* grid)
{
  return std::sqrt(grid->GetCell(0)->GetLength2());
}

// Physical space, by one of the two tables.
class PhysicalPainter : public ProjectedTetrahedraPainter
{
public:
  // lengths: entries along the third axis, 0 for a table of means
  PhysicalPainter(int scalars, int lengths, double largestLength)
    : Scalars(scalars)
    , Lengths(lengths)
    , LargestLength(largestLength)
    , Shader(ProjectedTetrahedraFragmentShader(ReadText(lengths ? "LengthTable.glsl" : "LengthMeans.glsl")))
  {
  }

  void Build(vtkPreIntegratedTable* functions)
  {
    vtkNew<vtkPreIntegratedTable> table;
    table->SetColorFunction(functions->GetColorFunction());
    table->SetOpacityFunction(functions->GetOpacityFunction());
    table->SetRange(functions->GetRange());
    table->SetSize(this->Scalars);
    const std::size_t slice = std::size_t(4) * this->Scalars * this->Scalars;
    if (this->Lengths == 0)
    {
      table->SetSegmentLength(1e-3);
      table->Update();
      this->Entries.assign(table->GetEntries(), table->GetEntries() + slice);
      return;
    }
    this->Entries.assign(slice * this->Lengths, 0.0F);
    for (int i = 1; i < this->Lengths; ++i)
    {
      const double length = this->LargestLength * i / (this->Lengths - 1) / UnitDistance;
      table->SetSegmentLength(length);
      table->Update();
      this->AddSlice(table->GetEntries(), length, &this->Entries[slice * i]);
    }
  }

  std::size_t GetMemorySize() const { return this->Entries.size() * sizeof(float); }

protected:
  std::string GetFragmentShader() const override { return this->Shader; }

  void BindTextures(vtkShaderProgram* program) override
  {
    this->ProjectedTetrahedraPainter::BindTextures(program);
    this->Upload();
    this->Texture->Activate();
    const char* name = this->Lengths ? "in_lengthTable" : "in_meanTable";
    program->SetUniformi(name, this->Texture->GetTextureUnit());
    program->SetUniformf("in_scalarEntries", static_cast<float>(this->Scalars));
    program->SetUniformf("in_lengthEntries", static_cast<float>(this->Lengths));
    program->SetUniformf("in_largestLength", static_cast<float>(this->LargestLength));
    program->SetUniformf("in_unitDistance", static_cast<float>(UnitDistance));
  }

  void UnbindTextures() override
  {
    this->Texture->Deactivate();
    this->ProjectedTetrahedraPainter::UnbindTextures();
  }

private:
  // Means to associated colours and opacities of segments of one length.
  void AddSlice(const float* means, double length, float* slice) const
  {
    for (std::size_t i = 0; i < std::size_t(this->Scalars) * this->Scalars; ++i)
    {
      const float opacity = static_cast<float>(-std::expm1(-means[4 * i + 3] * length));
      for (int channel = 0; channel < 3; ++channel)
      {
        slice[4 * i + channel] = opacity * means[4 * i + channel];
      }
      slice[4 * i + 3] = opacity;
    }
  }

  void Upload()
  {
    if (this->Texture->GetHandle() != 0)
    {
      return;
    }
    this->Texture->SetContext(this->Window);
    for (auto set : { &vtkTextureObject::SetMinificationFilter, &vtkTextureObject::SetMagnificationFilter })
    {
      (this->Texture->*set)(vtkTextureObject::Linear);
    }
    this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
    this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
    this->Texture->SetWrapR(vtkTextureObject::ClampToEdge);
    this->Lengths
      ? this->Texture->Create3DFromRaw(
          this->Scalars, this->Scalars, this->Lengths, 4, VTK_FLOAT, this->Entries.data())
      : this->Texture->Create2DFromRaw(this->Scalars, this->Scalars, 4, VTK_FLOAT, this->Entries.data());
  }

  int Scalars;
  int Lengths;
  double LargestLength;
  std::string Shader;
  std::vector<float> Entries;
  vtkNew<vtkTextureObject> Texture;
};

// The mapper without its checks, for any painter.
class PainterMapper : public vtkProjectedTetrahedraMapper
{
public:
  static PainterMapper* New();
  vtkTypeMacro(PainterMapper, vtkProjectedTetrahedraMapper);

  void Render(vtkRenderer* renderer, vtkVolume* volume) override
  {
    this->VisibilitySort->SetInput(this->GetInput());
    this->VisibilitySort->SetDirectionToBackToFront();
    this->VisibilitySort->SetModelTransform(volume->GetMatrix());
    this->VisibilitySort->SetCamera(renderer->GetActiveCamera());
    this->VisibilitySort->SetMaxCellsReturned(1000);
    this->VisibilitySort->InitTraversal();
    this->Order.clear();
    while (vtkIdTypeArray* cells = this->VisibilitySort->GetNextCells())
    {
      this->Vertices->AddFaces(cells, this->Order);
    }
    this->Painter->Draw(renderer, volume, this->Order, [](vtkShaderProgram*) {});
  }

  void ReleaseGraphicsResources(vtkWindow* window) override { this->Painter->Release(window); }

  const TetrahedraVertices* Vertices = nullptr;
  std::shared_ptr<ProjectedTetrahedraPainter> Painter;

private:
  std::vector<unsigned int> Order;
};
vtkStandardNewMacro(PainterMapper);

struct Scene
{
  explicit Scene(int points)
    : Grid(buckyball::MakeGrid(points))
  {
    this->Vertices.Build(this->Grid, this->Grid->GetPointData()->GetScalars(), this->Range);
    this->Property->SetScalarOpacityUnitInterval(0.01);
    buckyball::SetFunctions(this->Property);
  }

  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  double Range[2] = { 0.0, 1.0 };
  TetrahedraVertices Vertices;
  vtkNew<vtkOpticsVolumeProperty> Property;
};

class Contestant
{
public:
  // lengths: -1 for data space
  Contestant(const Scene& scene, const std::string& name, int scalars, int lengths, bool hasSilhouettes)
    : Name(name)
  {
    this->Property->DeepCopy(scene.Property);
    this->Property->SetSilhouette(
      hasSilhouettes ? vtkOpticsVolumeProperty::Exact : vtkOpticsVolumeProperty::SilhouetteOff);
    const double begin = Seconds();
    this->Classification.Update(this->Property, scene.Range, lengths < 0 ? scalars : 2);
    this->MemorySize = std::size_t(4) * sizeof(float) * scalars * scalars;
    auto painter = std::make_shared<ProjectedTetrahedraPainter>();
    if (lengths >= 0)
    {
      auto physical = std::make_shared<PhysicalPainter>(scalars, lengths, LongestSegment(scene.Grid));
      physical->Build(this->Classification.GetTable());
      this->MemorySize = physical->GetMemorySize();
      painter = physical;
    }
    this->BuildSeconds = Seconds() - begin;
    painter->SetVertices(&scene.Vertices);
    painter->SetClassification(&this->Classification);
    this->Mapper->Painter = painter;
    this->Mapper->Vertices = &scene.Vertices;
    this->Mapper->SetInputData(scene.Grid);
  }

  void SetUp(int size)
  {
    vtkNew<vtkVolume> volume;
    volume->SetMapper(this->Mapper);
    volume->SetProperty(this->Property);
    this->Renderer->AddVolume(volume);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(size, size);
    this->Window->AddRenderer(this->Renderer);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(1.0, 4.0, 1.5);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(24.0);
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render(); // uploads and links
  }

  void Draw() { this->Times.Draw(this->Window); }

  std::vector<unsigned char> GetPicture()
  {
    vtkRenderWindow* window = this->Window;
    const int* size = window->GetSize();
    vtkNew<vtkUnsignedCharArray> pixels;
    window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
    return std::vector<unsigned char>(
      pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
  }

  std::string Name;
  std::size_t MemorySize = 0;
  double BuildSeconds = 0.0;
  FrameTimes Times;

private:
  vtkNew<vtkOpticsVolumeProperty> Property;
  DataSpaceClassification Classification;
  vtkNew<PainterMapper> Mapper;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkHeadlessRenderWindow> Window;
};

double RootMeanSquare(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += (double(a[i]) - b[i]) * (double(a[i]) - b[i]);
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

struct Kind
{
  const char* Name;
  int Scalars;
  int Lengths;
  bool HasSilhouettes;
};

const Kind Kinds[] = { { "physical 3D", 64, 64, false }, { "physical 3D", 128, 32, false },
  { "physical 3D", 128, 128, false }, { "physical 2D means", 256, 0, false }, { "data 2D", 64, -1, false },
  { "data 2D", 256, -1, false }, { "data 2D with silhouettes", 64, -1, true },
  { "data 2D with silhouettes", 256, -1, true } };

// White: a pixel is its opacity, which does not depend on the order of the cells.
double ErrorOf(Scene& scene, const Kind& kind, int size)
{
  vtkNew<vtkColorTransferFunction> white;
  white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  scene.Property->SetColor(white);
  Contestant contestant(scene, kind.Name, kind.Scalars, kind.Lengths, kind.HasSilhouettes);
  Contestant truth(scene, "truth", FinestTable, kind.Lengths < 0 ? -1 : 0, kind.HasSilhouettes);
  contestant.SetUp(size);
  truth.SetUp(size);
  buckyball::SetFunctions(scene.Property);
  return RootMeanSquare(contestant.GetPicture(), truth.GetPicture());
}

std::string SizeText(const Kind& kind)
{
  const std::string axis = std::to_string(kind.Scalars);
  return axis + "x" + axis + (kind.Lengths > 0 ? "x" + std::to_string(kind.Lengths) : std::string());
}
}

int main(int argc, char** argv)
{
  const BenchmarkOptions options(argc, argv, { { "--points", 32 }, { "--size", 512 }, { "--frames", 9 } });
  Scene scene(options.Whole("--points"));
  std::vector<std::unique_ptr<Contestant>> contestants;
  std::vector<double> errors;
  for (const Kind& kind : Kinds)
  {
    errors.push_back(ErrorOf(scene, kind, options.Whole("--size")));
    contestants.push_back(
      std::make_unique<Contestant>(scene, kind.Name, kind.Scalars, kind.Lengths, kind.HasSilhouettes));
    contestants.back()->SetUp(options.Whole("--size"));
  }
  for (int frame = 0; frame < options.Whole("--frames"); ++frame)
  {
    for (auto& contestant : contestants)
    {
      contestant->Draw();
    }
  }
  const double first = contestants.front()->Times.GetProcessorSeconds();
  std::cout << "tetrahedra," << scene.Grid->GetNumberOfCells()
            << "\ntable,entries,KiB,build ms,wall ms,processor ms,of the first,error in codes\n";
  for (std::size_t i = 0; i < contestants.size(); ++i)
  {
    const Contestant& contestant = *contestants[i];
    const double processor = contestant.Times.GetProcessorSeconds();
    std::cout << contestant.Name << "," << SizeText(Kinds[i]) << "," << contestant.MemorySize / 1024 << ","
              << 1000.0 * contestant.BuildSeconds << "," << 1000.0 * contestant.Times.GetSeconds() << ","
              << 1000.0 * processor << "," << processor / first << "," << errors[i] << "\n";
  }
  return EXIT_SUCCESS;
}
