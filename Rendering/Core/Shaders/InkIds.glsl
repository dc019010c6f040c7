// SPDX-License-Identifier: BSD-3-Clause
// Hardware selection, as InkIdColors sets it.
uniform int idShift;    // the first of the id's 24 bits to show; negative: show propColor
uniform vec3 propColor;

vec4 idColor(int id)
{
  int shown = id >> max(idShift, 0);
  vec3 color = vec3(float(shown & 255), float((shown >> 8) & 255), float((shown >> 16) & 255)) / 255.0;
  return vec4(idShift < 0 ? propColor : color, 1.0);
}
