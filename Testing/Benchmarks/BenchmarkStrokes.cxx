// SPDX-License-Identifier: BSD-3-Clause
// Frames of strokes on a sphere, all of which face the eye or its back: vtkInkStrokeMapper with plain
// strokes, with hatching, and with hatching that the sphere hides, against vtkTubeFilter with
// vtkPolyDataMapper (the tubes are made once, before the frames) and plain OpenGL lines, by
// vtkPolyDataMapper, all about two pixels wide. 1024 x 768 pixels; the camera moves by a degree a frame, and
// all draw the same frames in turn.
//
//   BenchmarkStrokes [--frames N] [NUMBER OF STROKES ...]

#include "DrawingBenchmark.h"

#include "vtkInkStrokeMapper.h"

#include "Core/Hash.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTubeFilter.h"
#include "vtkVersion.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace
{

constexpr int PointsOfStroke = 16;
constexpr double Width = 2.0; // pixels

double Random(int stroke, int number)
{
  return ink::unitDouble(ink::hash(static_cast<std::uint64_t>(stroke), static_cast<std::uint64_t>(number)));
}

/// Arcs of great circles of the unit sphere anywhere, in any direction, so long that they cover about as
/// much of it however many there are.
vtkSmartPointer<vtkPolyData> MakeStrokes(int count)
{
  const double length = 15.0 / std::sqrt(count);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> priorities;
  priorities->SetName("Priority");
  vtkNew<vtkFloatArray> spacings;
  spacings->SetName("Spacing");
  vtkNew<vtkCellArray> lines;
  for (int stroke = 0; stroke < count; ++stroke)
  {
    const double z = 2.0 * Random(stroke, 0) - 1.0;
    const double around = 2.0 * M_PI * Random(stroke, 1);
    const double turn = 2.0 * M_PI * Random(stroke, 2);
    const double radius = std::sqrt(1.0 - z * z);
    const glm::dvec3 start(radius * std::cos(around), radius * std::sin(around), z);
    const glm::dvec3 east(-std::sin(around), std::cos(around), 0.0);
    const glm::dvec3 way = std::cos(turn) * east + std::sin(turn) * glm::cross(start, east);
    lines->InsertNextCell(PointsOfStroke);
    for (int i = 0; i < PointsOfStroke; ++i)
    {
      const double angle = length * i / (PointsOfStroke - 1);
      const glm::dvec3 p = std::cos(angle) * start + std::sin(angle) * way;
      normals->InsertNextTuple(&p.x);
      lines->InsertCellPoint(points->InsertNextPoint(&p.x));
    }
    priorities->InsertNextValue(static_cast<float>((stroke + 0.5) / count));
    spacings->InsertNextValue(static_cast<float>(4.0 * M_PI / (length * count)));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  data->GetPointData()->SetNormals(normals);
  data->GetCellData()->AddArray(priorities);
  data->GetCellData()->AddArray(spacings);
  return data;
}

/// A window with one actor, seen from where all have the same picture.
struct Scene : public drawing::Window
{
  vtkNew<vtkActor> Actor;

  explicit Scene(vtkMapper* mapper)
  {
    this->Actor->SetMapper(mapper);
    vtkProperty* property = this->Actor->GetProperty();
    property->SetColor(0.0, 0.0, 0.0);
    property->LightingOff();
    property->SetLineWidth(static_cast<float>(Width));
    this->Renderer->AddActor(this->Actor);
    const double bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
    this->Renderer->ResetCamera(bounds);
    this->Renderer->GetActiveCamera()->Zoom(1.4);
  }
};

void Measure(int count, int frames)
{
  const vtkSmartPointer<vtkPolyData> strokes = MakeStrokes(count);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(200);
  sphere->SetPhiResolution(100);
  vtkNew<vtkInkStrokeMapper> ours[3];
  for (const auto& mapper : ours)
  {
    mapper->SetInputData(strokes);
    mapper->SetSizeUnitToPixels();
    mapper->SetLineWidth(Width);
  }
  ours[1]->HatchingOn();
  ours[2]->HatchingOn();
  ours[2]->SetSurfaceConnection(sphere->GetOutputPort());

  Scene plain(ours[0]);
  Scene hatching(ours[1]);
  Scene hidden(ours[2]);
  vtkNew<vtkPolyDataMapper> lineMapper;
  lineMapper->SetInputData(strokes);
  Scene lines(lineMapper);
  // As wide in the middle of the picture.
  vtkCamera* camera = lines.Renderer->GetActiveCamera();
  const double pixel =
    2.0 * camera->GetDistance() * std::tan(0.5 * camera->GetViewAngle() * M_PI / 180.0) / 768.0;
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(strokes);
  tubes->SetNumberOfSides(6);
  tubes->SetRadius(0.5 * Width * pixel);
  const double start = drawing::ProcessorTime();
  tubes->Update();
  const double making = drawing::ProcessorTime() - start;
  vtkNew<vtkPolyDataMapper> tubeMapper;
  tubeMapper->SetInputData(tubes->GetOutput());
  Scene asTubes(tubeMapper);

  Scene* const scenes[] = { &plain, &hatching, &hidden, &asTubes, &lines };
  drawing::Frames times[std::size(scenes)];
  for (int frame = -1; frame < frames; ++frame)
  {
    for (std::size_t i = 0; i < std::size(scenes); ++i)
    {
      scenes[i]->Turn(1.0);
      const auto draw = [&] { scenes[i]->Draw(); };
      if (frame < 0)
      {
        draw(); // uploads
      }
      else
      {
        times[i].Measure(draw);
      }
    }
  }
  const auto processor = [&](std::size_t i) { return 1e3 * drawing::Median(times[i].Processor); };
  std::printf("| %d | %.0f | %.0f | %.0f | %.0f | %.0f | %.2f | %.2f | %.2f | %.2f | %.2f |\n", count,
    processor(0), processor(1), processor(2), processor(3), processor(4), processor(0) / processor(3),
    processor(0) / processor(4), processor(1) / processor(3), processor(2) / processor(3), making);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char* argv[])
{
  const auto [frames, counts] = drawing::ReadArguments(argc, argv, 15, { 10000, 100000 });
  std::printf(
    "VTK %s; strokes of %d points; frame times by the median of %d, ms of processor time\n"
    "| strokes | plain | hatching | hatching on a surface | tubes | GL lines | plain: of tubes' time | "
    "of lines' | hatching: of tubes' | on a surface: of tubes' | making tubes once, s |\n"
    "|---|---|---|---|---|---|---|---|---|---|---|\n",
    vtkVersion::GetVTKVersion(), PointsOfStroke, frames);
  for (const int count : counts)
  {
    Measure(count, frames);
  }
  return EXIT_SUCCESS;
}
