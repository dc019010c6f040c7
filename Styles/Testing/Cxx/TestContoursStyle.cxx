// SPDX-License-Identifier: BSD-3-Clause
// The surfaces whose contours are drawn: iso-surfaces of images as meshes, and meshes with and without
// normals.
#include "StyleErrors.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkInkContoursStyle.h"
#include "vtkInkSilhouetteMapper.h"

#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkFeatureEdges.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace
{

constexpr double Nan = std::numeric_limits<double>::quiet_NaN();

/// Samples of a function at positions from -1 to 1 along each axis, in an image that lies where it likes.
vtkSmartPointer<vtkImageData> MakeImage(
  int side, const std::function<double(double, double, double)>& function, double scale = 1.0)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(side, side, side);
  const double spacing = 2.0 / (side - 1);
  image->SetSpacing(scale * spacing, scale * spacing, scale * spacing);
  image->SetOrigin(-scale, -scale, -scale);
  vtkNew<vtkDoubleArray> values;
  for (int k = 0; k < side; ++k)
  {
    for (int j = 0; j < side; ++j)
    {
      for (int i = 0; i < side; ++i)
      {
        values->InsertNextValue(function(i * spacing - 1.0, j * spacing - 1.0, k * spacing - 1.0));
      }
    }
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

double Ball(double x, double y, double z)
{
  return 1.0 - std::hypot(x, y, z);
}

vtkSmartPointer<vtkInkContoursStyle> MakeStyle()
{
  auto style = vtkSmartPointer<vtkInkContoursStyle>::New();
  style->SetParameterAsString("IsoValues", "0.4");
  return style;
}

/// How far points are from a sphere around the origin, and their normals from its, at most.
void ExpectSphere(vtkPolyData* surface, double radius, double tolerance)
{
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  ASSERT_GT(surface->GetNumberOfPoints(), 100);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* p = surface->GetPoint(i);
    const double length = vtkMath::Norm(p);
    EXPECT_NEAR(length, radius, tolerance * radius);
    EXPECT_GT(vtkMath::Dot(p, normals->GetTuple3(i)) / length, 0.995);
  }
}

/// Edges of one triangle only.
vtkIdType CountBorders(vtkPolyData* surface)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ManifoldEdgesOff();
  edges->BoundaryEdgesOn();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

TEST(ContoursStyle, IsoSurfacesAreClosedMeshesWithNormals)
{
  for (const double scale : { 1.0, 1e-9, 1e9 })
  {
    const auto style = MakeStyle();
    ASSERT_TRUE(style->Draw(MakeImage(24, Ball, scale)));
    ExpectSphere(style->GetPiece(0), 0.6 * scale, 0.01);
    EXPECT_EQ(CountBorders(style->GetPiece(0)), 0);
    EXPECT_EQ(style->GetNumberOfNotes(), 0);
    // The points that other styles make of it: not the mesh's, but on the same sphere.
    double frame[6];
    style->GetFramePoints()->GetBounds(frame);
    for (int side = 0; side < 6; ++side)
    {
      EXPECT_NEAR(frame[side], (side % 2 ? 0.6 : -0.6) * scale, 0.01 * scale);
    }
    EXPECT_EQ(style->GetSilhouetteMapper()->GetInput(), style->GetPiece(0));
  }
}

TEST(ContoursStyle, SmoothingAndSubdivisionAreThoseOfTheSampler)
{
  const auto style = MakeStyle();
  ASSERT_TRUE(style->SetParameter("Smoothing", 0));
  ASSERT_TRUE(style->SetParameter("Subdivision", 1));
  ASSERT_TRUE(style->Make(MakeImage(24, Ball)));
  const vtkIdType plain = style->GetPiece(0)->GetNumberOfPoints();
  ASSERT_TRUE(style->SetParameter("Subdivision", 2));
  ASSERT_TRUE(style->Make(MakeImage(24, Ball)));
  EXPECT_NEAR(static_cast<double>(style->GetPiece(0)->GetNumberOfPoints()), 4.0 * plain, 0.2 * plain);
  ExpectSphere(style->GetPiece(0), 0.6, 0.005);
  // Smoothing shrinks a surface, but not where only normals are smoothed.
  ASSERT_TRUE(style->SetParameter("Smoothing", 2));
  ASSERT_TRUE(style->Make(MakeImage(24, Ball)));
  ExpectSphere(style->GetPiece(0), 0.6, 0.01);
  ASSERT_TRUE(style->SetParameterAsString("SmoothingTarget", "surface"));
  ASSERT_TRUE(style->Make(MakeImage(24, Ball)));
  EXPECT_LT(vtkMath::Norm(style->GetPiece(0)->GetPoint(0)), 0.59);
}

TEST(ContoursStyle, PartsAndSeveralSurfaces)
{
  const auto two = MakeImage(40,
    [](double x, double y, double z)
    { return std::max(0.7 - std::hypot(x - 0.3, y, z), 0.5 - std::hypot(x + 0.65, y, z)); });
  const auto style = MakeStyle();
  ASSERT_TRUE(style->SetParameter("SmallestPart", 0));
  ASSERT_TRUE(style->Make(two));
  double both[6];
  style->GetPiece(0)->GetBounds(both);
  EXPECT_NEAR(both[0], -0.75, 0.02);
  ASSERT_TRUE(style->SetParameter("LargestParts", 1));
  ASSERT_TRUE(style->Make(two));
  double largest[6];
  style->GetPiece(0)->GetBounds(largest);
  EXPECT_NEAR(largest[0], 0.0, 0.02);
  EXPECT_NEAR(largest[1], both[1], 1e-6);
  ASSERT_TRUE(style->SetParameterAsString("IsoValues", "0.2,0.4"));
  const vtkIdType one = style->GetPiece(0)->GetNumberOfPoints();
  ASSERT_TRUE(style->Make(two));
  EXPECT_GT(style->GetPiece(0)->GetNumberOfPoints(), 3 * one);
  EXPECT_EQ(CountBorders(style->GetPiece(0)), 0);
}

TEST(ContoursStyle, WhatLeavesTheImageHasABorder)
{
  const auto half = MakeImage(24, [](double x, double y, double z) { return Ball(x - 1.0, y, z); });
  const auto style = MakeStyle();
  ASSERT_TRUE(style->Make(half));
  const vtkIdType rim = CountBorders(style->GetPiece(0));
  EXPECT_GT(rim, 20);
  const vtkIdType open = style->GetPiece(0)->GetNumberOfPoints();
  // A cap lies in the image's side, with its normal, and has a border of its own.
  ASSERT_TRUE(style->SetParameterAsString("Cut", "cap"));
  ASSERT_TRUE(style->Make(half));
  vtkPolyData* closed = style->GetPiece(0);
  EXPECT_GT(CountBorders(closed), rim);
  EXPECT_GT(closed->GetNumberOfPoints(), open);
  vtkIdType caps = 0;
  for (vtkIdType i = 0; i < closed->GetNumberOfPoints(); ++i)
  {
    const double* p = closed->GetPoint(i);
    EXPECT_LT(p[0], 1.0 + 1e-3);
    const double* normal = closed->GetPointData()->GetNormals()->GetTuple3(i);
    caps += normal[0] == 1.0 ? 1 : 0;
    EXPECT_LE(std::hypot(p[1], p[2]), 0.61);
  }
  EXPECT_EQ(caps, closed->GetNumberOfPoints() - open);
}

TEST(ContoursStyle, MissingValuesMakeNoSurface)
{
  const auto holes =
    MakeImage(24, [](double x, double y, double z) { return x > 0.2 ? Nan : Ball(x, y, z); });
  const auto style = MakeStyle();
  ASSERT_TRUE(style->Make(holes));
  ASSERT_GT(style->GetPiece(0)->GetNumberOfPoints(), 100);
  double bounds[6];
  style->GetPiece(0)->GetBounds(bounds);
  EXPECT_NEAR(bounds[0], -0.6, 0.02);
  EXPECT_LT(bounds[1], 0.25);
  EXPECT_GT(CountBorders(style->GetPiece(0)), 10);
}

TEST(ContoursStyle, NothingToDrawIsNotedOrRefused)
{
  const auto style = MakeStyle();
  style->SetParameterAsString("IsoValues", "7");
  EXPECT_TRUE(style->Draw(MakeImage(8, Ball)));
  ASSERT_EQ(style->GetNumberOfNotes(), 1);
  EXPECT_NE(std::string(style->GetNote(0)).find("no surface at iso-value 7"), std::string::npos);
  EXPECT_EQ(style->GetSilhouetteMapper()->GetInput(), nullptr);
  vtkNew<vtkImageData> flat;
  flat->SetDimensions(8, 8, 1);
  flat->AllocateScalars(VTK_DOUBLE, 1);
  flat->GetPointData()->GetScalars()->Fill(0.0);
  const StyleErrors errors(style);
  EXPECT_FALSE(style->Draw(flat));
  ASSERT_EQ(errors.All.size(), 1u);
  EXPECT_NE(errors.All[0].find("found 8 x 8 x 1"), std::string::npos) << errors.All[0];
  // Points have no contours.
  vtkNew<vtkPolyData> cloud;
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  cloud->SetPoints(sphere->GetOutput()->GetPoints());
  EXPECT_EQ(style->GetReasonAgainst(cloud),
    "expected an image or a mesh with polygons, found points without polygons "
    "(Illustration and Splatting Lines draw points)");
}

TEST(ContoursStyle, MeshesWithoutNormalsGetSome)
{
  vtkNew<vtkCubeSource> cube;
  cube->Update();
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(cube->GetOutput()->GetPoints());
  mesh->SetPolys(cube->GetOutput()->GetPolys());
  vtkNew<vtkInkContoursStyle> style;
  ASSERT_TRUE(style->Draw(mesh));
  ASSERT_EQ(style->GetNumberOfNotes(), 1);
  EXPECT_NE(std::string(style->GetNote(0)).find("no normals"), std::string::npos);
  // Those of the faces, not between them.
  vtkDataArray* normals = style->GetPiece(0)->GetPointData()->GetNormals();
  ASSERT_EQ(normals->GetNumberOfTuples(), 24);
  for (vtkIdType i = 0; i < 24; ++i)
  {
    double range = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      range = std::max(range, std::abs(normals->GetComponent(i, c)));
    }
    EXPECT_NEAR(range, 1.0, 1e-6);
  }
}

