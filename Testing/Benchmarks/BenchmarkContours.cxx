// SPDX-License-Identifier: BSD-3-Clause
// Silhouettes of a mesh while the camera moves: ink::MeshContours, interpolated and faceted, chained, against
// vtkPolyDataSilhouette, which delivers the edges of the latter as a soup; and how the time of a frame grows
// with the number of triangles.
//
//   BenchmarkContours [--triangles N ...] [--frames N] [--wall]
//
// The mesh is a sphere with waves of a few percent, with 10^5, 10^6 and 10^7 triangles by default. Between
// frames the camera turns by a degree; times are medians over frames. They are the process's CPU time on one
// thread, which other programs disturb less than wall-clock time; wall-clock time with --wall, on as many
// threads as VTK_SMP_MAX_THREADS says, otherwise on one. vtkPolyDataSilhouette runs where its VTK module is,
// up to 10^6 triangles; it is single-threaded.

#include "Curves/Contours/MeshContours.h"
#include "ProcessorTime.h"

#ifdef INK_HAS_SILHOUETTE
#  include "vtkCamera.h"
#  include "vtkCellArray.h"
#  include "vtkNew.h"
#  include "vtkPoints.h"
#  include "vtkPolyData.h"
#  include "vtkPolyDataSilhouette.h"
#  include "vtkVersion.h"
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace
{

struct Mesh
{
  std::vector<glm::dvec3> Points;
  std::vector<glm::vec3> Normals;
  std::vector<ink::Triangle> Triangles;
};

/// The surface |x| = 1 + height times the product of three waves, about as many triangles as asked for.
Mesh BumpySphere(std::size_t triangles)
{
  constexpr double waves = 9.0;
  constexpr double height = 0.03;
  const auto rows = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(triangles) / 4.0)));
  const std::uint32_t columns = 2 * rows;
  Mesh mesh;
  for (std::uint32_t row = 0; row <= rows; ++row)
  {
    for (std::uint32_t column = 0; column < columns; ++column)
    {
      const double down = std::numbers::pi * row / rows;
      const double around = 2.0 * std::numbers::pi * column / columns;
      const glm::dvec3 p(
        std::sin(down) * std::cos(around), std::sin(down) * std::sin(around), std::cos(down));
      const glm::dvec3 sines(std::sin(waves * p.x), std::sin(waves * p.y), std::sin(waves * p.z));
      const glm::dvec3 slopes = -height * waves *
        glm::dvec3(std::cos(waves * p.x) * sines.y * sines.z, sines.x * std::cos(waves * p.y) * sines.z,
          sines.x * sines.y * std::cos(waves * p.z));
      const double size = 1.0 + height * sines.x * sines.y * sines.z;
      mesh.Points.push_back(size * p);
      mesh.Normals.emplace_back(glm::normalize(p + (slopes - glm::dot(slopes, p) * p) / size));
    }
  }
  for (std::uint32_t row = 0; row < rows; ++row)
  {
    for (std::uint32_t column = 0; column < columns; ++column)
    {
      const std::uint32_t next = (column + 1) % columns;
      const std::uint32_t upper = row * columns;
      const std::uint32_t lower = upper + columns;
      mesh.Triangles.push_back({ upper + column, lower + column, lower + next });
      mesh.Triangles.push_back({ upper + column, lower + next, upper + next });
    }
  }
  return mesh;
}

struct Options
{
  std::vector<std::size_t> Triangles;
  int Frames = 60;
  bool Wall = false;
};

double Now(bool wall)
{
  if (wall)
  {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
  }
  return ProcessorTime();
}

glm::dvec3 EyeOf(int frame)
{
  const double angle = frame * std::numbers::pi / 180.0;
  return { 5.0 * std::cos(angle), 5.0 * std::sin(angle), 1.5 };
}

/// The median time of a frame, in milliseconds.
double TimeFrames(const Options& options, int frames, const std::function<void(const glm::dvec3&)>& draw)
{
  std::vector<double> times;
  draw(EyeOf(-1));
  for (int frame = 0; frame < frames; ++frame)
  {
    const double before = Now(options.Wall);
    draw(EyeOf(frame));
    times.push_back(Now(options.Wall) - before);
  }
  std::nth_element(times.begin(), times.begin() + frames / 2, times.end());
  return times[static_cast<std::size_t>(frames / 2)];
}

