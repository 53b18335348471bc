// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CovarianceField.h"

#include "Batches.h"
#include "GaussianFilter.h"
#include "GradientTile.h"
#include "Optics.h"

#include <algorithm>

namespace volumeoptics
{
namespace
{
const double LeastAccepted = 3.0;
const double SamplesPerTile = 1.5e7; // about 20 ms

// As a fraction of the range, without overflow at ranges of 1e-300 to 1e308.
float Normalised(double value, const double range[2])
{
  const double width = range[1] / 2.0 - range[0] / 2.0;
  const double fraction = width > 0.0 ? (value / 2.0 - range[0] / 2.0) / width : 0.0;
  return std::isnan(value) ? NoValue<float>() : static_cast<float>(std::clamp(fraction, -1.0e30, 1.0e30));
}

glm::dmat3 WorldCovariance(const glm::dvec3& normal, const glm::dvec3& c)
{
  const optics::TangentBasis basis = optics::SphericalBasis(normal);
  return c.x * glm::outerProduct(basis.theta, basis.theta) +
    c.y * (glm::outerProduct(basis.theta, basis.phi) + glm::outerProduct(basis.phi, basis.theta)) +
    c.z * glm::outerProduct(basis.phi, basis.phi);
}

glm::dvec3 TangentCovariance(const glm::dvec3& normal, const double* tensor)
{
  const glm::dmat3 world(
    tensor[0], tensor[3], tensor[4], tensor[3], tensor[1], tensor[5], tensor[4], tensor[5], tensor[2]);
  const optics::TangentBasis basis = optics::SphericalBasis(normal);
  return { glm::dot(basis.theta, world * basis.theta), glm::dot(basis.theta, world * basis.phi),
    glm::dot(basis.phi, world * basis.phi) };
}
}

CovarianceField::CovarianceField(const ImageGrid& grid, const ScalarSource& scalars,
  const NormalSource* normals, const CovarianceFieldSettings& settings)
  : Grid(grid)
  , Source(scalars)
  , Normals(normals)
  , Settings(settings)
  , Sampler(grid, settings.Sampling)
{
}

Halo CovarianceField::GetFilterReach(const ImageGrid& grid, double filterStandardDeviation)
{
  return filterStandardDeviation > 0.0 ? GaussianFilter(grid, filterStandardDeviation).GetHalo()
                                       : Halo{ 0, 0, 0 };
}

Halo CovarianceField::GetReach(const ImageGrid& grid, double radius, double filterStandardDeviation)
{
  const Halo filter = GetFilterReach(grid, filterStandardDeviation);
  Halo reach = CoveringHalo(grid, radius);
  for (int axis = 0; axis < 3; ++axis)
  {
    reach[axis] = std::max(reach[axis], 1) + filter[axis]; // 1: the normal's stencil
  }
  return reach;
}

bool CovarianceField::LoadScalars(Batches& batches, const Extent& box)
{
  const int padding = this->Sampler.GetPadding();
  this->Scalars = VoxelBox<float>(box, 1, padding);
  const std::vector<Extent> tiles = SplitIntoTiles(box, 32, 1.0e6);
  return batches.Run(tiles.size(), 0.1, [&](long long unit) {
    const Extent& tile = tiles[unit];
    const VoxelBox<double> values = this->Source.Load(tile);
    for (int z = tile[4]; z <= tile[5]; ++z)
    {
      for (int y = tile[2]; y <= tile[3]; ++y)
      {
        const double* from = values.Row(y, z);
        this->Scalars.SetRow(y, z, NoValue<float>());
        std::transform(from, from + (tile[1] - tile[0] + 1), this->Scalars.Row(y, z),
          [this](double value) { return Normalised(value, this->Settings.ScalarRange); });
      }
    }
  });
}

void CovarianceField::SetNormals(
  const Extent& tile, std::vector<CovarianceRows>& rows, std::vector<glm::dvec3>& normals) const
{
  std::unique_ptr<GradientTile> gradients;
  if (!this->Normals)
  {
    gradients = std::make_unique<GradientTile>(this->Grid, this->Source, tile);
  }
  const int count = tile[1] - tile[0] + 1;
  rows.reserve(static_cast<std::size_t>(tile[3] - tile[2] + 1) * (tile[5] - tile[4] + 1));
  normals.resize(NumberOfVoxels(tile));
  glm::dvec3* normal = normals.data();
  for (int z = tile[4]; z <= tile[5]; ++z)
  {
    for (int y = tile[2]; y <= tile[3]; ++y, normal += count)
    {
      if (gradients)
      {
        const glm::dvec3* gradient = gradients->Row(y, z);
        std::transform(
          gradient, gradient + count, normal, [](const glm::dvec3& g) { return NormalOf(g).Normal; });
      }
      else
      {
        this->Normals->Read(tile[0], tile[1], y, z, normal);
      }
      rows.emplace_back(count).SetNormals(normal, count);
    }
  }
}

void CovarianceField::StoreCode(
  const glm::dvec3& normal, const glm::dvec3& tangentCovariance, double accepted, float* code) const
{
  glm::dvec2 anisotropy;
  if (normal == glm::dvec3(0.0) || accepted < LeastAccepted || !AnisotropyOf(tangentCovariance, anisotropy))
  {
    return; // stays NaN
  }
  if (this->Settings.NoiseCorrection)
  {
    anisotropy = optics::WithoutSamplingNoise(anisotropy, accepted);
  }
  EncodeAnisotropy(this->Settings.Code, normal, anisotropy, code);
}

void CovarianceField::StoreCodes(
  const glm::dvec3* normals, const CovarianceRows& row, int y, int z, VoxelBox<float>& codes)
{
  const Extent& box = codes.GetBox();
  codes.SetRow(y, z, NoValue<float>());
  float* code = codes.Row(y, z);
  for (int i = 0; i <= box[1] - box[0]; ++i, code += codes.GetComponents())
  {
    this->StoreCode(normals[i], row.GetTangentCovariance(i), row.GetAccepted(i), code);
  }
}

void CovarianceField::StoreTensors(
  const glm::dvec3* normals, const CovarianceRows& row, int y, int z, VoxelBox<float>&)
{
  const Extent& box = this->Tensors.GetBox();
  this->Tensors.SetRow(y, z, NoValue<float>());
  float* tensor = this->Tensors.Row(y, z);
  float* normal = this->FilterNormals.Row(y, z);
  for (int i = 0; i <= box[1] - box[0]; ++i, tensor += 7, normal += 3)
  {
    const glm::vec3 rounded(normals[i]);
    std::copy(&rounded.x, &rounded.x + 3, normal);
    if (normals[i] != glm::dvec3(0.0) && row.GetAccepted(i) >= LeastAccepted)
    {
      const glm::dmat3 c = WorldCovariance(normals[i], row.GetTangentCovariance(i));
      const double numbers[7] = { c[0][0], c[1][1], c[2][2], c[0][1], c[0][2], c[1][2], row.GetAccepted(i) };
      std::copy(numbers, numbers + 7, tensor);
    }
  }
}

bool CovarianceField::Compute(Batches& batches, VoxelBox<float>& codes)
{
  const bool isFiltered = this->Settings.FilterStandardDeviation > 0.0;
  const Halo filter = GetFilterReach(this->Grid, this->Settings.FilterStandardDeviation);
  const Extent box = Grown(codes.GetBox(), filter, this->Grid.Whole);
  const Halo reach = CoveringHalo(this->Grid, this->Settings.Sampling.Radius);
  if (!this->LoadScalars(batches, Grown(box, reach, this->Grid.Whole)))
  {
    return false;
  }
  if (isFiltered)
  {
    this->Tensors = VoxelBox<float>(box, 7, 0);
    this->FilterNormals = VoxelBox<float>(box, 3, 0);
  }
  const std::vector<Extent> tiles =
    SplitIntoTiles(box, CovarianceSampler::BlockSize, SamplesPerTile / this->Sampler.GetWorkPerVoxel());
  const bool isComplete = batches.Run(tiles.size(), isFiltered ? 0.7 : 0.95, [&](long long unit) {
    const Extent& tile = tiles[unit];
    std::vector<CovarianceRows> rows;
    std::vector<glm::dvec3> normals;
    this->SetNormals(tile, rows, normals);
    this->Sampler.SampleTile(this->Scalars, tile, rows);
    auto store = isFiltered ? &CovarianceField::StoreTensors : &CovarianceField::StoreCodes;
    const glm::dvec3* normal = normals.data();
    const CovarianceRows* row = rows.data();
    for (int z = tile[4]; z <= tile[5]; ++z)
    {
      for (int y = tile[2]; y <= tile[3]; ++y, normal += tile[1] - tile[0] + 1, ++row)
      {
        (this->*store)(normal, *row, y, z, codes);
      }
    }
  });
  return isComplete && (!isFiltered || this->Filter(batches, codes));
}

bool CovarianceField::Filter(Batches& batches, VoxelBox<float>& codes)
{
  const std::vector<Extent> tiles = SplitIntoTiles(codes.GetBox(), 16, 1.0e5);
  return batches.Run(tiles.size(), 0.95, [&](long long unit) { this->FilterTile(tiles[unit], codes); });
}

void CovarianceField::FilterTile(const Extent& tile, VoxelBox<float>& codes) const
{
  const GaussianFilter gaussian(this->Grid, this->Settings.FilterStandardDeviation);
  const Extent around = Grown(tile, gaussian.GetHalo(), this->Grid.Whole);
  VoxelBox<double> tensors(around, 7, 0);
  for (int z = around[4]; z <= around[5]; ++z)
  {
    for (int y = around[2]; y <= around[3]; ++y)
    {
      const float* from = this->Tensors.At(around[0], y, z);
      std::copy(from, from + 7 * (around[1] - around[0] + 1), tensors.Row(y, z));
    }
  }
  const VoxelBox<double> means = gaussian.Apply(tensors, tile, false);
  for (int z = tile[4]; z <= tile[5]; ++z)
  {
    for (int y = tile[2]; y <= tile[3]; ++y)
    {
      codes.SetRow(y, z, NoValue<float>());
      for (int x = tile[0]; x <= tile[1]; ++x)
      {
        const float* n = this->FilterNormals.At(x, y, z);
        const glm::dvec3 normal(n[0], n[1], n[2]);
        const double* mean = means.At(x, y, z);
        if (!std::isnan(mean[0]) && normal != glm::dvec3(0.0))
        {
          const glm::dvec3 unit = glm::normalize(normal);
          this->StoreCode(unit, TangentCovariance(unit, mean), mean[6], codes.At(x, y, z));
        }
      }
    }
  }
}
}
