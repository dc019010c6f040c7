// SPDX-License-Identifier: BSD-3-Clause
// From data to marks: what is accepted, what is made of images, meshes, composite data and stipples, of one
// process and of several.
#include "StyleErrors.h"

#include "InkIsoSurface.h"
#include "InkSilhouettes.h"
#include "InkStyleProcesses.h"
#include "vtkInkIllustrationStyle.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkSilhouetteMapper.h"
#include "vtkInkSplattingLinesMapper.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkStippleGenerator.h"
#include "vtkInkStippleMapper.h"
#include "vtkInkStippleStyle.h"

#include "vtkActor.h"
#include "vtkAppendFilter.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSphereSource.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

namespace
{

/// A ball of values up to 200 in the middle.
vtkSmartPointer<vtkImageData> MakeBall(int side = 16)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(side, side, side);
  vtkNew<vtkUnsignedCharArray> values;
  values->SetName("density");
  const double middle = (side - 1) / 2.0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    const double r = std::hypot(p[0] - middle, p[1] - middle, p[2] - middle) / side;
    values->InsertNextValue(static_cast<unsigned char>(std::max(0.0, 200.0 * (1.0 - 2.0 * r))));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

vtkSmartPointer<vtkPolyData> MakeMesh()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(30);
  sphere->Update();
  return sphere->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeCloud()
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(MakeMesh()->GetPoints());
  return cloud;
}

vtkIdType CountOf(vtkInkStyle* style)
{
  return style->GetPiece(0)->GetNumberOfPoints();
}

TEST(StylePieces, WhatIsAcceptedAndWhyNot)
{
  vtkNew<vtkImageData> plain;
  plain->SetDimensions(2, 2, 2);
  vtkNew<vtkTable> table;
  vtkNew<vtkPolyData> empty;
  for (const auto& style : MakeStyles())
  {
    EXPECT_TRUE(style->Accepts(MakeBall()));
    EXPECT_TRUE(style->Accepts(MakeMesh()));
    for (vtkDataObject* wrong : std::initializer_list<vtkDataObject*>{ table, empty, nullptr })
    {
      EXPECT_FALSE(style->Accepts(wrong));
      EXPECT_NE(style->GetReasonAgainst(wrong).find("expected an image, a mesh"), std::string::npos);
    }
  }
  vtkNew<vtkInkSplattingLinesStyle> lines;
  EXPECT_TRUE(lines->Accepts(MakeCloud()));
  EXPECT_NE(lines->GetReasonAgainst(plain).find("without point scalars"), std::string::npos);
  const StyleErrors errors(lines);
  EXPECT_FALSE(lines->Draw(plain));
  EXPECT_EQ(errors.All.size(), 1u);
  EXPECT_EQ(lines->GetPiece(0)->GetNumberOfPoints(), 0);
  vtkNew<vtkInkStippleStyle> stipple;
  EXPECT_NE(stipple->GetReasonAgainst(MakeCloud()).find("without polygons"), std::string::npos);
}

TEST(StylePieces, LinesOfImagesChooseAnIsoValue)
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

TEST(StylePieces, LinesOfMeshesAndPoints)
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

TEST(StylePieces, StipplesOfImagesAreTheGenerators)
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
  EXPECT_EQ(style->GetStippleMapper()->GetPixelsPerStipple(), style->GetPixelsPerStipple());
  EXPECT_STREQ(style->GetPieceName(2), "Numbers");
  EXPECT_STREQ(style->GetPieceName(3), "Silhouettes' surface");
  EXPECT_EQ(style->GetPieceName(4), nullptr);
  EXPECT_EQ(style->GetPiece(4), nullptr);
}

TEST(StylePieces, IsoSurfacesAreStippledThemselves)
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

TEST(StylePieces, StipplesOfPointsAreThoseOfTheirDiscs)
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