#ifdef INK_HAS_SILHOUETTE
double TimeVtk(const Mesh& mesh, const Options& options)
{
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.Points.size()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), &mesh.Points[i].x);
  }
  vtkNew<vtkCellArray> faces;
  for (const ink::Triangle& triangle : mesh.Triangles)
  {
    faces->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(faces);
  vtkNew<vtkCamera> camera;
  vtkNew<vtkPolyDataSilhouette> silhouette;
  silhouette->SetInputData(data);
  silhouette->SetCamera(camera);
  silhouette->SetDirectionToCameraOrigin();
  silhouette->SetEnableFeatureAngle(0);
  vtkIdType segments = 0;
  const double time = TimeFrames(options, std::min(options.Frames, 15),
    [&](const glm::dvec3& eye)
    {
      camera->SetPosition(eye.x, eye.y, eye.z);
      silhouette->Update();
      segments = silhouette->GetOutput()->GetNumberOfLines();
    });
  std::printf("  vtkPolyDataSilhouette, VTK %s: %9.3f ms a frame, %lld segments\n",
    vtkVersion::GetVTKVersion(), time, static_cast<long long>(segments));
  return time;
}
#endif

/// The time of a frame with interpolated silhouettes.
double Measure(std::size_t triangles, const Options& options)
{
  const Mesh mesh = BumpySphere(triangles);
  std::printf("%zu triangles\n", mesh.Triangles.size());
  double reference = 0.0;
#ifdef INK_HAS_SILHOUETTE
  if (triangles <= 1'000'000)
  {
    reference = TimeVtk(mesh, options);
  }
#endif
  double interpolated = 0.0;
  for (const bool faceted : { false, true })
  {
    ink::MeshContourOptions choice;
    choice.faceted = faceted;
    const double before = Now(options.Wall);
    const ink::MeshContours finder({ mesh.Points, mesh.Triangles, {}, {} }, mesh.Normals, choice);
    const double built = Now(options.Wall) - before;
    ink::Contours contours;
    const auto search = [&](ink::SilhouetteSearch how)
    {
      return TimeFrames(options, how == ink::SilhouetteSearch::Hierarchy ? options.Frames : 5,
        [&](const glm::dvec3& eye) { contours = finder.find(ink::Eye::at(eye), {}, how); });
    };
    const double exhaustive = search(ink::SilhouetteSearch::Exhaustive);
    const double time = search(ink::SilhouetteSearch::Hierarchy);
    interpolated = faceted ? interpolated : time;
    std::printf("  %-12s %9.3f ms a frame, %zu points in %zu chains; exhaustive %.3f ms; index %.0f ms",
      faceted ? "faceted" : "interpolated", time, contours.positions.size(), contours.chains.size(),
      exhaustive, built);
    if (reference > 0.0)
    {
      std::printf("; %.0fx", reference / time);
    }
    std::printf("\n");
  }
  return interpolated;
}

bool Read(int argc, char* argv[], Options& options)
{
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    const bool hasNumber = i + 1 < argc && std::atoll(argv[i + 1]) > 0;
    if (word == "--wall")
    {
      options.Wall = true;
    }
    else if (word == "--frames" && hasNumber)
    {
      options.Frames = std::atoi(argv[++i]);
    }
    else if (word == "--triangles" && hasNumber)
    {
      while (i + 1 < argc && std::atoll(argv[i + 1]) > 0)
      {
        options.Triangles.push_back(static_cast<std::size_t>(std::atoll(argv[++i])));
      }
    }
    else
    {
      std::fprintf(stderr, "%s: expected --triangles N ..., --frames N or --wall\n", word.c_str());
      return false;
    }
  }
  if (options.Triangles.empty())
  {
    options.Triangles = { 100'000, 1'000'000, 10'000'000 };
  }
  return true;
}

} // namespace

int main(int argc, char* argv[])
{
  Options options;
  if (!Read(argc, argv, options))
  {
    return EXIT_FAILURE;
  }
  if (!options.Wall)
  {
    setenv("VTK_SMP_MAX_THREADS", "1", 1);
  }
  std::vector<double> times;
  for (const std::size_t triangles : options.Triangles)
  {
    times.push_back(Measure(triangles, options));
    if (times.size() > 1)
    {
      const double factor =
        static_cast<double>(triangles) / static_cast<double>(options.Triangles[times.size() - 2]);
      std::printf("  grows with the triangles to the power of %.2f\n",
        std::log(times.back() / times[times.size() - 2]) / std::log(factor));
    }
  }
  return EXIT_SUCCESS;
}
