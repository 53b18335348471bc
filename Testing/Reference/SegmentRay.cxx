// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SegmentRay.h"

#include "LightingTransfer.h"
#include "Optics.h"
#include "Shading.h"
#include "TransferIntegral.h"

#include <algorithm>
#include <cmath>

namespace reference
{
namespace
{
// A segment is halved this often at most.
const int LargestLevel = 24;

// An isosurface is found to 2^-60 of its segment.
const int Bisections = 60;

// A point of a ray, by its distance from the ray's origin.
struct Place
{
  double at;
  double scalar;
};

class SegmentRay
{
public:
  SegmentRay(const Scene& scene, const Ray& ray)
    : World(scene)
    , Path(ray)
    , Transfer(scene.opacity, scene.color, 1.0e-7)
  {
  }

  Place PlaceAt(double at) const
  {
    return { at, this->World.field->Value(this->Path.origin + at * this->Path.direction) };
  }

  void Add(const Place& front, const Place& back, int level)
  {
    const Place middle = this->PlaceAt(0.5 * (front.at + back.at));
    const double off = std::abs(middle.scalar - 0.5 * (front.scalar + back.scalar));
    if (this->World.linearity > 0.0 && level > 0 &&
      off > this->World.linearity * this->World.RangeOfOpacity())
    {
      this->Add(front, middle, level - 1);
      this->Add(middle, back, level - 1);
      return;
    }
    this->AddLinear(front, back);
  }

  bool IsFinished() const { return this->World.terminatesEarly && this->Sum.a > EarlyTerminationOpacity; }
  const glm::dvec4& Color() const { return this->Sum; }

private:
  // Surfaces part the segment; what is post-classified is so by the sample at the segment's own back.
  void AddLinear(const Place& front, const Place& back)
  {
    Place begin = front;
    for (const Isosurface& surface : this->SurfacesOf(front, back))
    {
      const Place crossing = this->Crossing(front, back, surface.value);
      this->AddInterior(begin, crossing, back);
      this->AddSurface(surface, crossing);
      begin = crossing;
    }
    this->AddInterior(begin, back, back);
  }

  std::vector<Isosurface> SurfacesOf(const Place& front, const Place& back) const
  {
    std::vector<Isosurface> surfaces;
    for (const Isosurface& surface : this->World.isosurfaces)
    {
      if (optics::CrossesIsovalue(front.scalar, back.scalar, surface.value))
      {
        surfaces.push_back(surface);
      }
    }
    const bool isUpward = front.scalar < back.scalar;
    std::stable_sort(surfaces.begin(), surfaces.end(), [isUpward](const Isosurface& a, const Isosurface& b) {
      return isUpward ? a.value < b.value : a.value > b.value;
    });
    return surfaces;
  }

  Place Crossing(Place front, Place back, double value) const
  {
    for (int i = 0; i < Bisections; ++i)
    {
      const Place middle = this->PlaceAt(0.5 * (front.at + back.at));
      (optics::CrossesIsovalue(front.scalar, middle.scalar, value) ? back : front) = middle;
    }
    return { back.at, value };
  }

  Sample SampleAt(const Place& place) const
  {
    Sample sample;
    sample.position = this->Path.origin + place.at * this->Path.direction;
    sample.entry = this->Path.origin + this->Path.inside.entry * this->Path.direction;
    sample.toViewer = -this->Path.direction;
    sample.scalar = place.scalar;
    return sample;
  }

  void Composite(double opacity, const Vector& radiance)
  {
    this->Sum += (1.0 - this->Sum.a) * opacity * glm::dvec4(radiance, 1.0);
  }

  void AddSurface(const Isosurface& surface, const Place& place)
  {
    Sample sample = this->SampleAt(place);
    sample.isSurface = true;
    const Vector gradient = PairGradientAt(this->World, sample);
    const double length = glm::length(gradient);
    const double cosine = length > 0.0 ? glm::dot(gradient, this->Path.direction) / length : 1.0;
    double opacity = surface.opacity;
    if (this->World.silhouette == Silhouette::Clamped)
    {
      opacity = optics::ClampedSurfaceOpacity(opacity, cosine);
    }
    else if (this->World.silhouette != Silhouette::Off)
    {
      opacity = optics::SurfaceSilhouetteOpacity(opacity, cosine);
    }
    if (opacity > 0.0)
    {
      this->Composite(opacity, Radiance(this->World, sample, surface.color, 1.0 - surface.opacity));
    }
  }

