// SPDX-License-Identifier: BSD-3-Clause
#include "InkTestProgress.h"
#include "SamplerTestImages.h"

#include "vtkInkIsoSurfaceSampler.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

TEST(IsoSurfaceSamplerAbort, ReportsProgressAndCanBeAborted)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(MakeImage(VTK_FLOAT, { -40, 40, -40, 40, -100, 100 },
    [](double x, double y, double z) { return BallDensity(x, y, z, 35.0); }));
  sampler->SetValue(0, 100.0);
  sampler->SetValue(1, 200.0);
  InkTestProgressAndAbort(sampler.Get());
}