TEST(StylePieces, IllustrationsPutBothOnOneSurface)
{
  vtkNew<vtkInkIllustrationStyle> style;
  EXPECT_TRUE(style->Accepts(MakeCloud()));
  for (const vtkSmartPointer<vtkDataObject>& data : { vtkSmartPointer<vtkDataObject>(MakeBall()),
         vtkSmartPointer<vtkDataObject>(MakeMesh()), vtkSmartPointer<vtkDataObject>(MakeCloud()) })
  {
    ASSERT_TRUE(style->Draw(data));
    EXPECT_GT(style->GetPiece(0)->GetNumberOfPoints(), 50);
    EXPECT_GT(style->GetPiece(2)->GetNumberOfPoints(), 1000);
    EXPECT_EQ(
      style->GetPiece(2)->GetNumberOfPoints(), style->GetStippleStyle()->GetPiece(0)->GetNumberOfPoints());
    EXPECT_EQ(style->GetActor()->GetMapper(), style->GetMapper());
    double lines[6];
    double stipples[6];
    style->GetPiece(0)->GetBounds(lines);
    style->GetPiece(2)->GetBounds(stipples);
    const double size = lines[1] - lines[0];
    for (int i = 0; i < 6; ++i)
    {
      EXPECT_NEAR(lines[i], stipples[i], 0.05 * size) << data->GetClassName();
    }
  }
  EXPECT_STREQ(style->GetPieceName(0), "Points");
  EXPECT_STREQ(style->GetPieceName(1), "Silhouettes' surface");
  EXPECT_STREQ(style->GetPieceName(2), "Stipples");
  EXPECT_STREQ(style->GetPieceName(5), "Outer points");
  // Light ink shows light.
  style->SetParameterAsString("InkColor", "white");
  style->SetParameterAsString("PaperColor", "black");
  EXPECT_TRUE(style->GetStippleStyle()->GetStippleMapper()->GetLightInk());
  double paper[3];
  style->GetBackgroundColor(paper);
  EXPECT_EQ(paper[0], 0.0);
}

TEST(StylePieces, MakingMarksIsNoChange)
{
  for (const auto& style : MakeStyles())
  {
    for (const vtkSmartPointer<vtkDataObject>& data :
      std::initializer_list<vtkSmartPointer<vtkDataObject>>{ MakeBall(), MakeMesh() })
    {
      const vtkMTimeType before = style->GetMTime();
      ASSERT_TRUE(style->Draw(data));
      EXPECT_EQ(style->GetMTime(), before) << style->GetName();
      ASSERT_TRUE(style->Draw(data));
      EXPECT_EQ(style->GetMTime(), before) << style->GetName();
    }
  }
  vtkNew<vtkInkStippleStyle> style;
  ASSERT_TRUE(style->Draw(MakeBall()));
  const vtkMTimeType made = style->GetMTime();
  style->GetGenerator()->SetSeed(7);
  EXPECT_GT(style->GetMTime(), made);
}

TEST(StylePieces, StipplesOfMeshesHaveThePicturesRoom)
{
  vtkNew<vtkInkStippleStyle> style;
  const auto mesh = MakeMesh();
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
  style->InteractiveOn();
  ASSERT_TRUE(style->Make(mesh));
  EXPECT_EQ(CountOf(style), six);
  style->SetParameter("NumberOfSurfaceStipples", 5000);
  style->SetParameter("SurfaceHides", 0);
  ASSERT_TRUE(style->Make(mesh));
  EXPECT_EQ(CountOf(style), 5000);
  EXPECT_EQ(style->GetPiece(vtkInkStippleStyle::SURFACE)->GetNumberOfCells(), 0);
  style->SetParameter("NumberOfSurfaceStipples", -1);
  ASSERT_TRUE(style->Make(mesh));
  EXPECT_EQ(CountOf(style), 8 * mesh->GetNumberOfPolys());
}

TEST(StylePieces, ProjectedListsFollowThePicture)
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

/// Into how many cells a style divides a voxel's edge.
int SubdivisionOf(vtkInkStyle* style, vtkImageData* image)
{
  InkIsoSurface surface;
  surface.SetIsoValues({ 100.0 });
  EXPECT_EQ(surface.Prepare(style, std::array{ image }, {}), "");
  return surface.GetSampler()->GetSubdivision();
}

TEST(StylePieces, CellsAreAPartOfThePictureWhateverItsPixels)
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

TEST(StylePieces, ManyPointsAreNotDivided)
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

