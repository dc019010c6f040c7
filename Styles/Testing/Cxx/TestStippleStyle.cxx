// SPDX-License-Identifier: BSD-3-Clause
// Stipples of images, meshes, points and composite data, their number and their colors.
#include "StyleData.h"
#include "StyleErrors.h"

#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkStippleGenerator.h"
#include "vtkInkStippleMapper.h"
#include "vtkInkStippleStyle.h"

#include "Tone/Stipple/ProjectedSize.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkLineSource.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

TEST(StippleStyle, StipplesOfImagesAreTheGenerators)
{
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetInputData(MakeBall());
  generator->SetGradientPercentile(50);
  generator->Update();
  vtkNew<vtkInkStippleStyle> style;
  style->SetParameterAsString("StippleSource", "volume");
  style->SetParameter("GradientPercentile", 50);
  for (const double smoothing : { 0.0, 1.5 })
  {
    generator->SetSmoothing(smoothing);
    generator->Update();
    style->SetParameter("Smoothing", smoothing);
    ASSERT_TRUE(style->Draw(MakeBall()));
    EXPECT_EQ(CountOf(style), generator->GetOutput()->GetNumberOfPoints());
  }
  const vtkIdType smoothed = CountOf(style);
  // Automatic smoothing is another one, and the generator keeps its own.
  style->SetParameter("Smoothing", -1.0);
  ASSERT_TRUE(style->Draw(MakeBall()));
  EXPECT_NE(CountOf(style), smoothed);
  EXPECT_EQ(style->GetGenerator()->GetSmoothing(), 0.0);
  EXPECT_EQ(style->GetPiece(vtkInkStippleStyle::SURFACE)->GetNumberOfCells(), 0);
  EXPECT_EQ(style->GetPiece(vtkInkStippleStyle::NUMBERS)->GetNumberOfPoints(), 1);
  EXPECT_TRUE(style->GetOfImage());
  EXPECT_TRUE(style->IsSeenThrough());
  EXPECT_EQ(style->GetStippleMapper()->GetPixelsPerStipple(), style->GetPixelsPerStipple());
  EXPECT_STREQ(style->GetPieceName(2), "Numbers");
  EXPECT_STREQ(style->GetPieceName(3), "Silhouettes' surface");
  EXPECT_EQ(style->GetPieceName(4), nullptr);
  EXPECT_EQ(style->GetPiece(4), nullptr);
}

TEST(StippleStyle, IsoSurfacesAreStippledThemselves)
{
  vtkNew<vtkInkStippleStyle> style;
  ASSERT_TRUE(style->Draw(MakeBall()));
  ASSERT_EQ(style->GetNumberOfNotes(), 1);
  EXPECT_EQ(std::string(style->GetNote(0)).find("iso-value "), 0u);
  EXPECT_EQ(style->GetParameterAsString("IsoValues"), "");
  const vtkMTimeType before = style->GetMTime();
  style->SetParameterAsString("IsoValues", "60");
  EXPECT_GT(style->GetMTime(), before);
  ASSERT_TRUE(style->Draw(MakeBall()));
  EXPECT_EQ(style->GetNumberOfNotes(), 0);
  EXPECT_FALSE(style->IsSeenThrough());
  // All of them on the surface, which hides what lies behind it, whatever the number of voxels.
  vtkPolyData* stipples = style->GetPiece(0);
  const double perList = static_cast<double>(stipples->GetNumberOfPoints()) / stipples->GetNumberOfVerts();
  EXPECT_GT(perList, 5.0);
  EXPECT_LT(perList, 10.0);
  EXPECT_GT(CountOf(style), 10000);
  vtkPolyData* surface = style->GetPiece(vtkInkStippleStyle::SURFACE);
  EXPECT_GT(surface->GetNumberOfPoints(), 50);
  EXPECT_NE(surface->GetPointData()->GetArray("Radius"), nullptr);
  vtkDataArray* normals = stipples->GetCellData()->GetNormals();
  const double* center = MakeBall()->GetCenter();
  double sum = 0.0;
  double squares = 0.0;
  for (vtkIdType list = 0; list < stipples->GetNumberOfVerts(); ++list)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    stipples->GetVerts()->GetCellAtId(list, size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      double p[3];
      stipples->GetPoint(ids[i], p);
      vtkMath::Subtract(p, center, p);
      const double distance = vtkMath::Norm(p);
      sum += distance;
      squares += distance * distance;
      EXPECT_GT(vtkMath::Dot(p, normals->GetTuple3(list)), 0.9 * distance);
    }
  }
  const double count = static_cast<double>(stipples->GetNumberOfPoints());
  EXPECT_LT(std::sqrt(squares / count - sum * sum / (count * count)), 0.25);
  // Steps of density cost no more voxels.
  const vtkIdType all = CountOf(style);
  style->SetParameter("PixelsPerStipple", style->GetPixelsPerStipple() / 2.0);
  ASSERT_TRUE(style->Draw(MakeBall()));
  EXPECT_GT(CountOf(style), all);
  style->SetParameter("SurfaceHides", 0);
  ASSERT_TRUE(style->Draw(MakeBall()));
  EXPECT_EQ(style->GetPiece(vtkInkStippleStyle::SURFACE)->GetNumberOfPoints(), 0);
}

