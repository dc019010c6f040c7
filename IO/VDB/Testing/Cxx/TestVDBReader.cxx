// SPDX-License-Identifier: BSD-3-Clause
// vtkInkVDBReader: values, transform, choice of grid, level sets' sign and update extents.

#include "InkTestMessages.h"
#include "VDBTestFiles.h"

#include "vtkImageData.h"
#include "vtkInkVDBReader.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using openvdb::Coord;

/// The image against OpenVDB's own values and positions, voxel by voxel.
template <class Grid>
void ExpectSame(vtkImageData* image, const Grid& grid, double factor)
{
  int extent[6];
  image->GetExtent(extent);
  int wrongValues = 0;
  int wrongPositions = 0;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        const double value = factor * grid.tree().getValue(Coord(i, j, k));
        wrongValues += image->GetScalarComponentAsDouble(i, j, k, 0) != value;
        const int ijk[3] = { i, j, k };
        double p[3];
        image->TransformIndexToPhysicalPoint(ijk, p);
        const openvdb::Vec3d q = grid.transform().indexToWorld(Coord(i, j, k));
        wrongPositions += (q - openvdb::Vec3d(p)).length() > 1e-9;
      }
    }
  }
  EXPECT_EQ(wrongValues, 0) << "the grid's values, " << wrongValues << " are wrong";
  EXPECT_EQ(wrongPositions, 0) << "the grid's positions, " << wrongPositions << " are wrong";
}

class VDBReader : public testing::Test
{
protected:
  VDBReader()
  {
    this->Sphere->transform().postRotate(0.5, openvdb::math::Z_AXIS);
    this->Sphere->transform().postTranslate({ 100.0, -20.0, 3.0 });
    this->Density->setName("density");
    this->Density->tree().setValue(Coord(-5, 2, 900), 1.5);
    this->Density->tree().setValue(Coord(3, 9, 905), 2.5);
    this->Density->transform().postScale({ 1.0, -2.0, 3.0 });
    const auto other = ink::testing::emptyGrid<openvdb::Vec3SGrid>("velocity");
    this->File = WriteVDB(".vdb", { other, this->Sphere, this->Density });
    this->Messages->Observe(this->Reader);
    this->Reader->SetFileName(this->File.c_str());
  }
  void TearDown() override { EXPECT_TRUE(this->Messages->Messages.empty()) << this->Messages->Messages[0]; }

  openvdb::FloatGrid::Ptr Sphere = MakeSphere();
  openvdb::DoubleGrid::Ptr Density = openvdb::DoubleGrid::create(0.25);
  std::string File;
  vtkNew<vtkInkVDBReader> Reader;
  vtkNew<InkTestMessages> Messages;
};

} // namespace

TEST_F(VDBReader, ListsTheGridsOfAFile)
{
  EXPECT_EQ(Reader->CanReadFile(File.c_str()), 1);
  EXPECT_EQ(Reader->CanReadFile("none.vdb"), 0);
  Reader->UpdateInformation();
  EXPECT_EQ(Reader->GetNumberOfGrids(), 3);
  EXPECT_STREQ(Reader->GetNameOfGrid(1), "sphere");
  EXPECT_STREQ(Reader->GetTypeOfGrid(0), "vec3s");
  EXPECT_STREQ(Reader->GetTypeOfGrid(2), "double");
  EXPECT_STREQ(Reader->GetClassOfGrid(1), "level set");
  EXPECT_STREQ(Reader->GetNameOfGrid(3), "") << "there is no fourth grid";
  std::array<int, 3> dimensions;
  Reader->GetDimensionsOfGrid(2, dimensions.data());
  EXPECT_EQ(dimensions, (std::array<int, 3>{ 9, 8, 6 }));
  EXPECT_EQ(Reader->GetNumberOfActiveVoxelsOfGrid(2), 2);
  EXPECT_EQ(Reader->GetGridNames()->GetNumberOfValues(), 2) << "grids that can be read";
}

TEST_F(VDBReader, ReadsTheFirstGridThatItCanAndInvertsLevelSets)
{
  Reader->Update();
  vtkImageData* image = Reader->GetOutput();
  EXPECT_EQ(image->GetScalarType(), VTK_FLOAT);
  EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "sphere");
  ExpectSame(image, *Sphere, -1.0);
  Reader->InvertLevelSetsOff();
  Reader->Update();
  ExpectSame(image, *Sphere, 1.0);
}

TEST_F(VDBReader, ReadsTheChosenGridWithPaddingAndPartsOfIt)
{
  Reader->SetGridName("density");
  Reader->SetPadding(3);
  Reader->Update();
  vtkImageData* image = Reader->GetOutput();
  std::array<int, 6> extent;
  image->GetExtent(extent.data());
  EXPECT_EQ(extent, (std::array<int, 6>{ -8, 6, -1, 12, 897, 908 })) << "3 voxels around";
  EXPECT_EQ(image->GetScalarType(), VTK_DOUBLE);
  ExpectSame(image, *Density, 1.0);

  const std::array<int, 6> part{ -5, 0, 2, 3, 900, 900 };
  Reader->Modified();
  Reader->UpdateExtent(part.data());
  image->GetExtent(extent.data());
  EXPECT_EQ(extent, part);
  ExpectSame(image, *Density, 1.0);
}
