// SPDX-License-Identifier: BSD-3-Clause
// Principal curvatures of meshes: ink::estimateCurvature, by default and as Rössl et al. (2000) estimate it,
// against igl::principal_curvature with its radius of 5 and vtkCurvatures, which has no directions.
//
//   BenchmarkCurvature [--wall] [--repetitions N] [--convergence]
//
// For each mesh and estimator: the root mean square error of k1 and k2 in 1 / world unit, that of direction 1
// in degrees where k1 and k2 differ, and the least time of N runs in milliseconds: the process's CPU time on
// one thread, or with --wall wall-clock time on as many threads as VTK_SMP_MAX_THREADS says. Meshes have
// sizes about 1; noise moves points along normals. With --convergence errors on finer and finer tori are
// printed instead. libigl takes part where CMake finds its headers
// (-DIGL_INCLUDE_DIR=...), vtkCurvatures where VTK has its module.

#include "Curvature/MeshCurvature.h"
#include "MeshesWithCurvature.h"

#ifdef INK_HAS_IGL
#  include <igl/principal_curvature.h>
#endif
#ifdef INK_HAS_CURVATURES
#  include "vtkCellArray.h"
#  include "vtkCurvatures.h"
#  include "vtkDataArray.h"
#  include "vtkNew.h"
#  include "vtkObject.h"
#  include "vtkPointData.h"
#  include "vtkPoints.h"
#  include "vtkPolyData.h"
#endif

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace
{

using Curvatures = std::vector<ink::PrincipalCurvature>;

struct Options
{
  bool Wall = false;
  int Repetitions = 3;
  bool Convergence = false;
};

struct Scene
{
  const char* Name;
  ink::test::MeshWithCurvature Mesh;
  bool HasDirections;
};

double Now(bool wall)
{
  if (wall)
  {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
  }
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// @param estimate sets its argument; only this is timed
void Measure(const Scene& scene, const char* name, const Options& options, bool hasDirections,
  const std::function<void(Curvatures&)>& estimate)
{
  double least = std::numeric_limits<double>::infinity();
  Curvatures found;
  for (int run = 0; run < options.Repetitions; ++run)
  {
    const double before = Now(options.Wall);
    estimate(found);
    least = std::min(least, Now(options.Wall) - before);
  }
  const ink::test::CurvatureErrors errors = ink::test::curvatureErrors(scene.Mesh.exact, found);
  const std::string angle =
    hasDirections && scene.HasDirections ? std::to_string(errors.angle).substr(0, 6) : std::string("-");
  std::printf("%-28s %-26s %10.5f %8s %9.1f\n", scene.Name, name, errors.curvature, angle.c_str(), least);
}

#ifdef INK_HAS_IGL
void MeasureIgl(const Scene& scene, const Options& options)
{
  const ink::test::Mesh& mesh = scene.Mesh.mesh;
  Eigen::MatrixXd points(mesh.points.size(), 3);
  Eigen::MatrixXi faces(mesh.triangles.size(), 3);
  for (int i = 0; i < points.rows(); ++i)
  {
    const glm::dvec3& p = mesh.points[static_cast<std::size_t>(i)];
    points.row(i) << p.x, p.y, p.z;
  }
  for (int i = 0; i < faces.rows(); ++i)
  {
    const ink::Triangle& t = mesh.triangles[static_cast<std::size_t>(i)];
    faces.row(i) << static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2]);
  }
  Measure(scene, "libigl, radius 5", options, true,
    [&](Curvatures& found)
    {
      Eigen::MatrixXd directions1;
      Eigen::MatrixXd directions2;
      Eigen::VectorXd k1;
      Eigen::VectorXd k2;
      igl::principal_curvature(points, faces, directions1, directions2, k1, k2);
      found.resize(mesh.points.size());
      for (int i = 0; i < points.rows(); ++i)
      {
        const auto direction = [i](const Eigen::MatrixXd& d)
        { return glm::dvec3(d(i, 0), d(i, 1), d(i, 2)); };
        ink::PrincipalCurvature& c = found[static_cast<std::size_t>(i)];
        c = { k1[i], k2[i], direction(directions1), direction(directions2) };
        if (c.k1 < c.k2)
        {
          c = { c.k2, c.k1, c.direction2, c.direction1 };
        }
      }
    });
}
#endif