TEST(ContoursStyle, CompositesAndGridsAreDrawnByTheirSurfaces)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkNew<vtkMultiBlockDataSet> meshes;
  meshes->SetBlock(0, sphere->GetOutput());
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(2, 2, 2);
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->InsertNextValue(2.0);
  coordinates->InsertNextValue(3.0);
  grid->SetXCoordinates(coordinates);
  grid->SetYCoordinates(coordinates);
  grid->SetZCoordinates(coordinates);
  meshes->SetBlock(2, grid);
  const auto style = MakeStyle();
  ASSERT_TRUE(style->Draw(meshes));
  double bounds[6];
  style->GetPiece(0)->GetBounds(bounds);
  EXPECT_NEAR(bounds[0], -0.5, 0.03);
  EXPECT_NEAR(bounds[1], 3.0, 1e-6);
  ASSERT_GE(style->GetNumberOfNotes(), 1);
  EXPECT_NE(std::string(style->GetNote(0)).find("outer surface of a vtkRectilinearGrid"), std::string::npos);
  vtkNew<vtkMultiBlockDataSet> images;
  images->SetBlock(0, MakeImage(24, Ball));
  images->SetBlock(1, MakeImage(24, Ball, 2.0));
  ASSERT_TRUE(style->Draw(images));
  style->GetPiece(0)->GetBounds(bounds);
  EXPECT_NEAR(bounds[1], 1.2, 0.02);
  EXPECT_EQ(CountBorders(style->GetPiece(0)), 0);
  EXPECT_FALSE(style->GetSilhouetteMapper()->GetCreases());
}

