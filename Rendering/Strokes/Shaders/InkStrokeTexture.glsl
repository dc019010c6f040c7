// SPDX-License-Identifier: BSD-3-Clause
// An image along a stroke and across it.

uniform sampler2D strokeTexture;
uniform float textureLength; // of arc length, for the width of the image

// The image at a pixel. The stroke's own segment goes in a direction on the picture, by so many pixels for each unit of
// its arc length; away: from the nearest point of the segment; beyond: how far past a free end, pixels.
vec4 strokeTexel(float arcLength, float whole, float scale, float halfWidth, vec2 direction, vec2 away, float beyond)
{
  // Closed strokes have whole images.
  float fitted = whole > 0.0 ? whole / max(round(whole / textureLength), 1.0) : textureLength;
  float perPixel = scale > 0.0 ? 1.0 / (scale * fitted) : 0.0;
  vec2 across = vec2(-direction.y, direction.x);
  float side = dot(away, across) < 0.0 ? -1.0 : 1.0;
  float distance = beyond == 0.0 ? side * length(away) : dot(away, across);
  vec2 place = vec2(arcLength / fitted + beyond * perPixel, clamp(0.5 + 0.5 * distance / halfWidth, 0.0, 1.0));
  // As on a straight stroke: nothing jumps where segments meet.
  vec2 alongStep = direction * perPixel;
  vec2 acrossStep = across * (0.5 / halfWidth);
  return textureGrad(strokeTexture, place, vec2(alongStep.x, acrossStep.x), vec2(alongStep.y, acrossStep.y));
}