#ifdef INK_HAS_CURVATURES
void MeasureVtk(const Scene& scene, const Options& options)
{
  vtkObject::GlobalWarningDisplayOff(); // one for each point that it finds doubtful
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const glm::dvec3& p : scene.Mesh.mesh.points)
  {
    points->InsertNextPoint(&p.x);
  }
  vtkNew<vtkCellArray> faces;
  for (const ink::Triangle& t : scene.Mesh.mesh.triangles)
  {
    faces->InsertNextCell({ t[0], t[1], t[2] });
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(faces);
  Measure(scene, "vtkCurvatures", options, false,
    [&](Curvatures& found)
    {
      vtkNew<vtkCurvatures> filter;
      filter->SetInputData(mesh);
      filter->SetCurvatureTypeToMaximum();
      filter->Update();
      vtkDataArray* largest = filter->GetOutput()->GetPointData()->GetArray("Maximum_Curvature");
      vtkDataArray* mean = filter->GetOutput()->GetPointData()->GetArray("Mean_Curvature");
      found.resize(scene.Mesh.exact.size());
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        found[i].k1 = largest->GetTuple1(static_cast<vtkIdType>(i));
        found[i].k2 = 2.0 * mean->GetTuple1(static_cast<vtkIdType>(i)) - found[i].k1;
      }
    });
}
#endif

ink::CurvatureOptions OfThePaper()
{
  ink::CurvatureOptions options;
  options.estimator = ink::CurvatureEstimator::ExponentialMap;
  return options;
}

/// Errors on tori whose edges are half as long from row to row.
void PrintConvergence()
{
  std::printf(
    "%-22s %14s %10s %14s %10s\n", "torus, points around", "vtkInk, k", "angle", "paper, k", "angle");
  for (const double jitter : { 0.0, 0.45 })
  {
    for (const std::uint32_t columns : { 45u, 90u, 180u, 360u, 720u })
    {
      const ink::test::MeshWithCurvature torus =
        ink::test::closedTorus(1.0, 0.4, columns, columns / 2, jitter);
      const auto errors = [&torus](const ink::CurvatureOptions& own)
      {
        return ink::test::curvatureErrors(
          torus.exact, ink::estimateCurvature(torus.mesh.view(), {}, own).points);
      };
      const ink::test::CurvatureErrors jet = errors({});
      const ink::test::CurvatureErrors paper = errors(OfThePaper());
      std::printf("%-10s %11u %14.2e %10.2e %14.2e %10.2e\n", jitter > 0.0 ? "irregular" : "regular", columns,
        jet.curvature, jet.angle, paper.curvature, paper.angle);
    }
  }
}

} // namespace

int main(int argc, char* argv[])
{
  Options options;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word == "--wall")
    {
      options.Wall = true;
    }
    else if (word == "--convergence")
    {
      options.Convergence = true;
    }
    else if (word == "--repetitions" && i + 1 < argc)
    {
      options.Repetitions = std::max(std::atoi(argv[++i]), 1);
    }
    else
    {
      std::fprintf(stderr, "usage: BenchmarkCurvature [--wall] [--repetitions N] [--convergence]\n");
      return 2;
    }
  }
  if (!options.Wall)
  {
    setenv("VTK_SMP_MAX_THREADS", "1", 1);
  }
  if (options.Convergence)
  {
    PrintConvergence();
    return 0;
  }
  const Scene scenes[] = {
    { "torus, 131k points", ink::test::closedTorus(1.0, 0.4, 512, 256), true },
    { "ellipsoid, 41k", ink::test::ellipsoid({ 1.0, 0.7, 0.5 }, 6), true },
    { "ellipsoid, 2.6k", ink::test::ellipsoid({ 1.0, 0.7, 0.5 }, 4), true },
    { "sphere, 1 % noise, 10k", ink::test::ellipsoid(glm::dvec3(1.0), 5, 0.01), false },
    { "sphere, 1 % noise, 2.6k", ink::test::ellipsoid(glm::dvec3(1.0), 4, 0.01), false },
    { "ellipsoid, 0.2 % noise, 2.6k", ink::test::ellipsoid({ 1.0, 0.7, 0.5 }, 4, 0.002), true },
    { "irregular torus, 16k", ink::test::closedTorus(1.0, 0.4, 180, 90, 0.45), true },
    { "irregular, 0.2 % noise, 16k", ink::test::closedTorus(1.0, 0.4, 180, 90, 0.45, 0.002), true },
    { "irregular torus, 1k", ink::test::closedTorus(1.0, 0.4, 45, 22, 0.45), true },
  };
  std::printf("%-28s %-26s %10s %8s %9s\n", "mesh", "estimator", "RMS of k", "angle", "ms");
  for (const Scene& scene : scenes)
  {
    const auto measureOwn = [&](const char* name, const ink::CurvatureOptions& own)
    {
      Measure(scene, name, options, true,
        [&](Curvatures& found) { found = ink::estimateCurvature(scene.Mesh.mesh.view(), {}, own).points; });
    };
    measureOwn("vtkInk", {});
    measureOwn("Rössl et al. 2000", OfThePaper());
#ifdef INK_HAS_IGL
    MeasureIgl(scene, options);
#endif
#ifdef INK_HAS_CURVATURES
    MeasureVtk(scene, options);
#endif
  }
  return 0;
}
