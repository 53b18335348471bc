// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FroxelSweep.h"

#include "Optics.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace reference
{
namespace
{
// Of a gathering ray; the mapper's.
constexpr double FroxelsOfRay = 3.5;

// Corners of a box along its directions.
std::vector<Vector> CornersOf(const Grid& grid)
{
  std::vector<Vector> corners;
  for (int i = 0; i < 8; ++i)
  {
    Vector corner = grid.corner;
    for (int axis = 0; axis < 3; ++axis)
    {
      corner += (i >> axis & 1 ? grid.Length(axis) : 0.0) * grid.directions[axis];
    }
    corners.push_back(corner);
  }
  return corners;
}

Vector Unproject(const Camera& camera, double x, double y, double depth)
{
  const glm::dvec4 point = camera.deviceToDataset * glm::dvec4(x, y, depth, 1.0);
  return Vector(point) / point.w;
}

void Include(SliceFrame& frame, const Vector& place)
{
  frame.lowest = glm::min(frame.lowest, glm::dvec2(place));
  frame.highest = glm::max(frame.highest, glm::dvec2(place));
}
}

//------------------------------------------------------------------------------
Vector SliceFrame::PointAt(const glm::dvec2& place, double distance) const
{
  const double width = this->WidthAt(distance);
  return this->origin + distance * this->away + width * (place.x * this->right + place.y * this->up);
}

//------------------------------------------------------------------------------
Vector SliceFrame::ToPlace(const Vector& point) const
{
  const Vector offset = point - this->origin;
  const double distance = glm::dot(offset, this->away);
  const double width = this->WidthAt(distance);
  return Vector(glm::dot(offset, this->right) / width, glm::dot(offset, this->up) / width, distance);
}

//------------------------------------------------------------------------------
SliceFrame FrameOfCamera(const Scene& scene)
{
  const Camera& camera = scene.camera;
  const Vector center = Unproject(camera, 0.0, 0.0, -1.0);
  const Vector ahead = Unproject(camera, 0.0, 0.0, 1.0) - center;
  const Vector atSide = Unproject(camera, 1.0, 0.0, 1.0) - Unproject(camera, 1.0, 0.0, -1.0);
  SliceFrame frame;
  frame.right = glm::normalize(Unproject(camera, 1.0, 0.0, -1.0) - center);
  frame.up = glm::normalize(Unproject(camera, 0.0, 1.0, -1.0) - center);
  frame.away = glm::normalize(glm::cross(frame.up, frame.right));
  frame.away *= glm::dot(frame.away, ahead) < 0.0 ? -1.0 : 1.0;
  frame.isPerspective = glm::length(glm::cross(glm::normalize(ahead), glm::normalize(atSide))) > 1.0e-9;
  frame.origin = frame.isPerspective ? camera.eye : center;
  const double nearDistance = glm::dot(center - frame.origin, frame.away);
  frame.front = 1.0e300;
  frame.back = nearDistance;
  frame.lowest = glm::dvec2(1.0e300);
  frame.highest = glm::dvec2(-1.0e300);
  for (const Vector& corner : CornersOf(scene.grid))
  {
    const Vector place = frame.ToPlace(corner);
    frame.front = std::min(frame.front, place.z);
    frame.back = std::max(frame.back, place.z);
    Include(frame, place);
  }
  if (frame.front <= nearDistance)
  {
    frame.front = nearDistance;
    frame.lowest = glm::dvec2(frame.ToPlace(Unproject(camera, -1.0, -1.0, -1.0)));
    frame.highest = frame.lowest;
    Include(frame, frame.ToPlace(Unproject(camera, 1.0, 1.0, -1.0)));
  }
  return frame;
}

//------------------------------------------------------------------------------
std::array<int, 3> FroxelsOf(const SliceFrame& frame, int size, double sliceDistance)
{
  const glm::dvec2 sides = frame.highest - frame.lowest;
  const double froxel = std::max(sides.x, sides.y) / size;
  const double side = froxel * frame.WidthAt(0.5 * (frame.front + frame.back));
  const auto whole = [](double number) { return std::max(1, static_cast<int>(std::ceil(number - 1.0e-6))); };
  return { whole(sides.x / froxel), whole(sides.y / froxel),
    whole((frame.back - frame.front) / (sliceDistance * side)) };
}

//------------------------------------------------------------------------------
struct FroxelSweep::Channel
{
  optics::ConeRay ray;
  double weight;
};

//------------------------------------------------------------------------------
std::vector<FroxelSweep::Channel> FroxelSweep::ChannelsOf() const
{
  std::vector<Channel> channels;
  const int samples = this->Settings.samples;
  const double angle = glm::radians(this->Settings.angle);
  if (this->Settings.algorithm == SweepAlgorithm::Directions)
  {
    for (int i = 0; i < samples; ++i)
    {
      channels.push_back({ optics::ConeDirection(i, samples, std::cos(angle)), 1.0 / samples });
    }
    return channels;
  }
  double sum = 0.0;
  for (int i = 0; i < samples * samples; ++i)
  {
    if (optics::IsOnDisk(i, samples))
    {
      const optics::ConeRay ray = optics::DiskDirection(i, samples, std::tan(angle));
      const bool isPublished = this->Settings.algorithm == SweepAlgorithm::Disk;
      channels.push_back({ ray, isPublished ? 1.0 : optics::SolidAngleOfDisk(ray.cosine) });
      sum += channels.back().weight;
    }
  }
  for (Channel& channel : channels)
  {
    channel.weight /= sum;
  }
  return channels;
}

//------------------------------------------------------------------------------
double FroxelSweep::DistanceOf(int slice) const
{
  const double share = (slice + 0.5) / this->Settings.froxels[2];
  return this->Frame.front + share * (this->Frame.back - this->Frame.front);
}

//------------------------------------------------------------------------------
glm::dvec2 FroxelSweep::PlaceOf(int column, int row) const
{
  const glm::dvec2 share((column + 0.5) / this->Settings.froxels[0], (row + 0.5) / this->Settings.froxels[1]);
  return this->Frame.lowest + share * (this->Frame.highest - this->Frame.lowest);
}

//------------------------------------------------------------------------------
Vector FroxelSweep::Center(int column, int row, int slice) const
{
  return this->Frame.PointAt(this->PlaceOf(column, row), this->DistanceOf(slice));
}

//------------------------------------------------------------------------------
// Bilinear; beyond the border nothing is in the way.
double FroxelSweep::Fetch(const Layer& layer, const glm::dvec2& place) const
{
  const int columns = this->Settings.froxels[0];
  const int rows = this->Settings.froxels[1];
  const glm::dvec2 share = (place - this->Frame.lowest) / (this->Frame.highest - this->Frame.lowest);
  const double x = std::clamp(share.x * columns - 0.5, -2.0, columns + 1.0);
  const double y = std::clamp(share.y * rows - 0.5, -2.0, rows + 1.0);
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  const auto texel = [&](int i, int j) {
    const bool isInside = i >= 0 && j >= 0 && i < columns && j < rows;
    return isInside ? layer[static_cast<std::size_t>(j) * columns + i] : 1.0;
  };
  const double lower = glm::mix(texel(column, row), texel(column + 1, row), x - column);
  const double upper = glm::mix(texel(column, row + 1), texel(column + 1, row + 1), x - column);
  return glm::mix(lower, upper, y - row);
}

//------------------------------------------------------------------------------
// Across the slices at a place, per distance along the axis.
glm::dvec2 FroxelSweep::SlopeAt(const glm::dvec2& place, const Channel& channel, int slice) const
{
  if (!this->Frame.isPerspective || this->Settings.axis == SweepAxis::SliceNormal)
  {
    return channel.ray.slope;
  }
  if (this->Settings.axis == SweepAxis::Pixel)
  {
    const Vector toEye = -glm::normalize(Vector(place, 1.0));
    return optics::SlopeOfWay(optics::TurnToAxis(Vector(channel.ray.slope, -1.0), toEye));
  }
  const bool isDirection = this->Settings.algorithm == SweepAlgorithm::Directions;
  const double middle = 0.5 * (this->Frame.front + this->Frame.back);
  return channel.ray.slope * (isDirection ? middle / this->DistanceOf(slice) : 1.0) - place;
}

//------------------------------------------------------------------------------
void FroxelSweep::SweepRow(int slice, int row, const std::vector<double>& depths,
  const std::vector<Channel>& channels, const std::vector<Layer>& former, std::vector<Layer>& next)
{
  const bool isDirections = this->Settings.algorithm == SweepAlgorithm::Directions;
  const double distance = this->DistanceOf(slice);
  const double sliceDistance = this->SliceDistance();
  const double width = this->Frame.WidthAt(distance);
  const double formerWidth = this->Frame.WidthAt(distance - sliceDistance);
  for (int column = 0; column < this->Settings.froxels[0]; ++column)
  {
    const std::size_t froxel = static_cast<std::size_t>(row) * this->Settings.froxels[0] + column;
    const double depth = depths[froxel];
    const glm::dvec2 place = this->PlaceOf(column, row);
    double visibility = 0.0;
    double passed = 0.0;
    for (std::size_t i = 0; i < channels.size(); ++i)
    {
      const glm::dvec2 slope = this->SlopeAt(place, channels[i], slice);
      const glm::dvec2 formerPlace = optics::PlaceOnSlice(place, slope, sliceDistance, width, formerWidth);
      const double arriving = slice == 0 ? 1.0 : this->Fetch(former[isDirections ? i : 0], formerPlace);
      const bool isOblique = isDirections || this->Settings.trueDistances;
      const double length = isOblique ? std::sqrt(1.0 + glm::dot(slope, slope)) : 1.0;
      const double own = this->Settings.own == OwnOpacity::HalfSlice ? 0.5 * depth * length : 0.0;
      visibility += channels[i].weight * arriving * std::exp(-own);
      const double leaving = arriving * std::exp(-depth * length);
      passed += channels[i].weight * leaving;
      next[isDirections ? i : 0][froxel] = isDirections ? leaving : passed;
      if (this->Settings.own == OwnOpacity::Gathered)
      {
        this->Reaching[i][slice * next[0].size() + froxel] = std::sqrt(arriving * leaving);
      }
    }
    if (this->Settings.own == OwnOpacity::None)
    {
      visibility = slice == 0 ? 1.0 : former[0][froxel];
    }
    this->Values[static_cast<std::size_t>(slice) * depths.size() + froxel] = visibility;
  }
}

//------------------------------------------------------------------------------
FroxelSweep::FroxelSweep(const Occluders& occluders, const SliceFrame& frame, const SweepSettings& settings)
  : Frame(frame)
  , Settings(settings)
{
  const std::vector<Channel> channels = this->ChannelsOf();
  const std::size_t froxels = static_cast<std::size_t>(settings.froxels[0]) * settings.froxels[1];
  const bool isDirections = settings.algorithm == SweepAlgorithm::Directions;
  std::vector<Layer> former(isDirections ? channels.size() : 1, Layer(froxels, 1.0));
  std::vector<Layer> next = former;
  std::vector<double> depths(froxels);
  this->Values.resize(froxels * settings.froxels[2]);
  if (settings.own == OwnOpacity::Gathered)
  {
    this->Reaching.assign(channels.size(), this->Values);
  }
  for (int slice = 0; slice < settings.froxels[2]; ++slice)
  {
    vtkSMPTools::For(0, settings.froxels[1], [&](vtkIdType begin, vtkIdType end) {
      for (int row = static_cast<int>(begin); row < end; ++row)
      {
        for (int column = 0; column < settings.froxels[0]; ++column)
        {
          depths[static_cast<std::size_t>(row) * settings.froxels[0] + column] =
            this->SliceDistance() * occluders.ExtinctionAt(this->Center(column, row, slice));
        }
        this->SweepRow(slice, row, depths, channels, former, next);
      }
    });
    former.swap(next);
  }
}

//------------------------------------------------------------------------------
// ahead: nearer to the open end
double FroxelSweep::Interpolate(const Layer& values, const Vector& point, double ahead) const
{
  const Vector place = this->Frame.ToPlace(point);
  const glm::dvec2 share =
    (glm::dvec2(place) - this->Frame.lowest) / (this->Frame.highest - this->Frame.lowest);
  const double along = (place.z - ahead - this->Frame.front) / (this->Frame.back - this->Frame.front);
  const std::array<double, 3> shares = { share.x, share.y, along };
  std::array<int, 3> low, high;
  std::array<double, 3> rest;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int last = this->Settings.froxels[axis] - 1;
    const double at = std::clamp(shares[axis] * (last + 1) - 0.5, 0.0, static_cast<double>(last));
    low[axis] = static_cast<int>(at);
    high[axis] = std::min(low[axis] + 1, last);
    rest[axis] = at - low[axis];
  }
  double value = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    std::array<int, 3> index;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isUpper = (corner >> axis & 1) != 0;
      index[axis] = isUpper ? high[axis] : low[axis];
      weight *= isUpper ? rest[axis] : 1.0 - rest[axis];
    }
    const std::size_t row = static_cast<std::size_t>(index[2]) * this->Settings.froxels[1] + index[1];
    value += weight * values[row * this->Settings.froxels[0] + index[0]];
  }
  return value;
}

