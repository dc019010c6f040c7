// SPDX-License-Identifier: BSD-3-Clause
// Silhouettes over the marks of styles that are no contours.
#include "StyleData.h"

#include "InkSilhouettes.h"
#include "InkStyleProcesses.h"
#include "vtkInkContoursStyle.h"
#include "vtkInkIllustrationStyle.h"
#include "vtkInkLineArtStyle.h"
#include "vtkInkSilhouetteMapper.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkStippleStyle.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <memory>
#include <new>
#include <span>
#include <string>

namespace
{

TEST(StyleSilhouettes, SilhouettesAreOfTheSurfaceThatIsDrawn)
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
      MakeFewMarks(style);
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
  // A preset's ink is theirs.
  stipple->ApplyPreset("plate-white-on-black");
  EXPECT_EQ(stipple->GetSilhouettes()->GetMapper()->GetInkColor()[0], 1.0);
}

TEST(StyleSilhouettes, PointsHaveNone)
{
  vtkNew<vtkInkSplattingLinesStyle> lines;
  ASSERT_TRUE(lines->SetParameter("Silhouettes", 1));
  ASSERT_TRUE(lines->Draw(MakeCloud()));
  EXPECT_NE(std::string(lines->GetNote(0)).find("no silhouettes"), std::string::npos);
  EXPECT_EQ(lines->GetSilhouettes()->GetMapper()->GetInput(), nullptr);
}

/// Stipples of voxels, with silhouettes of a surface that is not stippled.
vtkSmartPointer<vtkInkStippleStyle> MakeStippleStyleOfVoxels()
{
  auto style = vtkSmartPointer<vtkInkStippleStyle>::New();
  EXPECT_TRUE(style->SetParameterAsString("StippleSource", "volume"));
  EXPECT_TRUE(style->SetParameter("Silhouettes", 1));
  return style;
}

double WidthOf(vtkPolyData* surface)
{
  double bounds[6];
  surface->GetBounds(bounds);
  return bounds[1] - bounds[0];
}

TEST(StyleSilhouettes, StippledVoxelsHaveThoseOfAnIsoSurface)
{
  const auto style = MakeStippleStyleOfVoxels();
  ASSERT_TRUE(style->Draw(MakeBall()));
  EXPECT_GT(style->GetPiece(vtkInkStippleStyle::SILHOUETTES)->GetNumberOfPolys(), 100);
  EXPECT_EQ(style->GetPiece(vtkInkStippleStyle::SURFACE)->GetNumberOfPoints(), 0);
  const double chosen = WidthOf(style->GetPiece(vtkInkStippleStyle::SILHOUETTES));
  // Values up to 200 in the middle: of a diameter of a quarter of the image.
  ASSERT_TRUE(style->SetParameterAsString("IsoValues", "150"));
  ASSERT_TRUE(style->Draw(MakeBall()));
  EXPECT_NEAR(WidthOf(style->GetPiece(vtkInkStippleStyle::SILHOUETTES)), 4.0, 0.4);
  EXPECT_GT(chosen, 5.0);
  // A panel has an iso-value for its surface, which is not drawn.
  style->InteractiveOn();
  ASSERT_TRUE(style->Draw(MakeBall()));
  EXPECT_EQ(WidthOf(style->GetPiece(vtkInkStippleStyle::SILHOUETTES)), chosen);
  EXPECT_EQ(style->GetParameterAsString("IsoValues"), "150");
}

TEST(StyleSilhouettes, NoIsoSurfaceIsNoted)
{
  const auto even = MakeBall();
  even->GetPointData()->GetScalars()->Fill(7);
  const auto style = MakeStippleStyleOfVoxels();
  EXPECT_TRUE(style->Draw(even));
  ASSERT_EQ(style->GetNumberOfNotes(), 2);
  EXPECT_STREQ(style->GetNote(0),
    "there are no silhouettes: expected an image with two different finite values or more, found none");
  EXPECT_NE(std::string(style->GetNote(1)).find("nothing to draw"), std::string::npos);
}

