// SPDX-License-Identifier: BSD-3-Clause
// A hundredth of a parameter's range is a small step of ink, at its ends above all.
#include "InkTestImage.h"
#include "InkTestPoints.h"
#include "SplattingLinesScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

TEST(SplattingLinesSliders, AreContinuousAtTheirEnds)
{
  const auto torus = InkTestPoints::Torus(1.0, 0.4, 0.03);
  using Mapper = vtkInkSplattingLinesMapper;
  const struct
  {
    const char* Name;
    double Least;
    double Most;
    void (*Set)(Mapper*, double);
    double LargestStep; ///< of the most ink along the way
  } sliders[] = {
    { "Tau", 0.8, 1.2, [](Mapper* m, double value) { m->SetTau(value); }, 0.001 },
    { "Phi", 0.0, 500.0, [](Mapper* m, double value) { m->SetPhi(value); }, 0.6 },
    { "Lambda", 0.1, 20.0, [](Mapper* m, double value) { m->SetLambda(value); }, 0.013 },
    { "Sigma", 0.05, 2.0, [](Mapper* m, double value) { m->SetSigma(value); }, 0.09 },
    { "MinimumRadius", 0.0, 50.0, [](Mapper* m, double value) { m->SetMinimumRadius(value); }, 0.018 },
    { "Hardness", 0.0, 1.0, [](Mapper* m, double value) { m->SetHardness(value); }, 0.001 },
    { "SpeckleLength", 0.0, 1000.0, [](Mapper* m, double value) { m->SetSpeckleLength(value); }, 0.001 },
    { "LayerStrength", 0.0, 1.0, [](Mapper* m, double value) { m->SetLayerStrength(0, value); }, 0.022 },
    { "LineWidth", -20.0, 20.0, [](Mapper* m, double value) { m->SetLineWidth(value); }, 0.024 },
    { "LayerDashLength", 0.0, 100.0, [](Mapper* m, double value) { m->SetLayerDashLength(0, value); }, 0.4 },
    { "PointFraction", 0.01, 1.0, [](Mapper* m, double value) { m->SetPointFraction(value); }, 0.06 },
  };
  for (const auto& slider : sliders)
  {
    SplattingLinesScene scene(torus, 150, 150);
    scene.Renderer->GetActiveCamera()->Elevation(-50.0);
    scene.Renderer->ResetCamera();
    const auto draw = [&](double share)
    {
      slider.Set(scene.Mapper, slider.Least + share * (slider.Most - slider.Least));
      return InkTestImage(scene.Window).Ink();
    };
    const double ends[2][2] = { { draw(0.0), draw(0.01) }, { draw(1.0), draw(0.99) } };
    const double most = std::max({ ends[0][0], ends[0][1], draw(0.5), ends[1][0], ends[1][1] });
    EXPECT_GT(most, 100.0) << slider.Name << ": ink, found " << most;
    for (int end : { 0, 1 })
    {
      const double step = std::abs(ends[end][0] - ends[end][1]) / most;
      EXPECT_LE(step, slider.LargestStep) << slider.Name << ": a small step at " << (end ? "the end" : "0")
                                          << ", found " << step << " of the ink";
      // A step a hundred times smaller is far smaller: none is a jump, however steep the way. Of a hundredth
      // of the points, it is still a hundredth more.
      const double near = draw(end ? 0.9999 : 0.0001);
      const double tiny = std::abs(ends[end][0] - near) / most;
      EXPECT_LE(tiny, 0.012) << slider.Name << ": no jump at " << (end ? "the end" : "0") << ", found "
                             << tiny << " of the ink";
    }
  }
}
