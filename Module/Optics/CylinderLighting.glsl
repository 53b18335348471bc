// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Light from a thin cylinder, averaged over the side that is seen, after [Schussman2004] section 4.
// tangent T, toLight L, toViewer V: unit. The normals of the visible side are
// n(t) = N cos t + B sin t, t in [-pi/2, pi/2].

const float QuarterTurn = 1.57079632679489661923;

// Lengths below this count as 0: the angle of such a vector is noise.
const float ShortestProjection = 1.0e-6;

struct CylinderView
{
  vec3 normal;   // N: the surface normal nearest to the viewer
  vec3 binormal; // B = T x N
  float sine;    // of the angle between T and V
};

// Seen end-on, where no area is visible, N is some normal.
CylinderView ViewOfCylinder(vec3 tangent, vec3 toViewer)
{
  vec3 across = toViewer - dot(toViewer, tangent) * tangent;
  CylinderView view;
  view.sine = length(across);
  vec3 axis = abs(tangent.z) < 0.8 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0);
  view.normal = view.sine > ShortestProjection ? across / view.sine : normalize(cross(tangent, axis));
  view.binormal = cross(tangent, view.normal);
  return view;
}

// Eq. 3. radius, segmentLength: world, >= 0.
float VisibleArea(float radius, float segmentLength, float sine)
{
  return 2.0 * radius * segmentLength * sine;
}

// Where the surface is both visible and lit, eq. 5. A light along T, which grazes all of it, counts as
// lighting the whole side.
vec2 LitInterval(CylinderView view, vec3 toLight)
{
  float x = dot(toLight, view.normal);
  float y = dot(toLight, view.binormal);
  float angle = x * x + y * y > ShortestProjection * ShortestProjection ? atan(y, x) : 0.0;
  return vec2(max(-QuarterTurn, angle - QuarterTurn), min(QuarterTurn, angle + QuarterTurn));
}

// Eq. 11 for diffuse coefficient and light 1: in [0, pi/4].
float DiffuseOfCylinder(CylinderView view, vec3 toLight)
{
  vec2 t = LitInterval(view, toLight);
  float along = sin(2.0 * t.y) - sin(2.0 * t.x) + 2.0 * (t.y - t.x);
  float across = cos(2.0 * t.y) - cos(2.0 * t.x);
  return max((dot(toLight, view.normal) * along - dot(toLight, view.binormal) * across) / 8.0, 0.0);
}

// The half vector's projection on the plane across T, and the interval of u = t - beta.
struct CylinderHighlight
{
  float height; // |Hp|
  float cosBeta;
  float sinBeta;
  float from;
  float to;
};

// n.H >= 0 where the surface is visible and lit, so u is within [-pi/2, pi/2]. (The bounds are
// t - beta; eq. 17 prints t + beta for one of the integrals.)
CylinderHighlight HighlightOfCylinder(CylinderView view, vec3 toLight, vec3 toViewer)
{
  vec3 between = toLight + toViewer;
  float size = max(length(between), ShortestProjection);
  float x = dot(between, view.normal) / size;
  float y = dot(between, view.binormal) / size;
  CylinderHighlight highlight;
  highlight.height = min(sqrt(x * x + y * y), 1.0);
  float inverse = highlight.height > ShortestProjection ? 1.0 / highlight.height : 0.0;
  highlight.cosBeta = x * inverse;
  highlight.sinBeta = y * inverse;
  float beta = inverse > 0.0 ? atan(y, x) : 0.0;
  vec2 t = LitInterval(view, toLight);
  highlight.from = clamp(t.x - beta, -QuarterTurn, QuarterTurn);
  highlight.to = clamp(t.y - beta, -QuarterTurn, QuarterTurn);
  return highlight;
}

float CosinePower(float angle, float exponent)
{
  return pow(max(cos(angle), 0.0), exponent);
}