/// A boundary, blurred, of a ball.
vtkSmartPointer<vtkImageData> MakeBlurredBall()
{
  const auto image = MakeBall(24);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetTuple1(i, std::round(120.0 + 100.0 * std::tanh((values->GetTuple1(i) - 100.0) / 20.0)));
  }
  return image;
}

/// Segments through voxels are of an image's edge voxels, all others of its surface.
TEST(StyleSilhouettes, MethodsAreOfVoxelsOrOfTheSurface)
{
  vtkNew<vtkInkSplattingLinesStyle> lines;
  vtkNew<vtkInkStippleStyle> stipple;
  vtkNew<vtkInkIllustrationStyle> illustration;
  for (vtkInkStyle* style : std::initializer_list<vtkInkStyle*>{ lines, stipple, illustration })
  {
    SCOPED_TRACE(style->GetName());
    const int ofStipples = vtkInkStippleStyle::SILHOUETTES;
    const int ofLines = vtkInkSplattingLinesStyle::SILHOUETTES;
    const int piece = style == stipple.Get() ? ofStipples : ofLines;
    vtkInkSilhouetteMapper* mapper = style == lines.Get() ? lines->GetSilhouettes()->GetMapper()
      : style == stipple.Get()                            ? stipple->GetSilhouettes()->GetMapper()
                                                          : illustration->GetSilhouettes()->GetMapper();
    MakeFewMarks(style);
    ASSERT_TRUE(style->SetParameterAsString("Silhouettes", "on"));
    ASSERT_TRUE(style->Draw(MakeBlurredBall()));
    EXPECT_EQ(mapper->GetMethod(), vtkInkSilhouetteMapper::CHAINS);
    const vtkMTimeType before = style->GetMTime();
    ASSERT_TRUE(style->SetParameterAsString("SilhouetteMethod", "toon"));
    EXPECT_EQ(style->GetMTime(), before) << "the surface is there already";
    EXPECT_EQ(mapper->GetMethod(), vtkInkSilhouetteMapper::TOON);
    ASSERT_TRUE(style->SetParameterAsString("SilhouetteMethod", "voxel-segments"));
    EXPECT_GT(style->GetMTime(), before) << "voxels have to be found";
    ASSERT_TRUE(style->Draw(MakeBlurredBall()));
    EXPECT_EQ(mapper->GetMethod(), vtkInkSilhouetteMapper::VOXEL_SEGMENTS);
    vtkPolyData* voxels = style->GetPiece(piece);
    EXPECT_EQ(mapper->GetInput(), voxels);
    EXPECT_EQ(voxels->GetNumberOfPolys(), 0);
    ASSERT_GT(voxels->GetNumberOfPoints(), 100);
    const double greatest = voxels->GetPointData()->GetArray("Gradient")->GetFiniteRange(-1)[1];
    ASSERT_TRUE(style->SetParameter("SilhouetteLeastGradient", 0.5));
    EXPECT_NEAR(mapper->GetLeastGradientMagnitude(), 0.5 * greatest, 1e-4 * greatest);
    ASSERT_TRUE(style->SetParameter("SilhouetteValueRange", 50.0, 190.0));
    EXPECT_EQ(mapper->GetHighestValue(), 190.0);

    // A mesh has no voxels: lines in image space, which are Lu's own for surfaces.
    ASSERT_TRUE(style->Draw(MakeMesh()));
    EXPECT_EQ(mapper->GetMethod(), vtkInkSilhouetteMapper::IMAGE_SPACE);
    EXPECT_GT(style->GetPiece(piece)->GetNumberOfPolys(), 100);
    bool noted = false;
    for (int note = 0; note < style->GetNumberOfNotes(); ++note)
    {
      noted = noted || std::string(style->GetNote(note)).find("voxels need an image") != std::string::npos;
    }
    EXPECT_TRUE(noted);
  }
}

