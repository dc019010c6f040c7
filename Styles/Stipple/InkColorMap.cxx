// SPDX-License-Identifier: BSD-3-Clause
#include "InkColorMap.h"

#include "InkColorNames.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"

#include <array>
#include <map>
#include <sstream>

namespace
{

using Color = std::array<double, 3>;

const std::map<std::string, std::vector<Color>>& ColorMaps()
{
  static const std::map<std::string, std::vector<Color>> maps{
    { "cool-warm", { { 0.23, 0.30, 0.75 }, { 0.50, 0.45, 0.45 }, { 0.71, 0.02, 0.15 } } },
    { "rainbow",
      { { 0.0, 0.0, 0.8 }, { 0.0, 0.6, 0.8 }, { 0.0, 0.6, 0.0 }, { 0.8, 0.6, 0.0 }, { 0.8, 0.0, 0.0 } } },
    { "viridis",
      { { 0.267, 0.005, 0.329 }, { 0.230, 0.322, 0.546 }, { 0.128, 0.567, 0.551 }, { 0.369, 0.789, 0.383 },
        { 0.993, 0.906, 0.144 } } },
  };
  return maps;
}

/// @param problem what is wrong, if anything is
std::vector<Color> ParseColorMap(const std::string& map, std::string& problem)
{
  if (const auto found = ColorMaps().find(map); found != ColorMaps().end())
  {
    return found->second;
  }
  std::vector<Color> colors;
  std::istringstream parts(map);
  for (std::string part; std::getline(parts, part, ',');)
  {
    const auto color = InkParseColor(part);
    if (!color && map.find(',') != std::string::npos)
    {
      problem = "expected a color name as in HTML, #rrggbb or #rgb, found '" + part + "'";
      return {};
    }
    colors.push_back(color.value_or(Color{}));
  }
  if (colors.size() < 2)
  {
    problem = "expected ";
    for (const auto& [name, known] : ColorMaps())
    {
      problem += name + ", ";
    }
    problem += "or two or more colors with commas, found '" + map + "'";
  }
  return colors;
}

} // namespace

std::string InkCheckColorMap(const std::string& map)
{
  std::string problem;
  if (!map.empty())
  {
    ParseColorMap(map, problem);
  }
  return problem;
}

vtkSmartPointer<vtkScalarsToColors> InkMakeColors(
  const std::string& map, const std::vector<double>& range, vtkDataArray* scalars)
{
  std::string problem;
  const std::vector<Color> chosen = ParseColorMap(map, problem);
  double found[2];
  scalars->GetFiniteRange(found, 0);
  const double least = range.empty() ? found[0] : range[0];
  const double greatest = range.empty() ? found[1] : range[1];
  auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
  colors->SetColorSpaceToLab();
  const auto last = static_cast<double>(chosen.size() - 1);
  // VTK's table for bytes is black where the first color is at a byte.
  const double below = 1e-6 * (greatest - least);
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    const Color& c = chosen[i];
    const double share = static_cast<double>(i) / last;
    colors->AddRGBPoint(least + (greatest - least) * share - (i == 0 ? below : 0.0), c[0], c[1], c[2]);
  }
  return colors;
}