TEST(ContoursStyle, CreasesAreThoseOfMeshes)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkNew<vtkInkContoursStyle> style;
  ASSERT_TRUE(style->Draw(sphere->GetOutput()));
  EXPECT_TRUE(style->GetSilhouetteMapper()->GetCreases());
  ASSERT_TRUE(style->Draw(MakeImage(12, Ball)));
  EXPECT_FALSE(style->GetSilhouetteMapper()->GetCreases());
  EXPECT_EQ(style->GetParameterAsString("Creases"), "on");
  style->ApplyPreset("brush");
  EXPECT_EQ(style->GetParameterAsString("Creases"), "off");
  EXPECT_EQ(style->GetSilhouetteMapper()->GetLineWidth(), 6.0);
}

TEST(ContoursStyle, EdgeVoxelsTellProgress)
{
  const auto image =
    MakeImage(31, [](double x, double y, double z) { return std::erfc((std::hypot(x, y, z) - 0.6) / 0.1); });
  vtkNew<vtkInkContoursStyle> style;
  style->SetParameterAsString("Method", "voxel-segments");
  std::set<std::string> told;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&told);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void*)
    {
      static_cast<std::set<std::string>*>(client)->insert(
        static_cast<vtkInkStyle*>(caller)->GetProgressText());
    });
  style->AddObserver(vtkCommand::ProgressEvent, command);
  ASSERT_TRUE(style->Make(image));
  EXPECT_TRUE(told.contains("finding edge voxels"));
}

