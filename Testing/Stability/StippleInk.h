// SPDX-License-Identifier: BSD-3-Clause
#ifndef StippleInk_h
#define StippleInk_h

#include "InkTestChecks.h"
#include "InkTestImage.h"
#include "StippleScene.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStringOutputWindow.h"

#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string>
#include <vector>

/// How much ink the stipple mapper's pictures have: what the tests of its extremes share.
namespace StippleInk
{

inline constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double Infinity = std::numeric_limits<double>::infinity();

using Data = vtkSmartPointer<vtkPolyData>;
using Change = std::function<void(StippleScene&)>;

/// The ink of the data's picture in a window of 120 x 120 pixels. Places in either precision give the same.
/// @param words that the one message has to contain; empty: there must be none
inline double FindInk(
  InkTestChecks& check, const std::string& name, vtkPolyData* data,
  const Change& change = [](StippleScene&) {}, const std::vector<std::string>& words = {})
{
  StippleScene scene(data, 120, 120);
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  change(scene);
  const InkTestImage image(scene.Window);
  // Neither again by another picture nor by a question is anything said twice.
  vtkNew<vtkFloatArray> marks;
  const bool found = scene.Mapper->EvaluateMarks(scene.Renderer, scene.Actor, marks);
  check(found || image.Ink() == 0.0 || scene.Renderer->GetSize()[0] <= 0, name, ": marks where there is ink");
  messages->Expect(check, name, words);
  if (words.empty())
  {
    for (vtkIdType i = 0; i < marks->GetNumberOfTuples(); ++i)
    {
      const double* mark = marks->GetTuple(i);
      if (!check(mark[0] >= 0.0 && mark[1] >= 0.0 && mark[1] <= 1.0 && mark[2] >= 0.0 &&
              std::isfinite(mark[0]) && std::isfinite(mark[2]),
            name, ": marks in range, found T ", mark[0], ", opacity ", mark[1], ", diameter ", mark[2]))
      {
        break;
      }
    }
  }
  scene.Mapper->SetPositionPrecision(vtkInkStippleMapper::QUANTIZED);
  const double ink = image.Ink();
  const double packed = InkTestImage(scene.Window).Ink();
  check(std::abs(packed - ink) <= 0.01 * ink + 0.5, name, ": the same ink of quantized places, ", ink,
    ", found ", packed);
  return ink;
}

inline void ExpectInk(
  InkTestChecks& check, const std::string& name, vtkPolyData* data, double least, double most,
  const Change& change = [](StippleScene&) {})
{
  const double ink = FindInk(check, name, data, change);
  check(ink >= least && ink <= most, name, ": ink of ", least, " to ", most, ", found ", ink);
}

/// Ink as it was found when the picture was looked at, to a quarter; none is exactly none.
inline void ExpectAbout(
  InkTestChecks& check, const std::string& name, vtkPolyData* data, double ink,
  const Change& change = [](StippleScene&) {})
{
  ExpectInk(check, name, data, 0.8 * ink, 1.25 * ink, change);
}

/// Where a pixel is a part of it, in which window's brightness has 256 steps.
inline void ExpectPale(
  InkTestChecks& check, const std::string& name, vtkPolyData* data, double ink,
  const Change& change = [](StippleScene&) {})
{
  constexpr double step = 1.0 / 255.0;
  ExpectInk(check, name, data, 0.5 * ink - step, 2.0 * ink + step, change);
}

inline void ExpectMessage(
  InkTestChecks& check, const std::string& name, vtkPolyData* data, const std::string& word)
{
  check(FindInk(check, name, data, [](StippleScene&) {}, { word }) == 0.0, name, ": nothing drawn");
}

/// Runs tests one after the other; whatever else has something to say, shaders above all, fails them.
inline int Run(std::initializer_list<void (*)(InkTestChecks&)> tests)
{
  InkTestChecks check;
  vtkNew<vtkStringOutputWindow> output;
  vtkOutputWindow::SetInstance(output);
  for (const auto& test : tests)
  {
    test(check);
  }
  check(output->GetOutput().find("ERROR") == std::string::npos, "no errors, found ", output->GetOutput());
  return check.Result();
}

} // namespace StippleInk

#endif