TEST(StylePieces, StipplesAreTakenAsTheyAre)
{
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetInputData(MakeBall());
  generator->Update();
  vtkNew<vtkInkStippleStyle> style;
  ASSERT_TRUE(style->Draw(generator->GetOutput()));
  EXPECT_TRUE(style->GetIdsAreInputs());
  EXPECT_EQ(style->GetPiece(0)->GetPoints(), generator->GetOutput()->GetPoints());
}

TEST(StylePieces, ReadyStipplesAreColored)
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
  EXPECT_NE(errors.All[0].find("'pressure'"), std::string::npos) << errors.All[0];
}

TEST(StylePieces, ImagesOfCompositeDataAreMeasuredTogether)
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

TEST(StylePieces, ColorsAreThoseAskedFor)
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
  EXPECT_NE(errors.All[0].find("\"pressure\""), std::string::npos) << errors.All[0];
  // Interactively what is there is passed on, and what is not is not missed.
  style->InteractiveOn();
  EXPECT_TRUE(style->Make(MakeBall()));
  EXPECT_EQ(style->GetMadeColorArray(), "");
  style->SetColorArray("density", vtkDataObject::FIELD_ASSOCIATION_POINTS);
  EXPECT_TRUE(style->Make(MakeBall()));
  EXPECT_EQ(style->GetMadeColorArray(), "density");
}

TEST(StylePieces, NothingToDrawIsNoted)
{
  vtkNew<vtkImageData> even;
  even->SetDimensions(8, 8, 8);
  even->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  even->GetPointData()->GetScalars()->Fill(7);
  vtkNew<vtkInkStippleStyle> style;
  EXPECT_TRUE(style->Draw(even));
  ASSERT_EQ(style->GetNumberOfNotes(), 1);
  EXPECT_NE(std::string(style->GetNote(0)).find("nothing to draw"), std::string::npos);
  EXPECT_EQ(style->GetStippleMapper()->GetInput(), nullptr);
  vtkNew<vtkInkSplattingLinesStyle> lines;
  const StyleErrors errors(lines);
  EXPECT_FALSE(lines->Draw(even));
  EXPECT_EQ(errors.All.size(), 1u);
}

/// Two materials, the one around the other, blurred as a scanner does.
vtkSmartPointer<vtkImageData> MakeNested(int side = 40)
{
  const auto image = MakeBall(side);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    const double middle = (side - 1) / 2.0;
    const double r = std::hypot(p[0] - middle, p[1] - middle, p[2] - middle) / side;
    const auto step = [&](double radius) { return 1.0 / (1.0 + std::exp((r - radius) * 2.0 * side)); };
    values->SetComponent(i, 0, 60.0 * step(0.4) + 120.0 * step(0.2));
  }
  return image;
}

double LargestRadius(vtkPolyData* points, const double center[3])
{
  double largest = 0.0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    largest = std::max(largest, std::sqrt(vtkMath::Distance2BetweenPoints(p, center)));
  }
  return largest;
}

