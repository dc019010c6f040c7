#pragma once

#include "Color.h"
#include "Input.h"

#include "vtkInkStippleGenerator.h"
#include "vtkInkStippleMapper.h"
#include "vtkSmartPointer.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkPolyData;

namespace ink::cli
{

class Progress;

/// Scalars shown as colors.
struct ScalarColors
{
  std::vector<Color> colors;                  ///< evenly spread over the range, at least two
  std::string array;                          ///< empty: the active scalars
  std::optional<std::array<double, 2>> range; ///< none: that of the stippled elements
};

/// What a stipple drawing was asked for.
struct StippleStyle
{
  /// Set up but for their input; lengths in pixels are those that are rendered.
  vtkSmartPointer<vtkInkStippleGenerator> generator;
  vtkSmartPointer<vtkInkStippleMapper> mapper;
  Color paper;
  double lightAzimuth;   ///< degrees to the viewer's right
  double lightElevation; ///< degrees above the viewer
  std::optional<ScalarColors> scalarColors;
  std::optional<std::string> volumeOption; ///< one that was given and that meshes do not have
  bool listLengthGiven = false;            ///< the generator's MaximumStipples
  bool roomGiven = false;                  ///< the mapper's PixelsPerStipple
};

/// Makes the stipples of what was read and hands them to the style's mapper.
/// \param isoValues of a volume: surfaces that hide what lies behind them; empty: none do
/// \param samples on a mesh; none: as many as it has room for
/// \param pixels of the subject's largest side, as it is rendered
/// \return at least one stipple
/// \throw UsageError for options that do not go with the input, Failure if there is nothing to draw
vtkSmartPointer<vtkPolyData> makeStipples(const Input& input, const StippleStyle& style,
  std::vector<double> isoValues, std::optional<long long> samples, double pixels,
  std::vector<std::string>& notes, Progress& progress);

} // namespace ink::cli