TEST(StyleSilhouettes, StipplesAsPublishedHaveTheSilhouettesOfTheirPaper)
{
  vtkNew<vtkInkStippleStyle> style;
  EXPECT_EQ(style->GetParameterAsString("SilhouetteMethod"), "chains");
  const vtkMTimeType before = style->GetSilhouettes()->GetMTime();
  ASSERT_TRUE(style->ApplyPreset("as-published"));
  EXPECT_EQ(style->GetSilhouettes()->GetMTime(), before) << "without silhouettes nothing is to be made";
  EXPECT_EQ(style->GetParameterAsString("SilhouetteMethod"), "voxel-segments");
  EXPECT_EQ(style->GetParameterAsString("Silhouettes"), "off");
  ASSERT_TRUE(style->ApplyPreset("bone"));
  EXPECT_EQ(style->GetParameterAsString("SilhouetteMethod"), "chains");
}

/// And choose none.
TEST(StyleSilhouettes, SegmentsThroughVoxelsNeedNoIsoSurface)
{
  const auto style = MakeStippleStyleOfVoxels();
  ASSERT_TRUE(style->SetParameterAsString("SilhouetteMethod", "voxel-segments"));
  ASSERT_TRUE(style->Draw(MakeBlurredBall()));
  EXPECT_GT(style->GetPiece(vtkInkStippleStyle::SILHOUETTES)->GetNumberOfPoints(), 100);
  for (int note = 0; note < style->GetNumberOfNotes(); ++note)
  {
    EXPECT_EQ(std::string(style->GetNote(note)).find("iso-value"), std::string::npos) << style->GetNote(note);
  }
}

/// Hatching is on the surface, whatever contours are of.
TEST(StyleSilhouettes, LineArtKeepsItsSurface)
{
  vtkNew<vtkInkLineArtStyle> style;
  ASSERT_TRUE(style->SetParameter("Density", 0.1));
  const auto image = MakeBlurredBall();
  ASSERT_TRUE(style->Draw(image));
  vtkInkSilhouetteMapper* mapper = style->GetContoursStyle()->GetSilhouetteMapper();
  const vtkIdType strokes = style->GetPiece(1)->GetNumberOfPoints();
  ASSERT_GT(strokes, 100);
  EXPECT_EQ(style->GetPiece(2)->GetNumberOfPoints(), 0);
  ASSERT_TRUE(style->SetParameterAsString("ContourMethod", "voxel-segments"));
  ASSERT_TRUE(style->Draw(image));
  EXPECT_EQ(style->GetPiece(1)->GetNumberOfPoints(), strokes);
  EXPECT_GT(style->GetPiece(0)->GetNumberOfPolys(), 100);
  EXPECT_EQ(mapper->GetInput(), style->GetPiece(2));
  EXPECT_EQ(mapper->GetMethod(), vtkInkSilhouetteMapper::VOXEL_SEGMENTS);
  EXPECT_EQ(mapper->GetInputDataObject(1, 0), style->GetPiece(0)) << "it hides what is behind";
  ASSERT_TRUE(style->Draw(MakeMesh()));
  EXPECT_EQ(mapper->GetMethod(), vtkInkSilhouetteMapper::IMAGE_SPACE);
  EXPECT_GT(style->GetPiece(1)->GetNumberOfPoints(), 0);
}

/// Runs out of memory where the surface is put together.
class TooLarge : public InkStyleProcesses
{
public:
  InkWholeImages GatherImages(std::span<vtkImageData* const>) override { throw std::bad_alloc(); }
};

TEST(StyleSilhouettes, AFailureLeavesTheIsoValue)
{
  const auto style = MakeStippleStyleOfVoxels();
  style->InteractiveOn();
  ASSERT_TRUE(style->SetParameterAsString("IsoValues", "150"));
  style->SetProcesses(std::make_shared<TooLarge>());
  EXPECT_NE(style->MakeMarks({ MakeBall() }).find("memory"), std::string::npos);
  EXPECT_EQ(style->GetParameterAsString("IsoValues"), "150");
}

} // namespace
