// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkStructuralDissimilarity.h"

#include "PicturePlane.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

vtkStandardNewMacro(vtkStructuralDissimilarity);

namespace
{
using picture::ForEachRow;
using picture::GaussianWindow;
using picture::HalfSize;
using picture::Plane;
using picture::Smooth;

// [Wang2004] (K2 L)^2/2 with K2 = 0.03, L = 1.
const double StructureConstant = 0.03 * 0.03 / 2.0;
// [Wang2003] section 4.
const double ScaleWeights[] = { 0.0448, 0.2856, 0.3001, 0.2363, 0.1333 };

// mean(a b) - mean(a) mean(b) under the window. Variances and covariance of equal planes come out
// equal to the last bit, because they are computed alike.
Plane Covariance(const Plane& a, const Plane& meanA, const Plane& b, const Plane& meanB)
{
  Plane product(a.width, a.height);
  std::transform(
    a.values.begin(), a.values.end(), b.values.begin(), product.values.begin(), std::multiplies<>());
  Plane covariance = Smooth(product, GaussianWindow());
  for (size_t i = 0; i < covariance.values.size(); ++i)
  {
    covariance.values[i] -= meanA.values[i] * meanB.values[i];
  }
  return covariance;
}

// d of the class comment. Rounding may leave a negative variance or a covariance above its bound.
double Dissimilarity(double varianceR, double varianceP, double covariance, double homogeneityWeight)
{
  const double c = StructureConstant;
  varianceR = std::max(varianceR, 0.0);
  varianceP = std::max(varianceP, 0.0);
  const double sigmas = std::sqrt(varianceR * varianceP);
  covariance = std::clamp(covariance, -sigmas, sigmas);
  const double structure = (covariance + c) / (sigmas + c);
  const double presence = (2.0 * covariance + c) / (varianceR + varianceP + c);
  const double homogeneity = homogeneityWeight * c / (varianceR + c);
  // as differences from 1, so that equal pictures give exactly 0
  const double sum = (1.0 - homogeneity) * (1.0 - structure) + homogeneity * (1.0 - presence);
  return std::max(sum / 2.0, 0.0);
}

// Steps of DissimilarityMap() that take time; `advance` is called after each.
const int StepsOfMap = 5;

template <class Advance>
Plane DissimilarityMap(
  const Plane& reference, const Plane& picture, double homogeneityWeight, Advance advance)
{
  const Plane meanR = Smooth(reference, GaussianWindow());
  advance();
  const Plane meanP = Smooth(picture, GaussianWindow());
  advance();
  const Plane varianceR = Covariance(reference, meanR, reference, meanR);
  advance();
  const Plane varianceP = Covariance(picture, meanP, picture, meanP);
  advance();
  Plane map = Covariance(reference, meanR, picture, meanP);
  advance();
  for (size_t i = 0; i < map.values.size(); ++i)
  {
    map.values[i] = Dissimilarity(varianceR.values[i], varianceP.values[i], map.values[i], homogeneityWeight);
  }
  return map;
}

// Largest value of an integer type, 1 of a floating-point type.
double WhiteOf(vtkDataArray* scalars)
{
  const int type = scalars->GetDataType();
  return type == VTK_FLOAT || type == VTK_DOUBLE ? 1.0 : scalars->GetDataTypeMax();
}

Plane Luminance(vtkImageData* image)
{
  const int* dimensions = image->GetDimensions();
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const bool isColor = scalars->GetNumberOfComponents() >= 3;
  const double white = WhiteOf(scalars);
  Plane plane(dimensions[0], dimensions[1]);
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const double luminance = isColor ? 0.2126 * scalars->GetComponent(i, 0) +
        0.7152 * scalars->GetComponent(i, 1) + 0.0722 * scalars->GetComponent(i, 2)
                                     : scalars->GetComponent(i, 0);
    plane.values[i] = std::isfinite(luminance) ? luminance / white : 0.0;
  }
  return plane;
}

// Adds a scale's roots to the whole map: each pixel takes that of the cell it lies in.
void AccumulateRoots(Plane& total, const Plane& scale, int factor, double weight)
{
  ForEachRow(total.height, [&](int y) {
    for (int x = 0; x < total.width; ++x)
    {
      total.At(x, y) += weight * std::sqrt(scale.At(x / factor, y / factor));
    }
  });
}
}

