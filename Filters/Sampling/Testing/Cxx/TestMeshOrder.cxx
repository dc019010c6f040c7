// SPDX-License-Identifier: BSD-3-Clause
// What is made of a mesh does not depend on how its points and faces are numbered.

#include "SamplerTestMeshes.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkInkStippleGenerator.h"
#include "vtkInkSurfaceSampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <random>

namespace
{

/// A bent sheet, with a cell array that says which face is which.
vtkSmartPointer<vtkPolyData> MakeSheet(bool triangles)
{
  auto mesh = MakePatch(40, 30, triangles,
    [](double u, double v, double p[3])
    {
      p[0] = u;
      p[1] = v;
      p[2] = 0.2 * std::sin(5.0 * u) * v;
    });
  vtkNew<vtkFloatArray> which;
  which->SetName("Which");
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    which->InsertNextValue(static_cast<float>(cell));
  }
  mesh->GetCellData()->SetScalars(which);
  return mesh;
}

/// The same mesh with its points and faces in another order.
vtkSmartPointer<vtkPolyData> Shuffle(vtkPolyData* mesh)
{
  std::mt19937 random(1);
  std::vector<vtkIdType> newIds(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  std::iota(newIds.begin(), newIds.end(), vtkIdType(0));
  std::shuffle(newIds.begin(), newIds.end(), random);
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(newIds[static_cast<std::size_t>(i)], mesh->GetPoint(i));
  }
  std::vector<vtkIdType> cells(static_cast<std::size_t>(mesh->GetNumberOfCells()));
  std::iota(cells.begin(), cells.end(), vtkIdType(0));
  std::shuffle(cells.begin(), cells.end(), random);
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkFloatArray> which;
  which->SetName("Which");
  for (const vtkIdType cell : cells)
  {
    vtkNew<vtkIdList> corners;
    mesh->GetCellPoints(cell, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      corners->SetId(i, newIds[static_cast<std::size_t>(corners->GetId(i))]);
    }
    polys->InsertNextCell(corners);
    which->InsertNextValue(static_cast<float>(mesh->GetCellData()->GetScalars()->GetTuple1(cell)));
  }
  auto shuffled = vtkSmartPointer<vtkPolyData>::New();
  shuffled->SetPoints(points);
  shuffled->SetPolys(polys);
  shuffled->GetCellData()->SetScalars(which);
  return shuffled;
}

bool AreEqual(vtkDataArray* a, vtkDataArray* b)
{
  if (!a || !b || a->GetDataType() != b->GetDataType() || a->GetNumberOfValues() != b->GetNumberOfValues())
  {
    return false;
  }
  return std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
           static_cast<std::size_t>(a->GetNumberOfValues()) *
             static_cast<std::size_t>(a->GetDataTypeSize())) == 0;
}

} // namespace

TEST(MeshOrder, DoesNotChangeTheSamples)
{
  for (const bool triangles : { false, true })
  {
    const auto mesh = MakeSheet(triangles);
    const auto other = Shuffle(mesh);
    for (const int method : { vtkInkSurfaceSampler::BLUE_NOISE, vtkInkSurfaceSampler::WHITE_NOISE })
    {
      std::array<vtkNew<vtkInkSurfaceSampler>, 2> samplers;
      for (int i = 0; i < 2; ++i)
      {
        samplers[i]->SetInputData(i == 0 ? mesh : other);
        samplers[i]->SetMethod(method);
        samplers[i]->SetNumberOfSamples(3000);
        samplers[i]->Update();
      }
      vtkPolyData* a = samplers[0]->GetOutput();
      vtkPolyData* b = samplers[1]->GetOutput();
      EXPECT_TRUE(
        a->GetNumberOfPoints() == 3000 && AreEqual(a->GetPoints()->GetData(), b->GetPoints()->GetData()))
        << "the same samples by method " << method;
      for (const char* name : { "Normals", "Radius", "Priority" })
      {
        EXPECT_TRUE(AreEqual(a->GetPointData()->GetArray(name), b->GetPointData()->GetArray(name)))
          << "the same " << name << " by method " << method;
      }
    }
    std::array<vtkNew<vtkInkStippleGenerator>, 2> generators;
    for (int i = 0; i < 2; ++i)
    {
      generators[i]->SetInputData(i == 0 ? mesh : other);
      generators[i]->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Which");
      generators[i]->PassScalarsOn();
      generators[i]->Update();
    }
    vtkPolyData* a = generators[0]->GetOutput();
    vtkPolyData* b = generators[1]->GetOutput();
    EXPECT_TRUE(a->GetNumberOfPoints() == 8 * mesh->GetNumberOfCells() &&
      AreEqual(a->GetPoints()->GetData(), b->GetPoints()->GetData()))
      << "the same stipples";
    EXPECT_TRUE(AreEqual(a->GetPointData()->GetArray("Priority"), b->GetPointData()->GetArray("Priority")))
      << "the same Priority";
    EXPECT_TRUE(a->GetNumberOfCells() == b->GetNumberOfCells() &&
      AreEqual(a->GetCellData()->GetNormals(), b->GetCellData()->GetNormals()))
      << "the same elements";
    EXPECT_TRUE(AreEqual(a->GetCellData()->GetScalars(), b->GetCellData()->GetScalars()))
      << "each element with its own polygon's value";
  }
}
