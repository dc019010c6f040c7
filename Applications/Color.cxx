#include "Color.h"

#include "Errors.h"

#include "vtkNamedColors.h"
#include "vtkNew.h"

#include <regex>

namespace ink::cli
{

Color parseColor(const std::string& option, const std::string& text)
{
  static const std::regex hexadecimal("#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})");
  vtkNew<vtkNamedColors> colors;
  Color color;
  if (std::regex_match(text, hexadecimal))
  {
    const std::size_t digits = (text.size() - 1) / 3;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const int value = std::stoi(text.substr(1 + i * digits, digits), nullptr, 16);
      color[i] = value / (digits == 1 ? 15.0 : 255.0);
    }
  }
  else if (colors->ColorExists(text))
  {
    colors->GetColorRGB(text, color.data());
  }
  else
  {
    throw UsageError(option + " '" + text + "': expected a color name as in HTML, #rrggbb or #rgb");
  }
  return color;
}

} // namespace ink::cli
