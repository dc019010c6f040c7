// SPDX-License-Identifier: BSD-3-Clause
#ifndef StippleInk_h
#define StippleInk_h

#include "InkTestImage.h"
#include "InkTestMessages.h"
#include "StippleScene.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStringOutputWindow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
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

/// The ink of the data's picture in a window of 120 x 120 pixels. Positions in either precision give the
/// same.
/// @param words that the one message has to contain; empty: there must be none
inline double FindInk(
  const std::string& name, vtkPolyData* data, const Change& change = [](StippleScene&) {},
  const std::vector<std::string>& words = {})
{
  StippleScene scene(data, 120, 120);
  vtkNew<InkTestMessages> messages;
  messages->Observe(scene.Mapper);
  change(scene);
  const InkTestImage image(scene.Window);
  // Neither again by another picture nor by a question is anything said twice.
  vtkNew<vtkFloatArray> marks;
  const bool found = scene.Mapper->EvaluateMarks(scene.Renderer, scene.Actor, marks);
  EXPECT_TRUE(found || image.Ink() == 0.0 || scene.Renderer->GetSize()[0] <= 0)
    << name << ": marks where there is ink";
  messages->Expect(name, words);
  if (words.empty())
  {
    for (vtkIdType i = 0; i < marks->GetNumberOfTuples(); ++i)
    {
      const double* mark = marks->GetTuple(i);
      const bool valid = mark[0] >= 0.0 && mark[1] >= 0.0 && mark[1] <= 1.0 && mark[2] >= 0.0 &&
        std::isfinite(mark[0]) && std::isfinite(mark[2]);
      EXPECT_TRUE(valid) << name << ": marks in range, found T " << mark[0] << ", opacity " << mark[1]
                         << ", diameter " << mark[2];
      if (!valid)
      {
        break;
      }
    }
  }
  scene.Mapper->SetPositionPrecision(vtkInkStippleMapper::QUANTIZED);
  const double ink = image.Ink();
  const double packed = InkTestImage(scene.Window).Ink();
  EXPECT_LE(std::abs(packed - ink), 0.01 * ink + 0.5)
    << name << ": the same ink of quantized positions, " << ink << ", found " << packed;
  return ink;
}

inline void ExpectInk(
  const std::string& name, vtkPolyData* data, double least, double most,
  const Change& change = [](StippleScene&) {})
{
  const double ink = FindInk(name, data, change);
  EXPECT_TRUE(ink >= least && ink <= most)
    << name << ": ink of " << least << " to " << most << ", found " << ink;
}

/// Ink as it was found when the picture was checked by eye; none is exactly none.
inline void ExpectAbout(
  const std::string& name, vtkPolyData* data, double ink, const Change& change = [](StippleScene&) {})
{
  ExpectInk(name, data, 0.97 * ink, 1.03 * ink, change);
}

/// Where a pixel is a part of it, in which window's brightness has 256 steps.
inline void ExpectPale(
  const std::string& name, vtkPolyData* data, double ink, const Change& change = [](StippleScene&) {})
{
  constexpr double step = 1.0 / 255.0;
  ExpectInk(name, data, 0.5 * ink - step, 2.0 * ink + step, change);
}

inline void ExpectMessage(const std::string& name, vtkPolyData* data, const std::string& word)
{
  EXPECT_EQ(FindInk(name, data, [](StippleScene&) {}, { word }), 0.0) << name << ": nothing drawn";
}

/// Whatever else has something to say, shaders above all, fails a test.
class Test : public testing::Test
{
protected:
  Test() { vtkOutputWindow::SetInstance(this->Output); }
  void TearDown() override
  {
    EXPECT_EQ(this->Output->GetOutput().find("ERROR"), std::string::npos)
      << "no errors, found " << this->Output->GetOutput();
    vtkOutputWindow::SetInstance(nullptr);
  }

private:
  vtkNew<vtkStringOutputWindow> Output;
};

} // namespace StippleInk

#endif
