// SPDX-License-Identifier: BSD-3-Clause
// vtkInkLinesOfCurvature and vtkInkHatching on many small broken meshes: all values finite, lines on points
// that there are, in order, whatever the mesh.
//
//   INK_RANDOM_MESHES=10000 StabilityTests --gtest_filter='StrokesRandom.*'

#include "InkTestMessages.h"
#include "InkTestRandom.h"
#include "RandomMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkInkHatching.h"
#include "vtkInkLinesOfCurvature.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace
{

/// In the usual tests, and as many as one likes.
unsigned NumberOfMeshes()
{
  const char* wanted = std::getenv("INK_RANDOM_MESHES");
  return wanted ? static_cast<unsigned>(std::strtoul(wanted, nullptr, 10)) : 60u;
}

std::string ProblemOf(vtkDataSetAttributes* arrays, vtkIdType count)
{
  for (int n = 0; n < arrays->GetNumberOfArrays(); ++n)
  {
    vtkDataArray* array = arrays->GetArray(n);
    const std::string name = array->GetName();
    if (array->GetNumberOfTuples() != count)
    {
      return name + " has " + std::to_string(array->GetNumberOfTuples()) + " values for " +
        std::to_string(count);
    }
    for (vtkIdType i = 0; i < count * array->GetNumberOfComponents(); ++i)
    {
      const int components = array->GetNumberOfComponents();
      if (!std::isfinite(array->GetComponent(i / components, static_cast<int>(i % components))))
      {
        return name + " is not finite at " + std::to_string(i / components);
      }
    }
  }
  return "";
}

/// What is wrong with lines, or nothing.
std::string ProblemOf(vtkPolyData* lines)
{
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    double p[3];
    lines->GetPoint(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      return "a point that is not finite: " + std::to_string(i);
    }
  }
  vtkDataArray* arc = lines->GetPointData()->GetArray("ArcLength");
  for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    lines->GetLines()->GetCellAtId(line, count, ids);
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (ids[i] < 0 || ids[i] >= lines->GetNumberOfPoints())
      {
        return "a line with the point " + std::to_string(ids[i]);
      }
      const bool closes = i + 1 == count && ids[i] == ids[0];
      if (arc && i > 0 && !closes && arc->GetTuple1(ids[i]) < arc->GetTuple1(ids[i - 1]))
      {
        return "an arc length that falls, in line " + std::to_string(line);
      }
    }
  }
  const std::string points = ProblemOf(lines->GetPointData(), lines->GetNumberOfPoints());
  return points.empty() ? ProblemOf(lines->GetCellData(), lines->GetNumberOfCells()) : points;
}

} // namespace

TEST(StrokesRandom, LinesAndStrokesOfBrokenMeshesAreFinite)
{
  const unsigned meshes = NumberOfMeshes();
  unsigned withLines = 0;
  unsigned withStrokes = 0;
  for (unsigned seed = 0; seed < meshes; ++seed)
  {
    InkTestRandom random(seed);
    const RandomMesh mesh(random);
    const vtkSmartPointer<vtkPolyData> surface = mesh.Make(random);
    vtkNew<vtkInkLinesOfCurvature> lines;
    vtkNew<InkTestMessages> messages;
    messages->Observe(lines);
    lines->SetInputData(surface);
    lines->SetFamilies(random.UpTo(3));
    lines->SetSeeding(random.UpTo(2));
    lines->SetNumberOfSeeds(100);
    lines->SetIntegrator(random.UpTo(2));
    lines->SetSmoothDirections(random.Once(2));
    lines->SetFeatureAngle(180.0 * random.Share());
    lines->SetUmbilicLimit(random.Once(2) ? 1.0 : random.Share());
    lines->SetComputeCurvatures(random.Once(2));
    // Not less than takes a moment.
    const double spacing = random.Magnitude(-2.0, 0.5);
    const double size = surface->GetLength();
    if (random.Once(3) && std::isfinite(size * spacing))
    {
      lines->SetSpacing(size * spacing);
    }
    lines->Update();
    ASSERT_LE(messages->Messages.size(), 1u) << "seed " << seed << ": " << messages->Messages.back();
    const std::string problem = ProblemOf(lines->GetOutput());
    ASSERT_TRUE(problem.empty()) << "seed " << seed << ": " << problem;
    if (lines->GetOutput()->GetNumberOfLines() == 0)
    {
      ASSERT_EQ(messages->Messages.size(), 1u) << "seed " << seed << ": no lines without a message";
    }
    withLines += lines->GetOutput()->GetNumberOfLines() > 0 ? 1 : 0;
    vtkNew<vtkInkHatching> hatching;
    messages->Messages.clear();
    messages->Observe(hatching);
    hatching->SetInputData(lines->GetOutput());
    if (random.Once(2))
    {
      hatching->SetSurfaceData(surface);
    }
    hatching->SetStrokeLength(random.Once(2) ? 0.0 : random.Magnitude(-3.0, 1.0));
    hatching->SetSpacing(random.Once(2) ? 0.0 : random.Magnitude(-3.0, 1.0));
    hatching->Update();
    ASSERT_LE(messages->Messages.size(), 1u) << "seed " << seed << ": " << messages->Messages.back();
    const std::string strokes = ProblemOf(hatching->GetOutput());
    ASSERT_TRUE(strokes.empty()) << "seed " << seed << ", strokes: " << strokes;
    withStrokes += hatching->GetOutput()->GetNumberOfLines() > 0 ? 1 : 0;
  }
  EXPECT_GT(withLines, meshes / 3);
  EXPECT_GT(withStrokes, meshes / 3);
}
