// SPDX-License-Identifier: BSD-3-Clause
// vtkInkSurfaceSampler on unstructured and structured grids: their surface, or their points where there are
// no cells.

#include "InkTestMessages.h"
#include "SamplerTestMeshes.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkFloatArray.h"
#include "vtkInkSurfaceSampler.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

constexpr int Size = 4;

/// The corners of Size^3 cubes with edges of 1.
vtkSmartPointer<vtkPoints> Lattice()
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  for (int i = 0; i < (Size + 1) * (Size + 1) * (Size + 1); ++i)
  {
    points->InsertNextPoint(i % (Size + 1), i / (Size + 1) % (Size + 1), i / ((Size + 1) * (Size + 1)));
  }
  return points;
}

vtkSmartPointer<vtkStructuredGrid> Structured()
{
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(Size + 1, Size + 1, Size + 1);
  grid->SetPoints(Lattice());
  return grid;
}

/// Size^3 hexahedra with a cell array "Layer" of their positions in z.
vtkSmartPointer<vtkUnstructuredGrid> Hexahedra()
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(Lattice());
  vtkNew<vtkFloatArray> layer;
  layer->SetName("Layer");
  const auto structured = Structured();
  for (vtkIdType cell = 0; cell < structured->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    structured->GetCellPoints(cell, ids);
    grid->InsertNextCell(VTK_HEXAHEDRON, ids);
    layer->InsertNextValue(static_cast<float>(cell / (Size * Size)));
  }
  grid->GetCellData()->AddArray(layer);
  return grid;
}

void CheckOnCube(const std::string& name, vtkPolyData* samples, double scale)
{
  EXPECT_EQ(samples->GetNumberOfPoints(), 2000) << name << ": 2000 points";
  int sides[6] = { 0, 0, 0, 0, 0, 0 };
  double farthest = 0.0;
  for (vtkIdType i = 0; i < samples->GetNumberOfPoints(); ++i)
  {
    double p[3];
    samples->GetPoint(i, p);
    double least = 1e30;
    int side = 0;
    for (int n = 0; n < 6; ++n)
    {
      const double distance = std::abs(p[n / 2] - (n % 2 ? scale * Size : 0.0));
      side = distance < least ? n : side;
      least = std::min(least, distance);
    }
    ++sides[side];
    farthest = std::max(farthest, least);
  }
  EXPECT_LT(farthest, 1e-5 * scale) << name << ": points on the cube";
  // A sixth of them each: 333.
  const auto [fewest, most] = std::minmax_element(sides, sides + 6);
  EXPECT_TRUE(*fewest > 300 && *most < 370)
    << name << ": as many on each side, found " << *fewest << " to " << *most;
}

} // namespace

TEST(SurfaceSamplerGrids, SamplesTheirSurface)
{
  const vtkSmartPointer<vtkPointSet> grids[] = { Structured(), Hexahedra() };
  for (vtkPointSet* grid : grids)
  {
    vtkNew<vtkInkSurfaceSampler> sampler;
    vtkNew<InkTestMessages> messages;
    messages->Observe(sampler);
    sampler->SetInputDataObject(grid);
    sampler->SetNumberOfSamples(2000);
    sampler->Update();
    CheckOnCube(grid->GetClassName(), sampler->GetOutput(), 1.0);
    messages->Expect(grid->GetClassName(), {});
  }
}

/// Only the lower half of the cube's cells.
TEST(SurfaceSamplerGrids, FollowsADensityOfTheirCells)
{
  const auto grid = Hexahedra();
  auto* layer = vtkFloatArray::SafeDownCast(grid->GetCellData()->GetArray("Layer"));
  for (vtkIdType i = 0; i < layer->GetNumberOfTuples(); ++i)
  {
    layer->SetValue(i, layer->GetValue(i) < Size / 2 ? 1.0f : 0.0f);
  }
  vtkNew<vtkInkSurfaceSampler> sampler;
  sampler->SetInputData(grid);
  sampler->SetNumberOfSamples(1000);
  sampler->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Layer");
  sampler->Update();
  EXPECT_EQ(sampler->GetOutput()->GetNumberOfPoints(), 1000) << "1000 points";
  EXPECT_TRUE(
    sampler->GetOutput()->GetBounds()[5] <= Size / 2 && sampler->GetOutput()->GetBounds()[5] > Size / 2 - 0.2)
    << "density by an array of the grid's cells, up to " << sampler->GetOutput()->GetBounds()[5];
}

TEST(SurfaceSamplerGrids, FollowsTheirDeformation)
{
  const auto grid = Hexahedra();
  vtkNew<vtkInkSurfaceSampler> sampler;
  sampler->SetInputData(grid);
  sampler->SetNumberOfSamples(2000);
  sampler->FollowDeformationOn();
  sampler->Update();
  vtkNew<vtkPolyData> before;
  before->DeepCopy(sampler->GetOutput());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double p[3];
    grid->GetPoint(i, p);
    grid->GetPoints()->SetPoint(i, 2.0 * p[0], 2.0 * p[1], 2.0 * p[2]);
  }
  grid->GetPoints()->Modified();
  grid->Modified();
  sampler->Update();
  CheckOnCube("deformed", sampler->GetOutput(), 2.0);
  EXPECT_EQ(sampler->GetNumberOfSamplings(), 1) << "one sampling";
  double p[3];
  double q[3];
  before->GetPoint(77, p);
  sampler->GetOutput()->GetPoint(77, q);
  EXPECT_LT(std::abs(2.0 * p[0] - q[0]) + std::abs(2.0 * p[1] - q[1]) + std::abs(2.0 * p[2] - q[2]), 1e-5)
    << "samples that moved with the grid";
}

TEST(SurfaceSamplerGrids, WithoutFacesAreClouds)
{
  const auto ball = MakeBall(40, 2.0);
  vtkNew<vtkUnstructuredGrid> bare;
  bare->SetPoints(ball->GetPoints());
  vtkNew<vtkUnstructuredGrid> vertices;
  vertices->SetPoints(ball->GetPoints());
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    vertices->InsertNextCell(VTK_VERTEX, 1, &i);
  }
  for (vtkUnstructuredGrid* grid : { bare.Get(), vertices.Get() })
  {
    vtkNew<vtkInkSurfaceSampler> sampler;
    sampler->SetInputData(grid);
    sampler->RemoveIsolatedOff();
    sampler->Update();
    EXPECT_EQ(sampler->GetOutput()->GetNumberOfPoints(), ball->GetNumberOfPoints())
      << "a cloud of " << ball->GetNumberOfPoints() << " points";
  }
}
