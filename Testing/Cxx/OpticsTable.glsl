// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Each formula of Module/Optics behind one signature, for tests that run all of them in double, in
// float and on the GPU; compiled as GLSL and as C++, by the rules of Module/Optics.
// TestedFunctions.h names the numbers and says how near the results must be.

struct FunctionInput
{
  vec3 normal;
  vec3 toLight;
  vec3 toViewer;
  vec3 major;
  vec3 p; // the scalar arguments, in their order
};

vec4 ThreeNumbers(vec3 v)
{
  return vec4(v.x, v.y, v.z, 0.0);
}

vec4 TwoNumbers(vec2 v)
{
  return vec4(v.x, v.y, 0.0, 0.0);
}

vec4 OneNumber(float x)
{
  return vec4(x, 0.0, 0.0, 0.0);
}

vec4 EvaluateScalars(int function, vec3 p)
{
  if (function == 0)
  {
    return OneNumber(HenyeyGreenstein(p.x, p.y));
  }
  if (function == 1)
  {
    return OneNumber(OneMinusExp(p.x));
  }
  if (function == 2)
  {
    return OneNumber(OpticalDepth(p.x));
  }
  if (function == 3)
  {
    return OneNumber(BoundedOpticalDepth(p.x));
  }
  if (function == 4)
  {
    return OneNumber(OpacityForLength(p.x, p.y));
  }
  if (function == 5)
  {
    return OneNumber(SpecularCoefficient(p.x, p.y, p.z));
  }
  if (function == 6)
  {
    return OneNumber(WardMajorRoughness(p.x, p.y, p.z));
  }
  if (function == 7)
  {
    return OneNumber(LafortuneMajorWeight(p.x, p.y));
  }
  if (function == 8)
  {
    return TwoNumbers(WithoutSamplingNoise(vec2(p.x, p.y), p.z));
  }
  return OneNumber(LogRatio(p.x)); // 9
}

vec4 EvaluateReflectance(int function, FunctionInput i)
{
  vec3 minor = cross(i.normal, i.major);
  if (function == 10)
  {
    return OneNumber(BlinnPhongReflection(i.normal, i.toLight, i.toViewer, i.p.x));
  }
  if (function == 11)
  {
    return OneNumber(WardReflection(i.normal, i.major, minor, i.toLight, i.toViewer, i.p.x, i.p.y));
  }
  return OneNumber(LafortuneReflection(i.normal, i.major, minor, i.toLight, i.toViewer, i.p.x, i.p.y)); // 12
}

vec4 EvaluateFrame(int function, FunctionInput i)
{
  vec2 anisotropy = vec2(i.p.x, i.p.y);
  if (function == 13)
  {
    return ThreeNumbers(SphericalBasis(i.normal).theta);
  }
  if (function == 14)
  {
    return ThreeNumbers(SphericalBasis(i.normal).phi);
  }
  if (function == 15)
  {
    return ThreeNumbers(EncodeMap(i.normal, anisotropy));
  }
  if (function == 16)
  {
    return TwoNumbers(DecodeMap(i.normal, i.p));
  }
  if (function == 17)
  {
    return ThreeNumbers(EncodeComponents(anisotropy));
  }
  if (function == 18)
  {
    return TwoNumbers(DecodeComponents(EncodeComponents(anisotropy)));
  }
  if (function == 19)
  {
    WorldTensor code = EncodeWorld(i.normal, anisotropy);
    return vec4(code.diagonal.x, code.diagonal.z, code.mixed.x, code.mixed.y);
  }
  if (function == 20)
  {
    return TwoNumbers(DecodeWorld(i.normal, EncodeWorld(i.normal, anisotropy)));
  }
  AnisotropyFrame frame = EigenFrame(i.normal, anisotropy);
  if (function == 21)
  {
    return vec4(frame.major.x, frame.major.y, frame.major.z, frame.logRatio);
  }
  return ThreeNumbers(frame.minor); // 22
}

vec4 EvaluateOpacityInDataSpace(int function, vec3 p)
{
  if (function == 23)
  {
    return OneNumber(OpacityOverDepth(p.x));
  }
  if (function == 24)
  {
    return OneNumber(SegmentOpacity(p.x, p.y));
  }
  if (function == 25)
  {
    return OneNumber(OpacityForScalarStep(p.x, p.y));
  }
  if (function == 26)
  {
    return OneNumber(SilhouetteOpacity(p.x, p.y, p.z));
  }
  if (function == 27)
  {
    return OneNumber(ClampedSilhouetteOpacity(p.x, p.y, p.z));
  }
  if (function == 28)
  {
    return OneNumber(SurfaceSilhouetteOpacity(p.x, p.y));
  }
  return OneNumber(ClampedSurfaceOpacity(p.x, p.y)); // 29
}

vec4 EvaluateInDataSpace(int function, FunctionInput i)
{
  if (function < 30)
  {
    return EvaluateOpacityInDataSpace(function, i.p);
  }
  if (function == 30)
  {
    return OneNumber(ScalarStep(i.normal, i.p));
  }
  if (function == 31)
  {
    return OneNumber(ShareBehind(i.normal, i.toLight, i.toViewer));
  }
  if (function == 32)
  {
    return TwoNumbers(TransmittedLight(i.normal, i.toLight, i.toViewer, i.p.x));
  }
  if (function == 33)
  {
    return OneNumber(TransmittedShare(i.p.x, i.p.y, i.p.z));
  }
  if (function == 34)
  {
    return vec4(CrossesIsovalue(i.p.x, i.p.y, i.p.z) ? 1.0 : 0.0, CrossingFraction(i.p.x, i.p.y, i.p.z), 0.0, 0.0);
  }
  return OneNumber(TableCoordinate(i.p.x, i.p.y)); // 35
}