TEST(StylePieces, SeeThroughHasASurfaceAroundAnother)
{
  constexpr int outer = 5;
  const auto image = MakeNested();
  vtkNew<vtkInkIllustrationStyle> style;
  ASSERT_TRUE(style->Draw(image));
  ASSERT_EQ(style->GetNumberOfPieces(), 2 * outer);
  EXPECT_EQ(style->GetPieceName(2 * outer), nullptr);
  EXPECT_NEAR(LargestRadius(style->GetPiece(0), image->GetCenter()), 16, 0.5);
  for (int piece = outer; piece < 2 * outer; ++piece)
  {
    EXPECT_EQ(style->GetPiece(piece)->GetNumberOfPoints(), 0) << style->GetPieceName(piece);
  }
  EXPECT_FALSE(style->GetMapper()->HasTranslucentPolygonalGeometry());
  double alone[6];
  style->GetActor()->GetBounds(alone);

  style->SetParameter("SeeThrough", 1);
  ASSERT_TRUE(style->Draw(image));
  EXPECT_NEAR(LargestRadius(style->GetPiece(0), image->GetCenter()), 8, 0.5);
  EXPECT_NEAR(LargestRadius(style->GetPiece(outer), image->GetCenter()), 16, 0.5);
  EXPECT_GT(style->GetPiece(outer + 2)->GetNumberOfPoints(), 10000);
  ASSERT_EQ(style->GetNumberOfNotes(), 2);
  EXPECT_EQ(std::string(style->GetNote(0)).find("outer iso-value "), 0u);
  EXPECT_EQ(std::string(style->GetNote(1)).find("inner iso-value "), 0u);
  // What was chosen is no parameter, and the frame is around both.
  EXPECT_EQ(style->GetParameterAsString("IsoValues"), "");
  EXPECT_EQ(style->GetFramePoints(), style->GetPiece(outer)->GetPoints());
  EXPECT_TRUE(style->GetMapper()->HasOpaqueGeometry());
  EXPECT_TRUE(style->GetMapper()->HasTranslucentPolygonalGeometry());
  double both[6];
  style->GetActor()->GetBounds(both);
  EXPECT_NEAR(both[0], alone[0], 0.5);

  // One of the values, or both, can be given.
  style->SetParameter("IsoValues", 150);
  ASSERT_TRUE(style->Make(image));
  EXPECT_EQ(style->GetNumberOfNotes(), 1);
  const double inner = LargestRadius(style->GetPiece(0), image->GetCenter());
  EXPECT_LT(inner, 7.9);
  style->SetParameter("OuterIsoValue", 100);
  ASSERT_TRUE(style->Make(image));
  EXPECT_EQ(style->GetNumberOfNotes(), 0);
  EXPECT_EQ(LargestRadius(style->GetPiece(0), image->GetCenter()), inner);
  EXPECT_NEAR(LargestRadius(style->GetPiece(outer), image->GetCenter()), 8.3, 0.4);
  style->SetParameter("SeeThrough", 0);
  ASSERT_TRUE(style->Draw(image));
  EXPECT_EQ(style->GetPiece(outer)->GetNumberOfPoints(), 0);
  EXPECT_FALSE(style->GetMapper()->HasTranslucentPolygonalGeometry());
}

TEST(StylePieces, SeeThroughNeedsTwoBoundaries)
{
  vtkNew<vtkInkIllustrationStyle> style;
  style->SetParameter("SeeThrough", 1);
  const StyleErrors errors(style);
  EXPECT_FALSE(style->Draw(MakeBall()));
  ASSERT_EQ(errors.All.size(), 1u);
  EXPECT_NE(errors.All[0].find("two clear boundaries"), std::string::npos) << errors.All[0];
  // Of a mesh there is one surface.
  EXPECT_TRUE(style->Draw(MakeMesh()));
  EXPECT_GT(CountOf(style), 0);
}

TEST(StylePieces, GridsAndCompositesAreDrawnByTheirSurfaces)
{
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(5, 6, 7);
  for (const auto& [axis, count] : { std::pair{ 0, 5 }, { 1, 6 }, { 2, 7 } })
  {
    vtkNew<vtkDoubleArray> coordinates;
    for (int i = 0; i < count; ++i)
    {
      coordinates->InsertNextValue(i * i);
    }
    axis == 0     ? grid->SetXCoordinates(coordinates)
      : axis == 1 ? grid->SetYCoordinates(coordinates)
                  : grid->SetZCoordinates(coordinates);
  }
  vtkNew<vtkAppendFilter> toUnstructured;
  toUnstructured->AddInputData(grid);
  toUnstructured->Update();
  vtkDataObject* unstructured = toUnstructured->GetOutput();
  vtkNew<vtkMultiBlockDataSet> meshes;
  meshes->SetBlock(0, MakeMesh());
  meshes->SetBlock(1, grid);
  vtkNew<vtkMultiBlockDataSet> images;
  images->SetBlock(0, MakeBall(16));
  images->SetBlock(2, MakeBall(20));
  vtkNew<vtkInkIllustrationStyle> illustration;
  vtkNew<vtkInkSplattingLinesStyle> lines;
  for (vtkInkStyle* style : std::initializer_list<vtkInkStyle*>{ illustration, lines })
  {
    for (vtkDataObject* data : std::initializer_list<vtkDataObject*>{ grid, unstructured, meshes, images })
    {
      EXPECT_TRUE(style->Draw(data)) << style->GetName() << ' ' << data->GetClassName();
      EXPECT_GT(CountOf(style), 1000) << style->GetName() << ' ' << data->GetClassName();
      EXPECT_EQ(style->GetNumberOfNotes(), 1) << style->GetName() << ' ' << data->GetClassName();
    }
    ASSERT_TRUE(style->Draw(grid));
    EXPECT_NE(
      std::string(style->GetNote(0)).find("outer surface of a vtkRectilinearGrid"), std::string::npos);
    ASSERT_TRUE(style->Draw(images));
    const vtkIdType together = CountOf(style);
    ASSERT_TRUE(style->Draw(MakeBall(20)));
    EXPECT_GT(together, CountOf(style));
    images->SetBlock(1, MakeMesh());
    const StyleErrors errors(style);
    EXPECT_FALSE(style->Draw(images));
    ASSERT_EQ(errors.All.size(), 1u);
    EXPECT_NE(errors.All[0].find("1 datasets beside images"), std::string::npos) << errors.All[0];
    EXPECT_EQ(CountOf(style), together);
    images->SetBlock(1, nullptr);
  }
  EXPECT_GT(illustration->GetPiece(2)->GetNumberOfPoints(), 1000);
}

