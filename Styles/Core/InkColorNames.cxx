// SPDX-License-Identifier: BSD-3-Clause
#include "InkColorNames.h"

#include "vtkNamedColors.h"
#include "vtkNew.h"

#include <algorithm>
#include <cctype>

std::optional<std::array<double, 3>> InkParseColor(const std::string& text)
{
  std::array<double, 3> color;
  // #RGB or #RRGGBB
  if ((text.size() == 4 || text.size() == 7) && text[0] == '#' &&
    std::all_of(text.begin() + 1, text.end(), [](unsigned char digit) { return std::isxdigit(digit); }))
  {
    const std::size_t digits = (text.size() - 1) / 3;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const int value = std::stoi(text.substr(1 + i * digits, digits), nullptr, 16);
      color[i] = value / (digits == 1 ? 15.0 : 255.0);
    }
    return color;
  }
  vtkNew<vtkNamedColors> colors;
  if (!colors->ColorExists(text))
  {
    return std::nullopt;
  }
  colors->GetColorRGB(text, color.data());
  return color;
}