// Gauss's rule with five points on [from, from + width].
float CosinePowerPanel(float exponent, float from, float width)
{
  float center = from + 0.5 * width;
  float inner = 0.26923465505284154552 * width;
  float outer = 0.45308992296933199640 * width;
  float ends = CosinePower(center - outer, exponent) + CosinePower(center + outer, exponent);
  float middle = CosinePower(center - inner, exponent) + CosinePower(center + inner, exponent);
  return width * (0.28444444444444444444 * CosinePower(center, exponent) +
    0.23931433524968323402 * middle + 0.11846344252809454376 * ends);
}

// Integral of cos^exponent from 0 to the angle, F of eq. 17. exponent in [1, 1001]; angle in
// [-pi/2, pi/2]; within 1e-8 of the whole integral. What lies beyond the reach is below 1e-17.
float CosinePowerIntegral(float exponent, float angle)
{
  float reach = min(abs(angle), sqrt(80.0 / exponent));
  float width = reach / 10.0;
  float sum = 0.0;
  for (int i = 0; i < 10; ++i)
  {
    sum += CosinePowerPanel(exponent, float(i) * width, width);
  }
  return angle < 0.0 ? -sum : sum;
}

// Eq. 17 for specular coefficient and light 1. integral: of cos^(exponent + 1) over [from, to].
float SpecularOfHighlight(CylinderHighlight highlight, float exponent, float integral)
{
  float ends = CosinePower(highlight.to, exponent + 1.0) - CosinePower(highlight.from, exponent + 1.0);
  float sum = highlight.cosBeta * integral + highlight.sinBeta * ends / (exponent + 1.0);
  return highlight.height > ShortestProjection ? 0.5 * pow(highlight.height, exponent) * max(sum, 0.0) : 0.0;
}

// Eq. 4 with Blinn's highlight, exponent in [1, 1000]. 0 where the half vector lies along T.
float SpecularOfCylinder(CylinderView view, vec3 toLight, vec3 toViewer, float exponent)
{
  CylinderHighlight highlight = HighlightOfCylinder(view, toLight, toViewer);
  float integral =
    CosinePowerIntegral(exponent + 1.0, highlight.to) - CosinePowerIntegral(exponent + 1.0, highlight.from);
  return SpecularOfHighlight(highlight, exponent, integral);
}

// Optical depth of segments with the visible area in a box of the surface: the mean area that a convex
// body shows is a quarter of its surface, so the box stops area/(surface/4) of the rays. The limit of
// eq. 7 for many thin lines.
float DepthOfVisibleArea(float area, float surface)
{
  return 4.0 * area / surface;
}

// Mean over all directions of -ln(1 - q sine), the depth of a cylinder that covers the share q of a box's
// mean cross section from the side, [Schussman2004] eq. 7. q in [0, 1]. In closed form; below 0.1, where
// that would cancel, the series of the sine's moments.
float MeanDepthOfShare(float q)
{
  if (q < 0.1)
  {
    return q * (0.78539816339744830962 + q * (0.33333333333333333333 + q * (0.19634954084936207740 +
      q * (0.13333333333333333333 + q * (0.09817477042468103870 + q * 0.07619047619047619048)))));
  }
  float across = sqrt(1.0 - q * q);
  return 1.0 + (QuarterTurn - across * (QuarterTurn + atan(q, across))) / q;
}

// Least and largest depth that segments can have in a direction V, told from the parts of degree 0 and
// 2 of their depth's series, evaluated at V. With Q = sum q_i and m = sum q_i (V.T_i)^2 / Q the depth
// sum q_i sqrt(1 - (V.T_i)^2) is in [Q (1 - m), Q sqrt(1 - m)]: sine >= its square, and Jensen's
// inequality. Degree 0 is Q pi/4, degree 2 is -5 pi/32 sum q_i P_2(V.T_i).
vec2 DepthBounds(float degree0, float degree2)
{
  float whole = max(degree0, 0.0) * 2.0 / QuarterTurn;
  float ratio = degree0 > 0.0 ? degree2 / degree0 : 0.0;
  float across = clamp(2.0 / 3.0 + ratio * 16.0 / 15.0, 0.0, 1.0);
  return vec2(whole * across, whole * sqrt(across));
}
