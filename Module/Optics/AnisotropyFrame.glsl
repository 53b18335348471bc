// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The tangent frame of anisotropy and the three ways to store it.
//
// Of the covariance matrix C in the tangent plane ([Ament2015] eq. 23) only its direction and the
// ratio of its eigenvalues matter: with respect to the basis (theta, phi) of the plane they are
//   a1 = (Ctt - Cpp)/(Ctt + Cpp),  a2 = 2 Ctp/(Ctt + Cpp),
// strength |a| = (l2 - l1)/(l2 + l1) in [0, 1], angle of the major axis from theta: atan(a2, a1)/2.

// Ratios above (1 + s)/(1 - s) = 1999 count as this one, so that their logarithm is finite.
const float LargestStrength = 0.999;

// Orthonormal basis of the plane across a unit normal: theta runs south, phi runs east. They are
// eta2 and eta1 of [Ament2015] eqs 20, 21.
struct TangentBasis
{
  vec3 theta;
  vec3 phi;
};

struct AnisotropyFrame
{
  vec3 major;     // unit, U of [Ament2015] eq. 31
  vec3 minor;     // unit, V
  float logRatio; // ln(l2 / l1) >= 0
};

// Lengths below this count as 0: their squares are no longer exact in float, and a direction that is
// divided by such a length would not be a unit vector.
const float SmallestLength = 1.0e-16;

// Cosine and sine of the azimuth; (1, 0) at the poles, as [Ament2015] chooses.
vec2 Azimuth(vec3 normal)
{
  float rho = sqrt(normal.x * normal.x + normal.y * normal.y);
  return rho > SmallestLength ? vec2(normal.x / rho, normal.y / rho) : vec2(1.0, 0.0);
}

// normal: unit.
TangentBasis SphericalBasis(vec3 normal)
{
  vec2 azimuth = Azimuth(normal);
  float rho = sqrt(normal.x * normal.x + normal.y * normal.y);
  TangentBasis basis;
  basis.theta = vec3(normal.z * azimuth.x, normal.z * azimuth.y, -rho);
  basis.phi = vec3(-azimuth.y, azimuth.x, 0.0);
  return basis;
}

// Basis of the map's image: the tangent plane at w^2, where w is the stereographic image of the
// normal. It turns by twice the azimuth, as a line field does, and so it has no pole.
TangentBasis SquaredBasis(vec3 normal)
{
  vec2 azimuth = Azimuth(normal);
  float zz = normal.z * normal.z;
  float cosTheta = 2.0 * normal.z / (1.0 + zz);
  float sinTheta = (1.0 - zz) / (1.0 + zz);
  float cos2 = azimuth.x * azimuth.x - azimuth.y * azimuth.y;
  float sin2 = 2.0 * azimuth.x * azimuth.y;
  TangentBasis basis;
  basis.theta = vec3(cosTheta * cos2, cosTheta * sin2, -sinTheta);
  basis.phi = vec3(-sin2, cos2, 0.0);
  return basis;
}

// Map: three numbers in [-1, 1], continuous in the normal everywhere. They belong to the normal's
// sign: for -normal the same directions in space have the code (-x, -y, z).
vec3 EncodeMap(vec3 normal, vec2 anisotropy)
{
  TangentBasis image = SquaredBasis(normal);
  return anisotropy.x * image.theta + anisotropy.y * image.phi;
}

vec2 DecodeMap(vec3 normal, vec3 code)
{
  TangentBasis image = SquaredBasis(normal);
  return vec2(dot(code, image.theta), dot(code, image.phi));
}

// Components: (C11, C12, C22)/trace in (eta1, eta2), what [Ament2015] stores. Its basis jumps at the
// poles, and with it the numbers: kept for comparison.
vec3 EncodeComponents(vec2 anisotropy)
{
  return vec3(0.5 - 0.5 * anisotropy.x, 0.5 * anisotropy.y, 0.5 + 0.5 * anisotropy.x);
}