TEST(StippleStyle, StipplesOfPointsAreThoseOfTheirDiscs)
{
  vtkNew<vtkInkSplattingLinesStyle> lines;
  ASSERT_TRUE(lines->Make(MakeBall()));
  vtkNew<vtkInkStippleStyle> ofPoints;
  ASSERT_TRUE(ofPoints->Accepts(lines->GetPiece(0)));
  ASSERT_TRUE(ofPoints->Draw(lines->GetPiece(0)));
  vtkNew<vtkInkStippleStyle> ofImage;
  ASSERT_TRUE(ofImage->Draw(MakeBall()));
  ASSERT_EQ(CountOf(ofPoints), CountOf(ofImage));
  for (vtkIdType i = 0; i < CountOf(ofImage); ++i)
  {
    double p[3];
    ofImage->GetPiece(0)->GetPoint(i, p);
    EXPECT_EQ(vtkMath::Distance2BetweenPoints(p, ofPoints->GetPiece(0)->GetPoint(i)), 0.0);
  }
}

TEST(StippleStyle, PointsWithoutNormalsAreDiscsAsForLines)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);
  sphere->Update();
  vtkNew<vtkPolyData> points;
  points->SetPoints(sphere->GetOutput()->GetPoints());
  vtkNew<vtkInkStippleStyle> style;
  ASSERT_TRUE(style->Accepts(points));
  ASSERT_TRUE(style->Draw(points));
  vtkNew<vtkInkSplattingLinesStyle> lines;
  ASSERT_TRUE(lines->Draw(points));
  ASSERT_EQ(style->GetNumberOfNotes(), 1);
  EXPECT_EQ(std::string(style->GetNote(0)), lines->GetNote(0));
  EXPECT_NE(std::string(style->GetNote(0)).find("normals estimated"), std::string::npos);
  vtkNew<vtkInkStippleStyle> ofDiscs;
  ASSERT_TRUE(ofDiscs->Draw(lines->GetPiece(0)));
  EXPECT_EQ(CountOf(style), CountOf(ofDiscs));
  EXPECT_GT(CountOf(style), 10000);
  // Lines are drawn as tubes.
  vtkNew<vtkLineSource> line;
  line->Update();
  EXPECT_TRUE(style->Accepts(line->GetOutput()));
}

