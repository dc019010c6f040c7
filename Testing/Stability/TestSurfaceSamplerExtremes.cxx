// SPDX-License-Identifier: BSD-3-Clause
// vtkInkSurfaceSampler and vtkInkPointPriority at the ends of what they accept.

#include "InkTestMessages.h"
#include "StabilityChecks.h"

#include "vtkInkPointPriority.h"
#include "vtkInkSurfaceSampler.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace
{

using Position = std::array<double, 3>;

struct Faces
{
  std::vector<Position> Points;
  std::vector<std::vector<vtkIdType>> Polygons;

  vtkSmartPointer<vtkPolyData> Make(int type = VTK_DOUBLE) const
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(type);
    for (const Position& position : this->Points)
    {
      points->InsertNextPoint(position.data());
    }
    vtkNew<vtkCellArray> polys;
    for (const auto& polygon : this->Polygons)
    {
      polys->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
    }
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetPolys(polys);
    return mesh;
  }
};

Faces Square(int cells, double side, Position corner)
{
  Faces faces;
  for (int i = 0; i < (cells + 1) * (cells + 1); ++i)
  {
    faces.Points.push_back({ corner[0] + side * (i % (cells + 1)) / cells,
      corner[1] + side * (i / (cells + 1)) / cells, corner[2] });
  }
  for (vtkIdType i = 0; i < cells * cells; ++i)
  {
    const vtkIdType a = i / cells * (cells + 1) + i % cells;
    faces.Polygons.push_back({ a, a + 1, a + cells + 2 });
    faces.Polygons.push_back({ a, a + cells + 2, a + cells + 1 });
  }
  return faces;
}

/// Samples by both methods; expects a number of valid points, or none with a message.
void Expect(const std::string& name, vtkPolyData* mesh, vtkIdType count, bool message = false)
{
  for (const int method : { vtkInkSurfaceSampler::WHITE_NOISE, vtkInkSurfaceSampler::BLUE_NOISE,
         vtkInkSurfaceSampler::PROGRESSIVE_BLUE_NOISE })
  {
    vtkNew<vtkInkSurfaceSampler> sampler;
    vtkNew<InkTestMessages> messages;
    messages->Observe(sampler);
    sampler->SetInputData(mesh);
    sampler->SetMethod(method);
    sampler->SetNumberOfSamples(count > 0 ? count : 100);
    sampler->KeepFacesOn();
    sampler->Update();
    vtkPolyData* output = sampler->GetOutput();
    EXPECT_EQ(output->GetNumberOfPoints(), count)
      << name << ": " << count << " points, found " << output->GetNumberOfPoints();
    EXPECT_EQ((messages->Messages.size() == 1), message)
      << name << ": messages, found " << messages->Messages.size();
    CheckValidPoints(name, output);
  }
}

} // namespace

/// The unit square at a scale and a position: the same samples, scaled and moved.
TEST(SurfaceSamplerExtremes, Scales)
{
  for (const double scale : { 1e-9, 1.0, 1e9 })
  {
    for (const double origin : { 0.0, 1e7 })
    {
      const std::string name = "scale " + std::to_string(scale) + " at " + std::to_string(origin * scale);
      const auto mesh = Square(8, scale, { origin * scale, -origin * scale, origin * scale }).Make();
      Expect(name, mesh, 500);
      vtkNew<vtkInkSurfaceSampler> sampler;
      sampler->SetInputData(mesh);
      sampler->SetNumberOfSamples(500);
      sampler->Update();
      vtkPolyData* output = sampler->GetOutput();
      const double radius = output->GetPointData()->GetArray("Radius")->GetComponent(0, 0) / scale;
      EXPECT_TRUE(radius > 0.03 && radius < 0.07) << name << ": a radius in proportion, found " << radius;
      double bounds[6];
      output->GetBounds(bounds);
      EXPECT_TRUE((bounds[1] - bounds[0]) / scale > 0.9 && (bounds[3] - bounds[2]) / scale > 0.9)
        << name << ": all of the square";
      double least = 1e30;
      for (vtkIdType i = 0; i < 500; ++i)
      {
        for (vtkIdType j = 0; j < i; ++j)
        {
          double a[3];
          double b[3];
          output->GetPoint(i, a);
          output->GetPoint(j, b);
          least = std::min(least, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) / scale);
        }
      }
      EXPECT_GT(least, 0.03) << name << ": blue noise, least distance " << least;
    }
  }
}

