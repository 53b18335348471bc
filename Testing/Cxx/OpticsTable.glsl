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

// normal is the cylinder's tangent.
vec4 EvaluateLines(int function, FunctionInput i)
{
  if (function == 23)
  {
    return OneNumber(SphericalHarmonic(int(i.p.x), int(i.p.y), i.normal));
  }
  if (function == 24)
  {
    return OneNumber(SineMoment(int(i.p.x), i.p.y));
  }
  if (function == 25)
  {
    return OneNumber(CosinePowerIntegral(i.p.x, i.p.y));
  }
  CylinderView view = ViewOfCylinder(i.normal, i.toViewer);
  if (function == 26)
  {
    return OneNumber(DiffuseOfCylinder(view, i.toLight));
  }
  if (function == 27)
  {
    return OneNumber(SpecularOfCylinder(view, i.toLight, i.toViewer, i.p.x));
  }
  return TwoNumbers(DepthBounds(i.p.x, i.p.y)); // 28
}

vec4 Evaluate(int function, FunctionInput i)
{
  if (function > 22)
  {
    return EvaluateLines(function, i);
  }
  if (function < 10)
  {
    return EvaluateScalars(function, i.p);
  }
  return function < 13 ? EvaluateReflectance(function, i) : EvaluateFrame(function, i);
}
