// SPDX-License-Identifier: BSD-3-Clause
// Hatching: how close the lines are from which strokes are taken, against the error of the gray that the
// strokes of a picture make of them, and against the time to trace them.

#include "HatchedHills.h"
#include "Tradeoff.h"

#include <cstdlib>
#include <string>

namespace
{

std::string Short(double number)
{
  std::string text = std::to_string(number);
  text.erase(text.find_last_not_of('0') + 1);
  text.erase(text.find_last_not_of('.') + 1);
  return text;
}

/// Tones at several zooms in windows that hold eight of the default's lines; from near also in the windows
/// that hold eight from far.
Tradeoff::Errors ErrorsOf(vtkPolyData* strokes)
{
  Tradeoff::Errors errors;
  for (const double tone : { 0.1, 0.4, 0.8 })
  {
    for (const int zoom : { 1, 2, 4 })
    {
      errors.emplace_back("tone " + Short(tone) + ", zoom " + std::to_string(zoom),
        100.0 * HatchedHills::ErrorsOf(strokes, tone, zoom, zoom * HatchedHills::Side).RootMeanSquare);
    }
  }
  for (const int zoom : { 2, 4 })
  {
    errors.emplace_back(
      "tone 0.4, zoom " + std::to_string(zoom) + ", windows of " + std::to_string(8 / zoom) + " lines",
      100.0 * HatchedHills::ErrorsOf(strokes, 0.4, zoom, HatchedHills::Side).RootMeanSquare);
  }
  return errors;
}

constexpr const char* ErrorUnit =
  "root mean square of the relative error of grays, %, in windows that are eight of the default's lines wide";

} // namespace

int main()
{
  Tradeoff::PrintHeader();
  const vtkSmartPointer<vtkPolyData> hills = HatchedHills::MakeHills();
  Tradeoff knob("LineSpacing (style line-art)",
    "Keep the default, lines as close as strokes are drawn: from near the gray is as right in windows that "
    "hold "
    "as many lines, and closer lines serve smaller ones.",
    ErrorUnit, "lines of a family on 28,800 triangles, strokes 6 pixels apart in a picture of 400 x 400");
  for (const double share : { 4.0, 2.0, 1.0, 0.5, 0.25 })
  {
    const vtkSmartPointer<vtkPolyData> strokes = HatchedHills::MakeStrokes(hills, share);
    knob.Add(
      Short(share) + " of the distance drawn", [=] { HatchedHills::MakeStrokes(hills, share); },
      ErrorsOf(strokes), share == 1.0 ? Tradeoff::Default : Tradeoff::Choice);
  }
  knob.Print(3);
  Tradeoff spacing("LocalSpacing (vtkInkHatching)",
    "Keep it on: real lines are closer here and wider there, and without it grays are, too.", ErrorUnit,
    "lines of a family on 28,800 triangles and their strokes, 6 pixels apart in a picture of 400 x 400");
  for (const bool local : { false, true })
  {
    const vtkSmartPointer<vtkPolyData> strokes = HatchedHills::MakeStrokes(hills, 1.0, local);
    spacing.Add(
      local ? "on" : "off, as published", [=] { HatchedHills::MakeStrokes(hills, 1.0, local); },
      ErrorsOf(strokes), local ? Tradeoff::Default : Tradeoff::Choice);
  }
  spacing.Print(3);
  return EXIT_SUCCESS;
}
