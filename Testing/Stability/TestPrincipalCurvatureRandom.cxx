// SPDX-License-Identifier: BSD-3-Clause
// vtkInkPrincipalCurvature on many small broken meshes: every value finite, every direction a unit vector,
// whatever the mesh.

#include "InkTestMessages.h"
#include "InkTestRandom.h"
#include "RandomMeshes.h"

#include "vtkDataArray.h"
#include "vtkInkPrincipalCurvature.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{

/// What is wrong with the output, or nothing.
std::string ProblemOf(vtkPolyData* output)
{
  vtkPointData* arrays = output->GetPointData();
  for (const char* name : { "k1", "k2", "PrincipalDirection1", "PrincipalDirection2", "MeanCurvature",
         "GaussCurvature", "UmbilicMeasure", "CurvatureSource" })
  {
    vtkDataArray* array = arrays->GetArray(name);
    if (!array || array->GetNumberOfTuples() != output->GetNumberOfPoints())
    {
      return std::string("no value per point in ") + name;
    }
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        if (!std::isfinite(array->GetComponent(i, c)))
        {
          return std::string(name) + " is not finite at " + std::to_string(i);
        }
      }
    }
  }
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double a[3];
    double b[3];
    arrays->GetArray("PrincipalDirection1")->GetTuple(i, a);
    arrays->GetArray("PrincipalDirection2")->GetTuple(i, b);
    const double scalar = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    if (std::abs(std::hypot(a[0], a[1], a[2]) - 1.0) > 1e-5 ||
      std::abs(std::hypot(b[0], b[1], b[2]) - 1.0) > 1e-5 || std::abs(scalar) > 1e-5)
    {
      return "directions that are not orthonormal at " + std::to_string(i);
    }
    const double measure = arrays->GetArray("UmbilicMeasure")->GetTuple1(i);
    if (arrays->GetArray("k1")->GetTuple1(i) < arrays->GetArray("k2")->GetTuple1(i) || measure < 0.0 ||
      measure > 1.0)
    {
      return "k1 below k2, or an umbilic measure of " + std::to_string(measure) + ", at " + std::to_string(i);
    }
  }
  return "";
}

} // namespace

TEST(PrincipalCurvatureRandom, BrokenMeshesHaveFiniteValues)
{
  int withCurvature = 0;
  for (unsigned seed = 0; seed < 10000; ++seed)
  {
    InkTestRandom random(seed);
    const RandomMesh mesh(random);
    vtkNew<vtkInkPrincipalCurvature> filter;
    vtkNew<InkTestMessages> messages;
    messages->Observe(filter);
    filter->SetInputData(mesh.Make(random));
    filter->SetEstimator(
      random.Once(4) ? vtkInkPrincipalCurvature::EXPONENTIAL_MAP : vtkInkPrincipalCurvature::JET);
    filter->SetNumberOfRings(1 + random.UpTo(6));
    filter->SetAdaptive(random.Once(2));
    filter->SetDegree(2 + random.UpTo(2));
    filter->SetOutputArraysPrecision(random.UpTo(2));
    filter->ComputeMeanCurvatureOn();
    filter->ComputeGaussCurvatureOn();
    filter->ComputeUmbilicMeasureOn();
    filter->ComputeSourceOn();
    filter->Update();
    vtkPolyData* output = filter->GetOutput();
    if (output->GetNumberOfPoints() == 0)
    {
      ASSERT_EQ(messages->Messages.size(), 1u) << "seed " << seed << ": an empty output without a message";
      continue;
    }
    const std::string problem = ProblemOf(output);
    ASSERT_TRUE(problem.empty()) << "seed " << seed << ": " << problem;
    ++withCurvature;
  }
  EXPECT_GT(withCurvature, 9000);
}