TEST(StylePieces, SilhouettesAreOfTheSurfaceThatIsDrawn)
{
  vtkNew<vtkInkSplattingLinesStyle> lines;
  vtkNew<vtkInkStippleStyle> stipple;
  vtkNew<vtkInkIllustrationStyle> illustration;
  struct Case
  {
    vtkInkStyle* Style;
    int Piece;
    vtkInkSilhouetteMapper* Mapper;
  };
  for (const auto& [style, piece, mapper] :
    { Case{ lines, vtkInkSplattingLinesStyle::SILHOUETTES, lines->GetSilhouettes()->GetMapper() },
      Case{ stipple, vtkInkStippleStyle::SILHOUETTES, stipple->GetSilhouettes()->GetMapper() },
      Case{
        illustration, vtkInkSplattingLinesStyle::SILHOUETTES, illustration->GetSilhouettes()->GetMapper() } })
  {
    for (const auto& data :
      { vtkSmartPointer<vtkDataObject>(MakeBall()), vtkSmartPointer<vtkDataObject>(MakeMesh()) })
    {
      SCOPED_TRACE(std::string(style->GetName()) + ' ' + data->GetClassName());
      const bool ofImage = vtkImageData::SafeDownCast(data) != nullptr;
      style->ResetParameters();
      ASSERT_TRUE(style->Draw(data));
      EXPECT_EQ(style->GetPiece(piece)->GetNumberOfPoints(), 0);
      EXPECT_EQ(mapper->GetInput(), nullptr);
      const int notes = style->GetNumberOfNotes();
      vtkPoints* frame = style->GetFramePoints();
      const vtkIdType framed = frame->GetNumberOfPoints();
      const vtkMTimeType before = style->GetMTime();
      ASSERT_TRUE(style->SetParameter("Silhouettes", 1));
      EXPECT_GT(style->GetMTime(), before) << "a surface has to be made";
      ASSERT_TRUE(style->SetParameter("SilhouetteCreases", 1));
      ASSERT_TRUE(style->SetParameter("InkColor", 0.1, 0.2, 0.3));
      ASSERT_TRUE(style->Draw(data));
      vtkPolyData* surface = style->GetPiece(piece);
      EXPECT_GT(surface->GetNumberOfPolys(), 100);
      EXPECT_NE(surface->GetPointData()->GetNormals(), nullptr);
      EXPECT_EQ(style->GetNumberOfNotes(), notes);
      EXPECT_EQ(style->GetFramePoints()->GetNumberOfPoints(), framed);
      EXPECT_EQ(mapper->GetInput(), surface);
      EXPECT_EQ(mapper->GetInkColor()[1], 0.2);
      EXPECT_EQ(mapper->GetCreases(), !ofImage) << "those of an image are its voxels'";
      EXPECT_EQ(style->GetParameter("SilhouetteCreases"), 1.0);
      // Pixels are the picture's.
      style->SetPixelScale(2.0);
      EXPECT_EQ(mapper->GetShortestPart(), 8.0);
      style->SetPixelScale(1.0);
      ASSERT_TRUE(style->SetParameter("Silhouettes", 0));
      ASSERT_TRUE(style->Draw(data));
      EXPECT_EQ(mapper->GetInput(), nullptr);
    }
  }
  // Points have none; stipples of gradients have those of the iso-surface that suits the image.
  ASSERT_TRUE(lines->SetParameter("Silhouettes", 1));
  ASSERT_TRUE(lines->Draw(MakeCloud()));
  EXPECT_NE(std::string(lines->GetNote(0)).find("no silhouettes"), std::string::npos);
  EXPECT_EQ(lines->GetSilhouettes()->GetMapper()->GetInput(), nullptr);
  stipple->ResetParameters();
  ASSERT_TRUE(stipple->SetParameterAsString("StippleSource", "volume"));
  ASSERT_TRUE(stipple->SetParameter("Silhouettes", 1));
  ASSERT_TRUE(stipple->Draw(MakeBall()));
  EXPECT_GT(stipple->GetPiece(vtkInkStippleStyle::SILHOUETTES)->GetNumberOfPolys(), 100);
  EXPECT_EQ(stipple->GetPiece(vtkInkStippleStyle::SURFACE)->GetNumberOfPoints(), 0);
  // A preset's ink is theirs.
  stipple->ApplyPreset("plate-white-on-black");
  EXPECT_EQ(stipple->GetSilhouettes()->GetMapper()->GetInkColor()[0], 1.0);
}

