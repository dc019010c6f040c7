// SPDX-License-Identifier: BSD-3-Clause
// Evenly spaced lines of curvature of a torus: what they are made of, and the whole filter.
//
//   BenchmarkStreamlines [--triangles N] [--spacing S] [--wall]
//
// By default half a million triangles and a spacing that makes about 10,000 lines. Times are the least of
// three runs: the process's CPU time on one thread, or with --wall the wall-clock time on as many threads as
// VTK_SMP_MAX_THREADS says.

#include "StreamlineShapes.h"

#include "Curves/Streamlines/EvenStreamlines.h"
#include "Curves/Streamlines/ScatteredStreamlines.h"
#include "Curves/Streamlines/SmoothCrossField.h"
#include "vtkInkLinesOfCurvature.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace
{

double Now(bool wall)
{
  if (wall)
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double LeastTime(bool wall, const std::function<void()>& run)
{
  double least = 1e300;
  for (int turn = 0; turn < 3; ++turn)
  {
    const double begin = Now(wall);
    run();
    least = std::min(least, Now(wall) - begin);
  }
  return least;
}

vtkSmartPointer<vtkPolyData> MakePolyData(const ink::test::Shape& shape)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < shape.mesh.points.size(); ++i)
  {
    points->InsertNextPoint(&shape.mesh.points[i].x);
    normals->InsertNextTuple(&shape.normals[i].x);
  }
  vtkNew<vtkCellArray> triangles;
  for (const auto& [a, b, c] : shape.mesh.triangles)
  {
    triangles->InsertNextCell({ a, b, c });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  data->GetPointData()->SetNormals(normals);
  return data;
}

} // namespace

int main(int argc, char* argv[])
{
  double triangles = 500'000.0;
  double spacing = 0.0125;
  bool wall = false;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    const double number = i + 1 < argc ? std::atof(argv[i + 1]) : 0.0;
    if (word == "--wall")
    {
      wall = true;
    }
    else if (word == "--triangles" && number > 0.0)
    {
      triangles = number;
      ++i;
    }
    else if (word == "--spacing" && number > 0.0)
    {
      spacing = number;
      ++i;
    }
    else
    {
      std::fprintf(stderr, "%s: expected --triangles N, --spacing S or --wall\n", word.c_str());
      return EXIT_FAILURE;
    }
  }
  if (!wall)
  {
    setenv("VTK_SMP_MAX_THREADS", "1", 1);
  }
  const int rows = static_cast<int>(std::sqrt(triangles / 6.0));
  const ink::test::Shape shape = ink::test::TorusShape().sample(3 * rows, rows);
  const ink::TriangleMesh mesh = shape.mesh.view();
  std::printf("torus of %zu triangles, %s\n", mesh.triangles.size(), wall ? "wall-clock time" : "one thread");

  std::unique_ptr<ink::MeshNavigation> navigation;
  std::printf("  navigation: %.3f s\n",
    LeastTime(wall, [&] { navigation = std::make_unique<ink::MeshNavigation>(mesh, 180.0); }));

  const std::vector<float> umbilics(mesh.points.size(), 0.9f);
  std::printf("  smoothing, 30 iterations on all points: %.3f s\n",
    LeastTime(wall, [&] { ink::smoothCrossField(mesh, shape.normals, shape.maximum, umbilics, 30); }));

  for (const bool maximum : { true, false })
  {
    ink::EvenStreamlineOptions options;
    options.spacing = spacing;
    options.trace.maximumLength = 40.0 * spacing;
    ink::Streamlines lines;
    const double time = LeastTime(wall,
      [&] { lines = ink::evenStreamlines(*navigation, shape.normals, fieldOf(shape, maximum), options); });
    std::printf("  evenly spaced, %s curvature: %.3f s, %zu lines of %zu points\n",
      maximum ? "maximum" : "minimum", time, lines.lines.size(), lines.points.size());
  }
  ink::Streamlines lines;
  const double time = LeastTime(wall,
    [&]
    {
      ink::TraceOptions options;
      options.maximumLength = 40.0 * spacing;
      ink::AreaSeedOptions seeds;
      seeds.count = 10000.0;
      lines = ink::scatteredStreamlines(
        *navigation, fieldOf(shape), ink::areaSeeds(*navigation, seeds), options, 0);
    });
  std::printf(
    "  area scatter: %.3f s, %zu lines of %zu points\n", time, lines.lines.size(), lines.points.size());

  const vtkSmartPointer<vtkPolyData> data = MakePolyData(shape);
  vtkNew<vtkInkLinesOfCurvature> filter;
  filter->SetInputData(data);
  filter->SetSpacing(spacing);
  filter->SetMaximumLength(40.0 * spacing);
  const double whole = LeastTime(wall,
    [&]
    {
      filter->Modified();
      filter->Update();
    });
  std::printf("  vtkInkLinesOfCurvature, curvature and smoothing among it: %.3f s, %lld lines\n", whole,
    static_cast<long long>(filter->GetOutput()->GetNumberOfLines()));
  return EXIT_SUCCESS;
}