TEST(StippleStyle, StipplesOfMeshesHaveThePicturesRoom)
{
  vtkNew<vtkInkStippleStyle> style;
  const auto mesh = MakeMesh();
  style->CurvedMeshesOff();
  style->SetPictureSize(300);
  style->SetParameterAsString("SizeUnit", "pixels");
  ASSERT_TRUE(style->Make(mesh));
  EXPECT_EQ(CountOf(style),
    vtkInkStippleGenerator::CountForPicture(mesh, 300, style->GetParameter("PixelsPerStipple")));
  // In thousandths of the height, a picture of any size has the same ones.
  style->SetParameterAsString("SizeUnit", "thousandths");
  for (const double scale : { 1.0, 8.0 })
  {
    style->SetPictureSize(300 * scale);
    style->SetPictureHeight(200 * scale);
    ASSERT_TRUE(style->Make(mesh));
    EXPECT_EQ(CountOf(style), vtkInkStippleGenerator::CountForPicture(mesh, 1500, 6));
  }
  EXPECT_EQ(style->GetPiece(vtkInkStippleStyle::SURFACE)->GetNumberOfCells(), mesh->GetNumberOfCells());
  const vtkIdType six = CountOf(style);
  style->SetParameter("PixelsPerStipple", 3);
  ASSERT_TRUE(style->Make(mesh));
  EXPECT_GT(CountOf(style), six);
  style->SetParameter("NumberOfSurfaceStipples", 5000);
  style->SetParameter("SurfaceHides", 0);
  ASSERT_TRUE(style->Make(mesh));
  EXPECT_EQ(CountOf(style), 5000);
  EXPECT_EQ(style->GetPiece(vtkInkStippleStyle::SURFACE)->GetNumberOfCells(), 0);
  style->SetParameter("NumberOfSurfaceStipples", -1);
  ASSERT_TRUE(style->Make(mesh));
  EXPECT_EQ(CountOf(style), 8 * mesh->GetNumberOfPolys());
}

/// Of the view that shows the whole mesh, with the sphere around its bounds as high as the view, and not of
/// the parameter.
TEST(StippleStyle, InteractiveStipplesOfMeshesHaveTheViewsRoom)
{
  vtkNew<vtkInkStippleStyle> style;
  style->SetPictureSize(512);
  style->SetPictureHeight(512);
  style->InteractiveOn();
  for (const double length : { 1.0, 8.0 })
  {
    vtkNew<vtkCubeSource> box;
    box->SetXLength(length);
    box->Update();
    const double diagonal = std::sqrt(length * length + 2.0);
    const double area = (2.0 + 4.0 * length) * 1e6 / (diagonal * diagonal);
    for (const double room : { 6.0, 3.0 })
    {
      style->SetParameter("PixelsPerStipple", room);
      ASSERT_TRUE(style->Make(box->GetOutput()));
      EXPECT_NEAR(static_cast<double>(CountOf(style)), area / 4.0, 1.0) << length << ' ' << room;
    }
  }
}

/// Larger dots than asked for are said.
TEST(StippleStyle, NotesThatThereIsRoomForMore)
{
  vtkNew<vtkInkStippleStyle> style;
  style->SetParameterAsString("SizeUnit", "pixels");
  style->SetPictureSize(30000);
  ASSERT_TRUE(style->Make(MakeMesh()));
  EXPECT_EQ(CountOf(style), ink::stipple::mostForPicture);
  ASSERT_EQ(style->GetNumberOfNotes(), 1);
  EXPECT_NE(
    std::string(style->GetNote(0)).find("room for more than the 2000000 stipples"), std::string::npos);
  style->SetParameter("NumberOfSurfaceStipples", 1000);
  ASSERT_TRUE(style->Make(MakeMesh()));
  EXPECT_EQ(style->GetNumberOfNotes(), 0);
}

TEST(StippleStyle, ProjectedListsFollowThePicture)
{
  vtkNew<vtkInkStippleStyle> style;
  style->SetParameter("GradientPercentile", 50);
  style->SetParameterAsString("MaximumStipplesMode", "projected");
  style->SetPictureSize(100);
  ASSERT_TRUE(style->Make(MakeBall()));
  const vtkIdType few = CountOf(style);
  // Of images that are stippled together, as of one.
  vtkNew<vtkMultiBlockDataSet> one;
  one->SetBlock(0, MakeBall());
  ASSERT_TRUE(style->Make(one));
  EXPECT_EQ(CountOf(style), few);
  style->SetPictureSize(110);
  ASSERT_TRUE(style->Make(one));
  EXPECT_GT(CountOf(style), few);
  EXPECT_EQ(style->GetParameterAsString("MaximumStipplesMode"), "projected");
  style->SetPictureSize(600);
  ASSERT_TRUE(style->Make(MakeMesh()));
  const vtkIdType projected = CountOf(style);
  style->SetParameterAsString("MaximumStipplesMode", "fixed");
  ASSERT_TRUE(style->Make(MakeMesh()));
  // Projected: one stipple a pixel; fixed: one in six of a picture that is 1000 pixels high.
  EXPECT_NEAR(static_cast<double>(projected) / static_cast<double>(CountOf(style)), 6 * 0.6 * 0.6, 0.05);
}

