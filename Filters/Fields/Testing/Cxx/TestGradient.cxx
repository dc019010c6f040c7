// SPDX-License-Identifier: BSD-3-Clause
// Gradients, magnitudes, smoothed values and Laplacians against analytic fields, for every method.

#include "GradientTestImages.h"

#include "vtkInkGradient.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace
{

const std::array<int, 6> Extent = { -6, 6, -7, 7, 2, 12 };

double Quadratic(double x, double y, double z)
{
  return 1.0 + 2.0 * x - y + x * x - 0.5 * y * y + 0.25 * z * z + 0.75 * x * y - 0.5 * y * z;
}

/// Whether a point lies at least `margin` points away from the border.
bool IsInside(vtkImageData* image, vtkIdType n, int margin)
{
  const int* size = image->GetDimensions();
  const int ijk[3] = { static_cast<int>(n % size[0]), static_cast<int>(n / size[0] % size[1]),
    static_cast<int>(n / size[0] / size[1]) };
  for (int axis = 0; axis < 3; ++axis)
  {
    if (ijk[axis] < margin || ijk[axis] >= size[axis] - margin)
    {
      return false;
    }
  }
  return true;
}

} // namespace

TEST(Gradient, MethodsAreExactForAQuadratic)
{
  const auto image = MakeImage(VTK_DOUBLE, Extent, Quadratic);
  for (int method = vtkInkGradient::CENTRAL_DIFFERENCE; method <= vtkInkGradient::REGRESSION; ++method)
  {
    for (int neighborhood = vtkInkGradient::NEIGHBORHOOD_3; neighborhood <= vtkInkGradient::NEIGHBORHOOD_5;
         ++neighborhood)
    {
      for (int weighting = vtkInkGradient::UNIFORM; weighting <= vtkInkGradient::INVERSE_DISTANCE;
           ++weighting)
      {
        vtkNew<vtkInkGradient> filter;
        filter->SetInputData(image);
        filter->SetMethod(method);
        filter->SetNeighborhood(neighborhood);
        filter->SetWeighting(weighting);
        filter->SetOutputArraysPrecision(vtkAlgorithm::DOUBLE_PRECISION);
        filter->ComputeLaplacianOn();
        filter->ComputeValueOn();
        filter->Update();
        std::ostringstream name;
        filter->Print(name);
        vtkPointData* data = filter->GetOutput()->GetPointData();
        double gradientError = 0.0;
        double laplacianError = 0.0;
        double magnitudeError = 0.0;
        for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
        {
          double p[3];
          image->GetPoint(n, p);
          const double expected[3] = { 2.0 + 2.0 * p[0] + 0.75 * p[1], -1.0 - p[1] + 0.75 * p[0] - 0.5 * p[2],
            0.5 * p[2] - 0.5 * p[1] };
          double g[3];
          data->GetArray("Gradient")->GetTuple(n, g);
          if (IsInside(image, n, 2))
          {
            for (int axis = 0; axis < 3; ++axis)
            {
              gradientError = std::max(gradientError, std::abs(g[axis] - expected[axis]));
            }
          }
          laplacianError =
            std::max(laplacianError, std::abs(data->GetArray("Laplacian")->GetComponent(n, 0) - 1.5));
          magnitudeError = std::max(magnitudeError,
            std::abs(data->GetArray("GradientMagnitude")->GetComponent(n, 0) - std::hypot(g[0], g[1], g[2])));
        }
        EXPECT_LT(gradientError, 1e-10) << "a quadratic's gradient with " << name.str();
        EXPECT_LT(magnitudeError, 1e-12) << "the gradient's length with " << name.str();
        EXPECT_LT(laplacianError, 1e-7) << "a quadratic's Laplacian with " << name.str();
        if (method == vtkInkGradient::CENTRAL_DIFFERENCE)
        {
          EXPECT_EQ(LargestDifference(data->GetArray("Value"), data->GetArray("Density")), 0.0)
            << "with central differences the value is the input's";
        }
      }
    }
  }
}

TEST(Gradient, LaplacianOfASmoothedWave)
{
  // The Laplacian of sin(k x) smoothed by a Gaussian of deviation s: -k^2 exp(-k^2 s^2 / 2) sin(k x).
  const double k = 0.5;
  const auto wave = [k](double, double, double z) { return std::sin(k * z); };
  const auto image = MakeImage(VTK_FLOAT, { 0, 10, 0, 10, 0, 60 }, wave, { 1.0, 1.0, 0.5 });
  for (const int unit : { vtkInkGradient::SAMPLES, vtkInkGradient::WORLD_UNITS })
  {
    vtkNew<vtkInkGradient> filter;
    filter->SetInputData(image);
    filter->ComputeGradientOff();
    filter->ComputeGradientMagnitudeOff();
    filter->ComputeLaplacianOn();
    filter->SetLaplacianScale(2.0);
    filter->SetLaplacianScaleUnit(unit);
    filter->Update();
    const double scale = unit == vtkInkGradient::SAMPLES ? 1.0 : 2.0;
    const double factor = -k * k * std::exp(-0.5 * k * k * scale * scale);
    double error = 0.0;
    for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
    {
      const vtkIdType slice = n / 121;
      if (slice >= 16 && slice < 45)
      {
        double p[3];
        image->GetPoint(n, p);
        error = std::max(error,
          std::abs(filter->GetOutput()->GetPointData()->GetArray("Laplacian")->GetComponent(n, 0) -
            factor * std::sin(k * p[2])));
      }
    }
    EXPECT_LT(error, 0.01 * std::abs(factor))
      << "the Laplacian of a smoothed wave in unit " << unit << ", of " << factor;
    for (const char* name : { "Gradient", "GradientMagnitude", "Value" })
    {
      EXPECT_FALSE(filter->GetOutput()->GetPointData()->HasArray(name)) << name << " was not asked for";
    }
  }
}