/// What another process says of its part.
class TwoProcesses : public InkStyleProcesses
{
public:
  explicit TwoProcesses(int othersKind)
    : OthersKind(othersKind)
  {
  }
  void TakeGreatest(std::span<double> numbers) override
  {
    if (numbers.size() == 2)
    {
      numbers[static_cast<std::size_t>(OthersKind)] = 1;
    }
  }
  void AgreeOnArray(std::string& name, int&) override { name = name.empty() ? "theirs" : name; }

private:
  int OthersKind;
};

TEST(StylePieces, ProcessesAgree)
{
  vtkNew<vtkInkStippleStyle> style;
  // The other one has images: a mesh here is not drawn, and no data is no error.
  style->SetProcesses(std::make_shared<TwoProcesses>(0));
  EXPECT_NE(style->MakeMarks({ MakeMesh() }).find("beside images"), std::string::npos);
  EXPECT_EQ(style->MakeMarks({}), "");
  EXPECT_TRUE(style->GetOfImage());
  EXPECT_EQ(style->GetMadeColorArray(), "theirs");
  style->SetProcesses(nullptr);
  EXPECT_EQ(style->MakeMarks({ MakeMesh() }), "");
  EXPECT_EQ(style->GetMadeColorArray(), "");
}

TEST(StylePieces, ProgressIsTold)
{
  vtkNew<vtkInkStippleStyle> style;
  std::vector<std::string> steps;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&steps);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void*)
    {
      auto& all = *static_cast<std::vector<std::string>*>(client);
      const std::string text = static_cast<vtkInkStyle*>(caller)->GetProgressText();
      if (all.empty() || all.back() != text)
      {
        all.push_back(text);
      }
    });
  style->AddObserver(vtkCommand::ProgressEvent, command);
  style->SetParameterAsString("IsoValues", "60");
  ASSERT_TRUE(style->Make(MakeBall()));
  EXPECT_EQ(steps, (std::vector<std::string>{ "sampling the surface", "placing stipples" }));
}

TEST(StylePieces, LightComesFromItsSide)
{
  vtkNew<vtkInkStippleStyle> style;
  style->SetParameter("LightDirection", 90, 0);
  EXPECT_NEAR(style->GetLight()->GetPosition()[0], 1, 1e-12);
  style->SetParameter("LightDirection", 0, 90);
  EXPECT_NEAR(style->GetLight()->GetPosition()[1], 1, 1e-12);
}

} // namespace