TEST(SurfaceSamplerExtremes, Shapes)
{
  Faces one;
  one.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  one.Polygons = { { 0, 1, 2 } };
  for (const vtkIdType count : { 1, 2, 3, 300 })
  {
    Expect("one triangle", one.Make(), count);
  }
  Expect("one triangle in float", one.Make(VTK_FLOAT), 100);
  vtkNew<vtkPolyData> nothing;
  Expect("nothing", nothing, 0);

  Faces degenerate = one;
  degenerate.Points[2] = { 2, 0, 0 };
  degenerate.Polygons.push_back({ 1, 1, 1 });
  Expect("all degenerate", degenerate.Make(), 0, true);

  // One huge triangle and 800 that are a millionth as wide: nearly all samples fall on the huge one.
  Faces mixed = Square(20, 1e-6, { 5, 5, 5 });
  const auto first = static_cast<vtkIdType>(mixed.Points.size());
  mixed.Points.insert(mixed.Points.end(), one.Points.begin(), one.Points.end());
  mixed.Polygons.push_back({ first, first + 1, first + 2 });
  Expect("one huge and many tiny triangles", mixed.Make(), 400);

  // A needle of 1 : 1e6, and a fan of needles around one point.
  Faces needle = one;
  needle.Points[2] = { 0.5, 1e-6, 0 };
  Expect("a needle", needle.Make(), 200);
  Faces fan;
  fan.Points.push_back({ 0, 0, 0.2 });
  for (int i = 0; i < 120; ++i)
  {
    fan.Points.push_back({ std::cos(i * std::acos(-1.0) / 60), std::sin(i * std::acos(-1.0) / 60), 0 });
    fan.Polygons.push_back({ 0, i + 1, (i + 1) % 120 + 1 });
  }
  Expect("a fan of needles", fan.Make(), 100);

  // A book: forty pages on one edge.
  Faces book;
  book.Points = { { 0, 0, 0 }, { 0, 0, 1 } };
  for (int i = 0; i < 40; ++i)
  {
    book.Points.push_back({ std::cos(i * 0.15), std::sin(i * 0.15), 0.5 });
    book.Polygons.push_back({ 0, 1, i + 2 });
  }
  Expect("a book", book.Make(), 100);

  // Soup: triangles that share no points, in random orientation, some twice.
  Faces soup;
  std::uint32_t state = 1;
  const auto next = [&]
  {
    state = state * 1664525u + 1013904223u;
    return static_cast<double>(state >> 8) / (1 << 24);
  };
  for (vtkIdType i = 0; i < 300; ++i)
  {
    const Position middle = { next(), next(), next() };
    for (int corner = 0; corner < 3; ++corner)
    {
      soup.Points.push_back({ middle[0] + 0.1 * next(), middle[1] + 0.1 * next(), middle[2] + 0.1 * next() });
    }
    soup.Polygons.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
    if (i % 7 == 0)
    {
      soup.Polygons.push_back({ 3 * i + 2, 3 * i + 1, 3 * i });
    }
  }
  Expect("soup", soup.Make(), 600);
  Expect("more pieces than samples", soup.Make(), 20);
}

TEST(SurfaceSamplerExtremes, Points)
{
  const auto expect = [&](const std::string& name, const std::vector<Position>& positions)
  {
    Faces faces;
    faces.Points = positions;
    vtkNew<vtkInkPointPriority> order;
    vtkNew<InkTestMessages> messages;
    messages->Observe(order);
    order->SetInputData(faces.Make());
    order->Update();
    vtkPolyData* output = order->GetOutput();
    EXPECT_TRUE(
      output->GetNumberOfPoints() == static_cast<vtkIdType>(positions.size()) && messages->Messages.empty())
      << name << ": all points";
    CheckValidPoints(name, output);
  };
  expect("one point", { { 1, 2, 3 } });
  expect("two points", { { 1, 2, 3 }, { 1, 2, 4 } });
  expect("points at one position", std::vector<Position>(100, { 1e7, 1e7, 1e7 }));
  for (const double scale : { 1e-30, 1e-9, 1e9, 1e30 })
  {
    std::vector<Position> line;
    std::vector<Position> plane;
    for (int i = 0; i < 400; ++i)
    {
      line.push_back({ scale * i, 0, 0 });
      plane.push_back({ scale * (i % 20), scale * (i / 20), scale * 1e7 });
    }
    expect("a line", line);
    expect("a plane", plane);
  }
}
