// SPDX-License-Identifier: BSD-3-Clause
// Splatting lines of images, meshes and points, and into how many cells voxels are divided.
#include "StyleData.h"

#include "InkIsoSurface.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkSplattingLinesMapper.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkSurfaceSampler.h"

#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkPointData.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace
{

TEST(SplattingLinesStyle, LinesOfImagesChooseAnIsoValue)
{
  vtkNew<vtkInkSplattingLinesStyle> style;
  ASSERT_TRUE(style->Draw(MakeBall()));
  EXPECT_GT(CountOf(style), 100);
  ASSERT_EQ(style->GetNumberOfNotes(), 1);
  EXPECT_EQ(std::string(style->GetNote(0)).find("iso-value "), 0u);
  EXPECT_EQ(style->GetLinesMapper()->GetInput(), style->GetPiece(0));
  EXPECT_EQ(style->GetActor()->GetMapper(), style->GetMapper());
  EXPECT_EQ(style->GetLight(), nullptr);
  const vtkIdType chosen = CountOf(style);
  style->SetParameterAsString("IsoValues", "150");
  ASSERT_TRUE(style->Make(MakeBall()));
  EXPECT_LT(CountOf(style), chosen);
  EXPECT_EQ(style->GetNumberOfNotes(), 0);
  const vtkIdType inner = CountOf(style);
  style->SetParameterAsString("IsoValues", "150,50");
  ASSERT_TRUE(style->Make(MakeBall()));
  EXPECT_GT(CountOf(style), 2 * inner);
}

TEST(SplattingLinesStyle, SamplesFollowMeshesThatTurn)
{
  // The box around it is larger then, and so fewer samples have room by that.
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkTransform> turn;
  vtkNew<vtkTransformPolyDataFilter> turned;
  turned->SetInputConnection(cube->GetOutputPort());
  turned->SetTransform(turn);
  vtkNew<vtkInkSplattingLinesStyle> style;
  vtkInkSurfaceSampler* sampler = style->GetSurfaceSampler();
  std::array<vtkIdType, 2> counts;
  for (const bool follows : { false, true })
  {
    sampler->SetFollowDeformation(follows);
    for (const bool isTurned : { false, true })
    {
      turn->Identity();
      turn->RotateZ(isTurned ? 45.0 : 0.0);
      turned->Update();
      ASSERT_TRUE(style->Make(turned->GetOutput()));
      counts[isTurned ? 1 : 0] = CountOf(style);
    }
    EXPECT_EQ(counts[0] == counts[1], follows) << counts[0] << " and " << counts[1];
  }
  EXPECT_EQ(sampler->GetNumberOfSamplings(), 3);
  // Other faces are sampled anew.
  ASSERT_TRUE(style->Make(MakeMesh()));
  EXPECT_EQ(CountOf(style), 200000);
  EXPECT_EQ(sampler->GetNumberOfSamplings(), 4);
}

TEST(SplattingLinesStyle, LinesOfMeshesAndPoints)
{
  vtkNew<vtkInkSplattingLinesStyle> style;
  const auto mesh = MakeMesh();
  ASSERT_TRUE(style->Make(mesh));
  EXPECT_EQ(CountOf(style), 200000);
  style->SetParameter("NumberOfSamples", 3000);
  ASSERT_TRUE(style->Make(mesh));
  EXPECT_EQ(CountOf(style), 3000);
  style->SetParameter("NumberOfSamples", 0);
  ASSERT_TRUE(style->Make(mesh));
  EXPECT_EQ(CountOf(style), mesh->GetNumberOfPoints());
  EXPECT_EQ(style->GetNumberOfNotes(), 0);
  mesh->GetPointData()->SetNormals(nullptr);
  ASSERT_TRUE(style->Make(mesh));
  EXPECT_NE(style->GetPiece(0)->GetPointData()->GetNormals(), nullptr);
  EXPECT_EQ(style->GetNumberOfNotes(), 1);
  style->ResetParameters();
  ASSERT_TRUE(style->Make(MakeCloud()));
  EXPECT_EQ(CountOf(style), MakeCloud()->GetNumberOfPoints());
  EXPECT_NE(std::string(style->GetNote(0)).find("estimated"), std::string::npos);
}

/// Into how many cells a style divides a voxel's edge.
int SubdivisionOf(vtkInkStyle* style, vtkImageData* image)
{
  InkIsoSurface surface;
  surface.SetIsoValues({ 100.0 });
  EXPECT_EQ(surface.Prepare(style, std::array{ image }), "");
  return surface.GetSampler()->GetSubdivision();
}

TEST(SplattingLinesStyle, CellsAreAPartOfThePictureWhateverItsPixels)
{
  vtkNew<vtkInkSplattingLinesStyle> style;
  for (const double height : { 1.0, 200.0, 2000.0, 20000.0 })
  {
    style->SetPictureSize(height);
    style->SetPictureHeight(height);
    // 1 / 15 and 1 / 100 of the picture; a twenty-fifth of a hundredth is small enough.
    EXPECT_EQ(SubdivisionOf(style, MakeBall(16)), 8) << height;
    EXPECT_EQ(SubdivisionOf(style, MakeBall(101)), 4) << height;
  }
  // The data fills twice the picture's height.
  style->SetPictureHeight(10000.0);
  EXPECT_EQ(SubdivisionOf(style, MakeBall(101)), 8);
  EXPECT_EQ(style->GetNumberOfNotes(), 0);
}

TEST(SplattingLinesStyle, WhatIsSmallInAnImageFillsThePictureAllTheSame)
{
  const int side = 128;
  const auto image = MakeBall(side);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  values->Fill(0.0);
  const auto small = MakeBall(16);
  for (vtkIdType i = 0; i < small->GetNumberOfPoints(); ++i)
  {
    const vtkIdType x = 90 + i % 16;
    const vtkIdType y = 20 + i / 16 % 16;
    const vtkIdType z = 60 + i / 256;
    values->SetTuple(x + side * (y + side * z), i, small->GetPointData()->GetScalars());
  }
  vtkNew<vtkInkSplattingLinesStyle> style;
  EXPECT_EQ(SubdivisionOf(style, image), 8);
  // A view shows it as large as it does.
  style->InteractiveOn();
  EXPECT_EQ(SubdivisionOf(style, image), 2);
  style->SetPictureSize(8.0 * style->GetPictureHeight());
  EXPECT_EQ(SubdivisionOf(style, image), 8);
}

TEST(SplattingLinesStyle, ManyPointsAreNotDivided)
{
  // The surface lies in all cells of 63^3.
  const auto image = MakeBall(64);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetComponent(i, 0, 200.0 * static_cast<double>((i + i / 64 + i / 4096) % 2));
  }
  vtkNew<vtkInkSplattingLinesStyle> style;
  EXPECT_EQ(SubdivisionOf(style, image), 4);
  EXPECT_EQ(style->GetNumberOfNotes(), 0);
  style->SetPictureSize(2.0 * style->GetPictureHeight());
  EXPECT_EQ(SubdivisionOf(style, image), 4) << "8 would make 63^3 * 64 points, more than 16 million";
  ASSERT_EQ(style->GetNumberOfNotes(), 1);
  EXPECT_STREQ(style->GetNote(0),
    "voxels are divided by 4, not 8, along each axis, as the surface lies in 250047 of them (Subdivision)");
}

} // namespace
