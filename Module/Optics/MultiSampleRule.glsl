// SPDX-FileCopyrightText: VolumeOptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Colour and opacity by a scalar and the two beside it along the gradient [Lum2004, section 7 and
// figure 11]. The paper shows a picture and no formula: these are ours. After SoftRange.glsl.

struct ClassifiedSample
{
  vec3 color;    // not multiplied by the opacity
  float opacity; // in [0, 1]
};

// How much a rule holds: 1 where each of (S, S1, S2) is in its range. The ends as in SoftRange().
float RuleWeight(vec3 samples, vec3 low, vec3 high, vec3 softness)
{
  return SoftRange(samples.x, low.x, high.x, softness.x) * SoftRange(samples.y, low.y, high.y, softness.y) *
    SoftRange(samples.z, low.z, high.z, softness.z);
}

// What was classified so far, replaced by a rule to the degree `weight` in [0, 1]. Opacities are
// mixed, and colours with their opacities, so that what is transparent has no say in the colour.
ClassifiedSample ApplyRule(ClassifiedSample former, ClassifiedSample rule, float weight)
{
  float formerShare = (1.0 - weight) * former.opacity;
  float ruleShare = weight * rule.opacity;
  ClassifiedSample mixed;
  mixed.opacity = formerShare + ruleShare;
  float share = mixed.opacity > 0.0 ? ruleShare / mixed.opacity : weight;
  mixed.color = former.color * (1.0 - share) + rule.color * share;
  return mixed;
}