  // What the transfer functions make of a part of a segment; classified and lit at the segment's sample.
  void AddInterior(const Place& front, const Place& back, const Place& sampled)
  {
    if (!(back.at > front.at))
    {
      return;
    }
    const bool isData = this->World.integrationSpace == IntegrationSpace::Data;
    const SegmentIntegral integral =
      isData ? this->InDataSpace(front, back, sampled) : this->InPhysicalSpace(front, back, sampled);
    const double opacity = isData ? this->WithSilhouette(integral, front, back, sampled) : integral.opacity;
    if (!(opacity > 0.0))
    {
      return;
    }
    const Vector color =
      integral.opacity > 0.0 ? integral.color / integral.opacity : this->World.Color(sampled.scalar);
    const double share =
      isData ? this->TransmittedShare(integral.depth, front, back) : 1.0 - integral.opacity;
    this->Composite(opacity, Radiance(this->World, this->SampleAt(sampled), color, share));
  }

  bool IsPost() const { return this->World.classification == Classification::Post; }

  // Lengths are the dataset's, in units of ScalarOpacityUnitDistance.
  SegmentIntegral InPhysicalSpace(const Place& front, const Place& back, const Place& sampled) const
  {
    const double length = (back.at - front.at) / this->World.unitDistance;
    const double change = std::abs(back.scalar - front.scalar);
    return this->IsPost() || change == 0.0
      ? this->Transfer.At(sampled.scalar, length)
      : this->Transfer.Between(front.scalar, back.scalar, length / change);
  }

  // Post-classified: eq. 11. The change of the scalar is the projected gradient times the step, and adds up.
  SegmentIntegral InDataSpace(const Place& front, const Place& back, const Place& sampled) const
  {
    const double attenuation = 1.0 / this->World.EffectiveUnitInterval();
    return this->IsPost()
      ? this->Transfer.At(sampled.scalar, attenuation * std::abs(back.scalar - front.scalar))
      : this->Transfer.Between(front.scalar, back.scalar, attenuation);
  }

  double WithSilhouette(
    const SegmentIntegral& integral, const Place& front, const Place& back, const Place& sampled) const
  {
    if (this->World.silhouette == Silhouette::Off)
    {
      return integral.opacity;
    }
    const double scalarStep = std::abs(back.scalar - front.scalar);
    const Vector gradient = PairGradientAt(this->World, this->SampleAt(sampled));
    const double gradientStep = glm::length(gradient) * (back.at - front.at);
    const double mean = scalarStep > 0.0
      ? integral.depth / scalarStep
      : this->Transfer.At(sampled.scalar, 1.0 / this->World.EffectiveUnitInterval()).depth;
    return this->World.silhouette == Silhouette::Clamped
      ? optics::ClampedSilhouetteOpacity(mean, scalarStep, gradientStep)
      : optics::SilhouetteOpacity(mean, scalarStep, gradientStep);
  }

  double DepthOfPeak(double scalar) const
  {
    return this->Transfer.DepthToEnd(scalar, true) + this->Transfer.DepthToEnd(scalar, false);
  }

  // Of light that comes through what is left of the segment's peak; the silhouette is the eye's alone.
  double TransmittedShare(double depth, const Place& front, const Place& back) const
  {
    if (this->World.transmittedLight == TransmittedLight::Off || !this->World.shade)
    {
      return 0.0;
    }
    const double attenuation = 1.0 / this->World.EffectiveUnitInterval();
    const bool isUpward = back.scalar > front.scalar;
    const double behind = attenuation * this->Transfer.DepthToEnd(back.scalar, isUpward);
    // a segment that ends behind the peak began in it
    const double peak = std::max(this->DepthOfPeak(front.scalar), this->DepthOfPeak(back.scalar));
    return optics::TransmittedShare(depth, behind, attenuation * peak);
  }

  const Scene& World;
  const Ray& Path;
  TransferIntegral Transfer;
  glm::dvec4 Sum = glm::dvec4(0.0);
};
}

//------------------------------------------------------------------------------
bool GoesBySegments(const Scene& scene)
{
  return scene.integrationSpace == IntegrationSpace::Data ||
    scene.classification == Classification::PreIntegrated || !scene.isosurfaces.empty();
}

//------------------------------------------------------------------------------
glm::dvec4 IntegrateSegments(const Scene& scene, const Ray& ray)
{
  if (ray.inside.entry >= ray.inside.exit)
  {
    return glm::dvec4(0.0);
  }
  SegmentRay segments(scene, ray);
  Place front = segments.PlaceAt(ray.inside.entry);
  for (double step = scene.firstSample; front.at < ray.inside.exit && !segments.IsFinished(); step += 1.0)
  {
    const double at = ray.inside.entry + step * scene.step;
    // what is left by rounding is no segment of its own
    const bool isLast = at + 1.0e-9 * scene.step >= ray.inside.exit;
    const Place back = segments.PlaceAt(isLast ? ray.inside.exit : at);
    segments.Add(front, back, LargestLevel);
    front = back;
  }
  return segments.Color();
}
}