TEST(StippleStyle, StipplesAreTakenAsTheyAre)
{
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetInputData(MakeBall());
  generator->Update();
  vtkNew<vtkInkStippleStyle> style;
  ASSERT_TRUE(style->Draw(generator->GetOutput()));
  EXPECT_TRUE(style->GetIdsAreInputs());
  EXPECT_EQ(style->GetPiece(0)->GetPoints(), generator->GetOutput()->GetPoints());
}

TEST(StippleStyle, ReadyStipplesAreColored)
{
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetInputData(MakeBall());
  generator->PassScalarsOn();
  generator->Update();
  vtkNew<vtkInkStippleStyle> style;
  style->SetParameterAsString("ColorMap", "viridis");
  for (const char* name : { "", "density" })
  {
    style->SetParameterAsString("ColorBy", name);
    ASSERT_TRUE(style->Draw(generator->GetOutput()));
    EXPECT_TRUE(style->GetColorByScalars()) << name;
  }
  style->SetParameterAsString("ColorBy", "pressure");
  const StyleErrors errors(style);
  EXPECT_FALSE(style->Draw(generator->GetOutput()));
  ASSERT_EQ(errors.All.size(), 1u);
  EXPECT_NE(errors.All[0].find("'pressure' to color by (cell arrays: "), std::string::npos) << errors.All[0];
  EXPECT_NE(errors.All[0].find("'density'"), std::string::npos) << errors.All[0];
}

TEST(StippleStyle, ImagesOfCompositeDataAreMeasuredTogether)
{
  vtkNew<vtkMultiBlockDataSet> both;
  both->SetBlock(0, MakeBall(16));
  both->SetBlock(1, MakeBall(20));
  vtkNew<vtkInkStippleStyle> style;
  ASSERT_TRUE(style->Make(both));
  const vtkIdType together = CountOf(style);
  ASSERT_TRUE(style->Make(MakeBall(16)));
  const vtkIdType first = CountOf(style);
  ASSERT_TRUE(style->Make(MakeBall(20)));
  EXPECT_GT(together, std::max(first, CountOf(style)));
  both->SetBlock(2, MakeMesh());
  const StyleErrors errors(style);
  EXPECT_FALSE(style->Make(both));
  ASSERT_EQ(errors.All.size(), 1u);
  EXPECT_NE(errors.All[0].find("one kind at a time"), std::string::npos);
  EXPECT_EQ(CountOf(style), together);
}

TEST(StippleStyle, ColorsAreThoseAskedFor)
{
  vtkNew<vtkInkStippleStyle> style;
  ASSERT_TRUE(style->Draw(MakeBall()));
  EXPECT_FALSE(style->GetColorByScalars());
  style->SetParameterAsString("ColorMap", "viridis");
  ASSERT_TRUE(style->Draw(MakeBall()));
  EXPECT_TRUE(style->GetColorByScalars());
  style->SetParameterAsString("ColorMap", "");
  EXPECT_FALSE(style->GetColorByScalars());
  style->SetParameterAsString("ColorMap", "red,blue");
  style->SetParameterAsString("ColorBy", "pressure");
  const StyleErrors errors(style);
  EXPECT_FALSE(style->Make(MakeBall()));
  ASSERT_EQ(errors.All.size(), 1u);
  EXPECT_NE(errors.All[0].find("'pressure' to color by (point arrays: 'density')"), std::string::npos)
    << errors.All[0];
  // Interactively what is there is passed on, and what is not is not missed.
  style->InteractiveOn();
  EXPECT_TRUE(style->Make(MakeBall()));
  EXPECT_EQ(style->GetMadeColorArray(), "");
  style->SetColorArray("density", vtkDataObject::FIELD_ASSOCIATION_POINTS);
  EXPECT_TRUE(style->Make(MakeBall()));
  EXPECT_EQ(style->GetMadeColorArray(), "density");
}

} // namespace