//------------------------------------------------------------------------------
vtkStructuralDissimilarity::vtkStructuralDissimilarity()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkStructuralDissimilarity::SetReferenceData(vtkImageData* image)
{
  this->SetInputData(0, image);
}

//------------------------------------------------------------------------------
void vtkStructuralDissimilarity::SetPictureData(vtkImageData* image)
{
  this->SetInputData(1, image);
}

//------------------------------------------------------------------------------
int vtkStructuralDissimilarity::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkDataObject::SetPointDataActiveScalarInfo(outputs->GetInformationObject(0), VTK_DOUBLE, 1);
  return 1;
}

//------------------------------------------------------------------------------
// A score is that of the whole pictures.
int vtkStructuralDissimilarity::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  for (int port = 0; port < 2; ++port)
  {
    vtkInformation* information = inputs[port]->GetInformationObject(0);
    int extent[6];
    information->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
    information->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkStructuralDissimilarity::AreComparable(vtkImageData* reference, vtkImageData* picture)
{
  if (!reference->GetPointData()->GetScalars() || !picture->GetPointData()->GetScalars())
  {
    vtkErrorMacro(<< "A picture has no point scalars. Give both inputs some.");
    return false;
  }
  const int* r = reference->GetDimensions();
  const int* p = picture->GetDimensions();
  if (r[0] != p[0] || r[1] != p[1] || r[2] != 1 || p[2] != 1)
  {
    vtkErrorMacro(<< "The pictures are " << r[0] << " x " << r[1] << " x " << r[2] << " and " << p[0] << " x "
                  << p[1] << " x " << p[2] << ". Give two of equal size and one slice.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkStructuralDissimilarity::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Score = -1.0;
  vtkImageData* referenceImage = vtkImageData::GetData(inputs[0]);
  vtkImageData* pictureImage = vtkImageData::GetData(inputs[1]);
  if (!this->AreComparable(referenceImage, pictureImage))
  {
    return 0;
  }
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->SetExtent(referenceImage->GetExtent());
  output->AllocateScalars(VTK_DOUBLE, 1);
  vtkDataArray* scalars = output->GetPointData()->GetScalars();
  scalars->SetName("StructuralDissimilarity");
  scalars->Fill(0.0);
  auto* values = static_cast<double*>(output->GetScalarPointer());
  this->ComputeMap(referenceImage, pictureImage, values);
  if (!this->GetAbortExecute())
  {
    const auto count = scalars->GetNumberOfTuples();
    this->Score = std::accumulate(values, values + count, 0.0) / static_cast<double>(count);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkStructuralDissimilarity::ComputeMap(
  vtkImageData* referenceImage, vtkImageData* pictureImage, double* values)
{
  Plane reference = Luminance(referenceImage);
  Plane picture = Luminance(pictureImage);
  Plane roots(reference.width, reference.height);
  double weights = 0.0;
  int steps = 0;
  auto advance = [this, &steps]() {
    this->UpdateProgress(++steps / static_cast<double>(StepsOfMap * this->NumberOfScales));
  };
  for (int scale = 0; scale < this->NumberOfScales && !this->GetAbortExecute(); ++scale)
  {
    if (scale > 0)
    {
      if (reference.width == 1 && reference.height == 1)
      {
        break;
      }
      reference = HalfSize(reference);
      picture = HalfSize(picture);
    }
    const Plane map = DissimilarityMap(reference, picture, this->HomogeneityWeight, advance);
    AccumulateRoots(roots, map, 1 << scale, ScaleWeights[scale]);
    weights += ScaleWeights[scale];
  }
  std::transform(roots.values.begin(), roots.values.end(), values, [weights](double sum) {
    const double root = weights > 0.0 ? sum / weights : 0.0;
    return root * root;
  });
}

//------------------------------------------------------------------------------
void vtkStructuralDissimilarity::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfScales: " << this->NumberOfScales << "\n";
  os << indent << "HomogeneityWeight: " << this->HomogeneityWeight << "\n";
  os << indent << "Score: " << this->Score << "\n";
}
