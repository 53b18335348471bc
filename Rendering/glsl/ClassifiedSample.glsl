// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Place ComputeLighting::Dec, last. Colour and opacity by S, S1 and S2: what VTK's transfer functions give
// is replaced by one rule after the other.

const int opticsNumbersOfRule = 4; // low ends and opacity, high ends, softness, colour

uniform int in_opticsNumberOfRules;
uniform vec4 in_opticsRules[32 * opticsNumbersOfRule];
uniform float in_opticsUnitDistance;

float g_opticsFormerShare; // of the transfer functions' colour
vec3 g_opticsRuleColor;    // of the rules, times their share

float opticsClassifiedOpacity(vec4 scalar, float formerOpacity)
{
  g_opticsScalar = scalar;
  vec2 pair = opticsScalarPair(g_dataPos, opticsScalarGradient(g_dataPos));
  vec3 samples = vec3(dot(scalar, in_opticsOpacityChannel), pair);
  // the former colour is not known yet: its share is found with a white one
  ClassifiedSample former = ClassifiedSample(vec3(1.0), formerOpacity);
  ClassifiedSample rules = ClassifiedSample(vec3(0.0), formerOpacity);
  for (int i = 0; i < opticsNumbersOfRule * in_opticsNumberOfRules; i += opticsNumbersOfRule)
  {
    vec4 low = in_opticsRules[i];
    float weight = RuleWeight(samples, low.xyz, in_opticsRules[i + 1].xyz, in_opticsRules[i + 2].xyz);
    float opacity = OpacityForLength(low.w, in_sampleDistance / in_opticsUnitDistance);
    former = ApplyRule(former, ClassifiedSample(vec3(0.0), opacity), weight);
    rules = ApplyRule(rules, ClassifiedSample(in_opticsRules[i + 3].xyz, opacity), weight);
  }
  g_opticsFormerShare = former.color.x;
  g_opticsRuleColor = rules.color;
  return rules.opacity;
}

vec4 opticsLightClassified(vec4 color, int component, float label)
{
  vec3 classified = color.rgb * g_opticsFormerShare + g_opticsRuleColor;
  vec4 lit = computeLighting(vec4(classified, color.a), component, label);
  return lit;
}