vec4 EvaluateScalarPair(int function, FunctionInput i)
{
  if (function == 36)
  {
    return OneNumber(SoftRange(i.p.x, i.p.y, i.p.z, i.major.x));
  }
  if (function == 37)
  {
    return OneNumber(RuleWeight(i.p, i.normal, i.toLight, i.toViewer));
  }
  if (function == 39)
  {
    return OneNumber(HybridSide(i.p.x, i.p.y));
  }
  ClassifiedSample former;
  former.color = i.normal;
  former.opacity = i.p.x;
  ClassifiedSample rule;
  rule.color = i.toLight;
  rule.opacity = i.p.y;
  ClassifiedSample mixed = ApplyRule(former, rule, i.p.z); // 38
  return vec4(mixed.color.x, mixed.color.y, mixed.color.z, mixed.opacity);
}

// normal is the cylinder's tangent.
vec4 EvaluateLines(int function, FunctionInput i)
{
  if (function == 40)
  {
    return OneNumber(SphericalHarmonic(int(i.p.x), int(i.p.y), i.normal));
  }
  if (function == 41)
  {
    return OneNumber(SineMoment(int(i.p.x), i.p.y));
  }
  if (function == 42)
  {
    return OneNumber(CosinePowerIntegral(i.p.x, i.p.y));
  }
  CylinderView view = ViewOfCylinder(i.normal, i.toViewer);
  if (function == 43)
  {
    return OneNumber(DiffuseOfCylinder(view, i.toLight));
  }
  if (function == 44)
  {
    return OneNumber(SpecularOfCylinder(view, i.toLight, i.toViewer, i.p.x));
  }
  return TwoNumbers(DepthBounds(i.p.x, i.p.y)); // 45
}

vec4 OneRay(ConeRay ray)
{
  return vec4(ray.slope.x, ray.slope.y, ray.cosine, 0.0);
}

vec4 EvaluateVisibility(int function, FunctionInput i)
{
  if (function == 46)
  {
    return OneRay(ConeDirection(int(i.p.x), int(i.p.y), i.p.z));
  }
  if (function == 47)
  {
    return OneNumber(IsOnDisk(int(i.p.x), int(i.p.y)) ? 1.0 : 0.0);
  }
  if (function == 48)
  {
    return OneRay(DiskDirection(int(i.p.x), int(i.p.y), i.p.z));
  }
  if (function == 49)
  {
    return OneNumber(SolidAngleOfDisk(i.p.x));
  }
  if (function == 50)
  {
    return OneNumber(StretchTransmittance(i.p.x, i.p.y));
  }
  vec2 place = vec2(i.normal.x, i.normal.y);
  return TwoNumbers(PlaceOnSlice(place, vec2(i.major.x, i.major.y), i.p.x, i.p.y, i.p.z)); // 51
}

// Depths and scales; light, its mean, least and largest colour.
vec4 EvaluateLineVoxel(int function, FunctionInput i)
{
  if (function == 52)
  {
    return OneNumber(DepthOfLines(i.p.x, i.p.y, i.p.z, i.major.x, i.major.y));
  }
  vec3 color = ColorOfLines(i.normal, i.p.x, i.toLight, i.p.y, i.toViewer, i.major); // 53
  return vec4(color.x, color.y, color.z, 0.0);
}

vec4 EvaluateLast(int function, FunctionInput i)
{
  if (function == 54)
  {
    return OneNumber(StretchVisibility(i.p.x, i.p.y));
  }
  return OneNumber(function == 55 ? MeanWayOut(i.p.x) : MeanDepthOfShare(i.p.x)); // 55, 56
}

vec4 EvaluateGathering(int function, FunctionInput i)
{
  if (function == 57)
  {
    vec3 way = TurnToAxis(i.normal, i.toViewer);
    return vec4(way.x, way.y, way.z, 0.0);
  }
  return function == 58 ? TwoNumbers(SlopeOfWay(i.normal)) : OneNumber(FirstPartOfRay(int(i.p.x))); // 58, 59
}

vec4 Evaluate(int function, FunctionInput i)
{
  if (function < 10)
  {
    return EvaluateScalars(function, i.p);
  }
  if (function < 13)
  {
    return EvaluateReflectance(function, i);
  }
  if (function < 23)
  {
    return EvaluateFrame(function, i);
  }
  if (function < 36)
  {
    return EvaluateInDataSpace(function, i);
  }
  if (function < 40)
  {
    return EvaluateScalarPair(function, i);
  }
  if (function < 46)
  {
    return EvaluateLines(function, i);
  }
  if (function < 52)
  {
    return EvaluateVisibility(function, i);
  }
  if (function < 54)
  {
    return EvaluateLineVoxel(function, i);
  }
  return function < 57 ? EvaluateLast(function, i) : EvaluateGathering(function, i);
}
