// SPDX-License-Identifier: BSD-3-Clause
#include "InkColorNames.h"

#include "vtkNamedColors.h"
#include "vtkNew.h"

#include <regex>

std::optional<std::array<double, 3>> InkParseColor(const std::string& text)
{
  static const std::regex hexadecimal("#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})");
  std::array<double, 3> color;
  if (std::regex_match(text, hexadecimal))
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