//------------------------------------------------------------------------------
double FroxelSweep::At(const Vector& point) const
{
  return this->Interpolate(
    this->Values, point, this->Settings.own == OwnOpacity::AlongRay ? 0.5 * this->SliceDistance() : 0.0);
}

//------------------------------------------------------------------------------
double FroxelSweep::Gather(
  const Occluders& occluders, const std::vector<Channel>& channels, const Vector& point) const
{
  const Vector place = this->Frame.ToPlace(point);
  const double froxel = (this->Frame.highest.x - this->Frame.lowest.x) / this->Settings.froxels[0];
  const double middle = this->Frame.WidthAt(0.5 * (this->Frame.front + this->Frame.back));
  const double reach = FroxelsOfRay * std::max(froxel, this->SliceDistance() / middle);
  const double length = reach * this->Frame.WidthAt(place.z);
  double sum = 0.0;
  for (std::size_t i = 0; i < channels.size(); ++i)
  {
    const glm::dvec2 slope = this->SlopeAt(glm::dvec2(place), channels[i], 0);
    const Vector way =
      length * glm::normalize(slope.x * this->Frame.right + slope.y * this->Frame.up - this->Frame.away);
    double depth = 0.0, begin = 0.0, part = optics::FirstPartOfRay(this->Settings.gatherSamples);
    for (int sample = 0; sample < this->Settings.gatherSamples; ++sample)
    {
      depth += part * length * occluders.ExtinctionAt(point + (begin + 0.5 * part) * way);
      begin += part;
      part *= 2.0;
    }
    sum += channels[i].weight * std::exp(-depth) * this->Interpolate(this->Reaching[i], point + way, 0.0);
  }
  return sum;
}

//------------------------------------------------------------------------------
std::vector<double> FroxelSweep::At(const Occluders& occluders, const std::vector<ShownPoint>& points) const
{
  const std::vector<Channel> channels = this->ChannelsOf();
  const double wayOut = optics::MeanWayOut(std::cos(glm::radians(this->Settings.angle)));
  std::vector<double> values(points.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(points.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const ShownPoint& point = points[i];
      values[i] = this->Settings.own == OwnOpacity::Gathered
        ? this->Gather(occluders, channels, point.position)
        : this->At(point.position);
      if (this->Settings.own == OwnOpacity::AlongRay)
      {
        const double length = this->SliceDistance() / -glm::dot(point.toViewer, this->Frame.away);
        values[i] *= std::pow(occluders.Transmittance(point.position, point.toViewer, length), wayOut);
      }
    }
  });
  return values;
}
}
