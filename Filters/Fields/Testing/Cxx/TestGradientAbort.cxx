// SPDX-License-Identifier: BSD-3-Clause
#include "GradientTestImages.h"
#include "InkTestProgress.h"

#include "vtkInkGradient.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

TEST(GradientAbort, ReportsProgressAndCanBeAborted)
{
  vtkNew<vtkInkGradient> filter;
  filter->SetInputData(
    MakeImage(VTK_FLOAT, { 0, 30, 0, 30, 0, 300 }, [](double x, double y, double z) { return x * y + z; }));
  filter->ComputeLaplacianOn();
  InkTestProgressAndAbort(filter.Get());
}
