// SPDX-License-Identifier: BSD-3-Clause
// Styles draw what an algorithm makes, a few slices at a time where memory asks for it.

#include "vtkImageData.h"
#include "vtkInkIllustrationStyle.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkStippleStyle.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRTAnalyticSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace
{

/// Beside the program there is 1 MiB, of which this image takes 2.
constexpr int Little = 97;

class StyleSources : public testing::Test
{
protected:
  StyleSources() { this->Source->SetWholeExtent(0, 63, 0, 63, 0, 127); }

  vtkNew<vtkRTAnalyticSource> Source;
};

/// The points of the first piece; the rim of a cut follows those of each part.
std::vector<std::array<double, 3>> Sorted(vtkInkStyle* style)
{
  std::vector<std::array<double, 3>> points(
    static_cast<std::size_t>(style->GetPiece(0)->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    style->GetPiece(0)->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  std::sort(points.begin(), points.end());
  return points;
}

void ExpectSamePieces(vtkInkStyle* found, vtkInkStyle* expected)
{
  ASSERT_GT(expected->GetPiece(0)->GetNumberOfPoints(), 1000);
  EXPECT_TRUE(Sorted(found) == Sorted(expected));
  EXPECT_EQ(found->GetFramePoints()->GetNumberOfPoints(), expected->GetFramePoints()->GetNumberOfPoints());
}

} // namespace

TEST_F(StyleSources, MarksAreThoseOfTheImageInMemory)
{
  for (const char* name : { "splatting-lines", "illustration" })
  {
    vtkNew<vtkRTAnalyticSource> whole;
    whole->SetWholeExtent(0, 63, 0, 63, 0, 127);
    whole->Update();
    const auto expected = vtk::TakeSmartPointer(vtkInkStyle::CreateStyle(name));
    const auto style = vtk::TakeSmartPointer(vtkInkStyle::CreateStyle(name));
    ASSERT_TRUE(expected->Draw(whole->GetOutput()));
    style->SetMaximumMemory(Little);
    EXPECT_EQ(style->TryDraw(this->Source->GetOutputPort()), "");
    EXPECT_LT(this->Source->GetOutput()->GetDimensions()[2], 20) << "slices at a time";
    ExpectSamePieces(style, expected);
    // What was chosen is named the same.
    ASSERT_GT(style->GetNumberOfNotes(), 0);
    EXPECT_STREQ(style->GetNote(0), expected->GetNote(0));
  }
}

TEST_F(StyleSources, SurfacesOfASamplerAreDrawnAsTheStyleSays)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputConnection(this->Source->GetOutputPort());
  sampler->SetCutToCap();
  sampler->SetValue(0, 50.0);
  vtkNew<vtkInkSplattingLinesStyle> style;
  ASSERT_TRUE(style->SetParameter("IsoValues", 150.0));
  ASSERT_TRUE(style->SetParameter("LargestParts", 1.0));
  ASSERT_TRUE(style->DrawSurfaces(sampler));
  this->Source->Update();
  vtkNew<vtkInkSplattingLinesStyle> expected;
  expected->SetParameter("IsoValues", 150.0);
  expected->SetParameter("LargestParts", 1.0);
  ASSERT_TRUE(expected->Draw(this->Source->GetOutput()));
  ExpectSamePieces(style, expected);
  EXPECT_EQ(sampler->GetCut(), vtkInkIsoSurfaceSampler::RIM);
}

TEST_F(StyleSources, WhatNeedsTheWholeSaysHowMuchMemory)
{
  vtkNew<vtkInkStippleStyle> stipple;
  stipple->SetMaximumMemory(Little);
  const std::string problem = stipple->TryDraw(this->Source->GetOutputPort());
  EXPECT_NE(
    problem.find("stipple needs the whole volume at once, 2 MiB: expected MaximumMemory of 100 MiB or more"),
    std::string::npos)
    << problem;
  EXPECT_EQ(stipple->GetPiece(0)->GetNumberOfPoints(), 0);
  vtkNew<vtkInkIllustrationStyle> illustration;
  illustration->SetMaximumMemory(Little);
  illustration->SetSeeThrough(true);
  const std::string other = illustration->TryDraw(this->Source->GetOutputPort());
  EXPECT_NE(other.find("SeeThrough needs the whole volume at once"), std::string::npos) << other;
  EXPECT_EQ(this->Source->GetOutput()->GetNumberOfPoints(), 0) << "nothing was read for that";
}

TEST_F(StyleSources, MorePointsThanMemoryHasRoomForAreRefused)
{
  this->Source->Update();
  vtkNew<vtkInkSplattingLinesStyle> style;
  style->SetMaximumMemory(1);
  const std::string problem = style->TryDraw(this->Source->GetOutput());
  EXPECT_NE(problem.find("points, which cannot be drawn in less than"), std::string::npos) << problem;
  EXPECT_NE(problem.find("expected MaximumMemory of more than that, found 1 MiB"), std::string::npos)
    << problem;
}

TEST_F(StyleSources, AnImageThatFitsIsDrawnAsAWhole)
{
  vtkNew<vtkInkStippleStyle> style;
  style->SetMaximumMemory(1024);
  ASSERT_TRUE(style->Draw(this->Source->GetOutputPort()));
  EXPECT_EQ(this->Source->GetOutput()->GetNumberOfPoints(), 64 * 64 * 128);
  EXPECT_GT(style->GetPiece(0)->GetNumberOfPoints(), 0);
}