/// Segments through voxels are made from an image's edge voxels, and drawn as soon as these are there.
TEST(ContoursStyle, VoxelSegmentsAreThoseOfEdgeVoxels)
{
  const auto image =
    MakeImage(31, [](double x, double y, double z) { return std::erfc((std::hypot(x, y, z) - 0.6) / 0.1); });
  vtkNew<vtkInkContoursStyle> style;
  vtkInkSilhouetteMapper* mapper = style->GetSilhouetteMapper();
  ASSERT_TRUE(style->Draw(image));
  ASSERT_TRUE(style->SetParameterAsString("Method", "voxel-segments"));
  EXPECT_EQ(mapper->GetMethod(), vtkInkSilhouetteMapper::IMAGE_SPACE) << "the surface is still the piece";
  ASSERT_TRUE(style->Draw(image));
  EXPECT_EQ(mapper->GetMethod(), vtkInkSilhouetteMapper::VOXEL_SEGMENTS);
  vtkPolyData* voxels = style->GetPiece(0);
  ASSERT_GT(voxels->GetNumberOfPoints(), 500);
  double greatest = 0.0;
  for (vtkIdType i = 0; i < voxels->GetNumberOfPoints(); ++i)
  {
    const double magnitude = vtkMath::Norm(voxels->GetPointData()->GetArray("Gradient")->GetTuple3(i));
    greatest = std::max(greatest, magnitude);
    if (magnitude > 1.0)
    {
      EXPECT_NEAR(vtkMath::Norm(voxels->GetPoint(i)), 0.6, 0.09);
    }
  }
  EXPECT_NEAR(mapper->GetLeastGradientMagnitude(), 0.2 * greatest, 1e-4 * greatest);
  style->SetParameter("LeastGradient", 0.5);
  EXPECT_NEAR(mapper->GetLeastGradientMagnitude(), 0.5 * greatest, 1e-4 * greatest);
  const vtkIdType before = voxels->GetNumberOfPoints();
  style->SetParameter("EdgeScale", 0.0);
  ASSERT_TRUE(style->Draw(image));
  EXPECT_NE(style->GetPiece(0)->GetNumberOfPoints(), before);

  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  {
    const StyleErrors errors(style);
    EXPECT_FALSE(style->Draw(sphere->GetOutput()));
    ASSERT_EQ(errors.All.size(), 1u);
    EXPECT_NE(errors.All[0].find("need an image, found a mesh"), std::string::npos) << errors.All[0];
  }
  for (const auto& [name, method] :
    { std::pair("image-space", vtkInkSilhouetteMapper::IMAGE_SPACE),
      std::pair("toon", vtkInkSilhouetteMapper::TOON), std::pair("chains", vtkInkSilhouetteMapper::CHAINS) })
  {
    style->SetParameterAsString("Method", name);
    ASSERT_TRUE(style->Draw(sphere->GetOutput()));
    EXPECT_EQ(mapper->GetMethod(), method);
  }
}

} // namespace