vec2 DecodeComponents(vec3 code)
{
  float trace = max(code.x + code.z, 1.0e-6);
  return vec2((code.z - code.x) / trace, 2.0 * code.y / trace);
}

// World: the traceless tensor a1 (tt - pp) + a2 (tp + pt) in world axes, free of the normal's sign.
struct WorldTensor
{
  vec3 diagonal; // xx, yy, xy
  vec2 mixed;    // xz, yz
};

WorldTensor EncodeWorld(vec3 normal, vec2 anisotropy)
{
  TangentBasis basis = SphericalBasis(normal);
  vec3 t = basis.theta;
  vec3 p = basis.phi;
  WorldTensor code;
  code.diagonal = anisotropy.x * vec3(t.x * t.x - p.x * p.x, t.y * t.y - p.y * p.y, t.x * t.y - p.x * p.y) +
    anisotropy.y * vec3(2.0 * t.x * p.x, 2.0 * t.y * p.y, t.x * p.y + t.y * p.x);
  code.mixed = anisotropy.x * vec2(t.x * t.z - p.x * p.z, t.y * t.z - p.y * p.z) +
    anisotropy.y * vec2(t.x * p.z + t.z * p.x, t.y * p.z + t.z * p.y);
  return code;
}

vec3 TimesVector(WorldTensor tensor, vec3 v)
{
  float zz = -tensor.diagonal.x - tensor.diagonal.y;
  return vec3(tensor.diagonal.x * v.x + tensor.diagonal.z * v.y + tensor.mixed.x * v.z,
    tensor.diagonal.z * v.x + tensor.diagonal.y * v.y + tensor.mixed.y * v.z,
    tensor.mixed.x * v.x + tensor.mixed.y * v.y + zz * v.z);
}

vec2 DecodeWorld(vec3 normal, WorldTensor code)
{
  TangentBasis basis = SphericalBasis(normal);
  vec3 alongTheta = TimesVector(code, basis.theta);
  vec3 alongPhi = TimesVector(code, basis.phi);
  return vec2((dot(basis.theta, alongTheta) - dot(basis.phi, alongPhi)) / 2.0, dot(basis.theta, alongPhi));
}

// Strength of a random isotropic disk of `count` points is 1/sqrt(count) on average: take it off.
vec2 WithoutSamplingNoise(vec2 anisotropy, float count)
{
  float squared = anisotropy.x * anisotropy.x + anisotropy.y * anisotropy.y;
  float kept = count * squared > 1.25 ? 1.0 - 1.25 / (count * squared) : 0.0;
  return anisotropy * kept;
}

// ln((1 + |a|)/(1 - |a|)) = ln(l2/l1).
float LogRatio(float strength)
{
  float s = min(strength, LargestStrength);
  return log((1.0 + s) / (1.0 - s));
}

// The eigenvectors by a half angle, without a case for C12 = 0 ([Ament2015] eqs 26-31 need one).
// normal: unit; anisotropy: as decoded. Zero anisotropy gives some frame and a ratio of 1.
AnisotropyFrame EigenFrame(vec3 normal, vec2 anisotropy)
{
  float strength = sqrt(anisotropy.x * anisotropy.x + anisotropy.y * anisotropy.y);
  float cosTwice = strength > SmallestLength ? anisotropy.x / strength : 1.0;
  float sinTwice = strength > SmallestLength ? anisotropy.y / strength : 0.0;
  // the larger of cosine and sine by the root, the other by division: the root of a small difference
  // would leave half of the digits
  float larger = sqrt(0.5 + 0.5 * abs(cosTwice));
  float smaller = 0.5 * abs(sinTwice) / larger;
  float cosine = cosTwice < 0.0 ? smaller : larger;
  float sine = cosTwice < 0.0 ? larger : smaller;
  if (sinTwice < 0.0)
  {
    sine = -sine;
  }
  TangentBasis basis = SphericalBasis(normal);
  AnisotropyFrame frame;
  frame.major = cosine * basis.theta + sine * basis.phi;
  frame.minor = cosine * basis.phi - sine * basis.theta;
  frame.logRatio = LogRatio(strength);
  return frame;
}
