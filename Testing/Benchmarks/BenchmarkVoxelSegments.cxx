// SPDX-License-Identifier: BSD-3-Clause
// Frames of segments through edge voxels (Lu et al. 2003, section 5.6, who draw 1,000 to 300,000 of them):
// vtkInkSilhouetteMapper, which tests all edge voxels on the GPU, against vtkInkStrokeMapper with the
// segments that have passed. The voxels fill a ball, with gradients away from its middle, as those of nested
// shells; a tenth of them has a segment. 1024 x 768 pixels, lines of two pixels; the camera moves by a degree
// a frame, and both draw the same frames in turn.
//
//   BenchmarkVoxelSegments [--frames N] [NUMBER OF SEGMENTS ...]

#include "DrawingBenchmark.h"

#include "vtkInkSilhouetteMapper.h"

#include "Core/Hash.h"

#include "vtkFloatArray.h"
#include "vtkPoints.h"
#include "vtkVersion.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numbers>

namespace
{

constexpr double Width = 2.0; // pixels
constexpr double LargestCosine = 0.1;

struct EdgeVoxels
{
  std::vector<glm::dvec3> Positions; ///< their gradients, too
  double Edge;                       ///< of a voxel

  explicit EdgeVoxels(int count)
    : Edge(std::cbrt(4.0 / 3.0 * std::numbers::pi / count))
  {
    for (std::uint64_t voxel = 0; voxel < static_cast<std::uint64_t>(count); ++voxel)
    {
      const auto random = [&](std::uint64_t number) { return ink::unitDouble(ink::hash(voxel, number)); };
      const double z = 2.0 * random(0) - 1.0;
      const double around = 2.0 * std::numbers::pi * random(1);
      const double across = std::sqrt(1.0 - z * z);
      this->Positions.push_back(
        std::cbrt(random(2)) * glm::dvec3(across * std::cos(around), across * std::sin(around), z));
    }
  }

  /// As of vtkInkEdgeVoxels.
  vtkSmartPointer<vtkPolyData> Make() const
  {
    vtkNew<vtkPoints> points;
    const auto make = [](const char* name, int components)
    {
      auto array = vtkSmartPointer<vtkFloatArray>::New();
      array->SetName(name);
      array->SetNumberOfComponents(components);
      return array;
    };
    const auto gradients = make("Gradient", 3);
    const auto values = make("Value", 1);
    const auto radii = make("Radius", 1);
    for (const glm::dvec3& p : this->Positions)
    {
      points->InsertNextPoint(&p.x);
      gradients->InsertNextTuple(&p.x);
      values->InsertNextValue(1.0f);
      radii->InsertNextValue(static_cast<float>(0.5 * std::numbers::sqrt3 * this->Edge));
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    for (const auto& array : { gradients, values, radii })
    {
      data->GetPointData()->AddArray(array);
    }
    return data;
  }

  /// Those of an eye, as lines.
  vtkSmartPointer<vtkPolyData> FindSegments(const glm::dvec3& eye) const
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    for (const glm::dvec3& p : this->Positions)
    {
      const glm::dvec3 toEye = eye - p;
      const double largest = LargestCosine * glm::length(p) * glm::length(toEye);
      if (std::abs(glm::dot(p, toEye)) <= largest)
      {
        const glm::dvec3 way = 0.5 * this->Edge * glm::normalize(glm::cross(p, toEye));
        lines->InsertNextCell(2);
        for (const glm::dvec3& end : { p - way, p + way })
        {
          lines->InsertCellPoint(points->InsertNextPoint(&end.x));
        }
      }
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(lines);
    return data;
  }
};

struct Scene : public drawing::Window
{
  vtkNew<vtkActor> Actor;

  explicit Scene(vtkInkStrokeMapper* mapper)
  {
    mapper->SetSizeUnitToPixels();
    mapper->SetLineWidth(Width);
    this->Actor->SetMapper(mapper);
    this->Renderer->AddActor(this->Actor);
    const double bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
    this->Renderer->ResetCamera(bounds);
    this->Renderer->GetActiveCamera()->Zoom(1.4);
  }
};

void Measure(int segments, int frames)
{
  const EdgeVoxels voxels(static_cast<int>(segments / LargestCosine));
  vtkNew<vtkInkSilhouetteMapper> onGpu;
  onGpu->SetMethodToVoxelSegments();
  onGpu->SetLargestCosine(LargestCosine);
  onGpu->SetInputData(voxels.Make());
  vtkNew<vtkInkStrokeMapper> passed;
  Scene all(onGpu);
  Scene lines(passed);
  drawing::Frames times[3];
  vtkIdType found = 0;
  for (int frame = -1; frame < frames; ++frame)
  {
    all.Turn(1.0);
    lines.Turn(1.0);
    drawing::Frames warmUp;
    const auto timesOf = [&](int i) -> drawing::Frames& { return frame < 0 ? warmUp : times[i]; };
    timesOf(0).Measure([&] { all.Draw(); });
    glm::dvec3 eye;
    lines.Renderer->GetActiveCamera()->GetPosition(&eye.x);
    vtkSmartPointer<vtkPolyData> data;
    timesOf(1).Measure([&] { data = voxels.FindSegments(eye); });
    passed->SetInputData(data);
    found = data->GetNumberOfLines();
    timesOf(2).Measure([&] { lines.Draw(); });
  }
  const auto processor = [&](int i) { return 1e3 * drawing::Median(times[i].Processor); };
  std::printf("| %zu | %lld | %.0f | %.1f | %.0f |\n", voxels.Positions.size(), static_cast<long long>(found),
    processor(0), processor(1), processor(2));
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[])
{
  const auto [frames, counts] = drawing::ReadArguments(argc, argv, 9, { 1000, 10000, 100000, 300000 });
  std::printf(
    "VTK %s; frame times by the median of %d, ms of processor time\n"
    "| edge voxels | segments | tested and drawn on the GPU | tested by the CPU | then sent and drawn |\n"
    "|---|---|---|---|---|\n",
    vtkVersion::GetVTKVersion(), frames);
  for (const int count : counts)
  {
    Measure(count, frames);
  }
  return EXIT_SUCCESS;
}
