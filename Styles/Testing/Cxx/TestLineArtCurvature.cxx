// SPDX-License-Identifier: BSD-3-Clause
// Where the curvature of line art comes from: strokes on the iso-surface of a noisy scan of a torus follow
// its known lines of curvature.
#include "HashNoise.h"
#include "vtkInkLineArtStyle.h"
#include "vtkInkLinesOfCurvature.h"
#include "vtkInkStrokeMapper.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace
{

constexpr int Side = 48;

/// 1 inside a torus around the z axis and 0 outside, blurred over a voxel, with noise of 8 % of the step.
vtkSmartPointer<vtkImageData> MakeScan()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Side, Side, Side);
  const double voxel = 2.0 / (Side - 1);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->SetSpacing(voxel, voxel, voxel);
  vtkNew<vtkFloatArray> values;
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
  {
    double p[3];
    image->GetPoint(n, p);
    const double distance = std::hypot(std::hypot(p[0], p[1]) - 0.62, p[2]) - 0.26;
    values->InsertNextValue(static_cast<float>(
      0.5 * std::erfc(distance / voxel) + 0.08 * ink::testing::hashNormal(1, static_cast<std::uint64_t>(n))));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// The mean angle, in degrees, between strokes along maximum curvature and the circles around the tube, where
/// the torus is curved along its tube, too.
double MeanAngle(vtkPolyData* strokes)
{
  double angles = 0.0;
  double length = 0.0;
  vtkDataArray* family = strokes->GetCellData()->GetArray("LineFamily");
  for (vtkIdType line = 0; line < strokes->GetNumberOfLines(); ++line)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    strokes->GetLines()->GetCellAtId(line, count, ids);
    for (vtkIdType i = 0; i + 1 < count && family->GetTuple1(line) == 0.0; ++i)
    {
      glm::dvec3 from;
      glm::dvec3 to;
      strokes->GetPoint(ids[i], &from.x);
      strokes->GetPoint(ids[i + 1], &to.x);
      const double size = glm::distance(from, to);
      if (size > 0.0)
      {
        const glm::dvec3 around = glm::normalize(glm::dvec3(-from.y, from.x, 0.0));
        angles += size * std::asin(std::min(std::abs(glm::dot(around, (to - from) / size)), 1.0));
        length += size;
      }
    }
  }
  return angles / length * 180.0 / std::acos(-1.0);
}

} // namespace

TEST(LineArtStyle, CurvatureOfTheImageIsThatOfTheForm)
{
  const vtkSmartPointer<vtkImageData> scan = MakeScan();
  vtkNew<vtkInkLineArtStyle> style;
  ASSERT_TRUE(style->SetParameterAsString("IsoValues", "0.5"));
  ASSERT_TRUE(style->SetParameter("LineSpacing", 16));
  ASSERT_TRUE(style->SetParameter("Subdivision", 1));
  EXPECT_EQ(style->GetCurvature(), vtkInkLineArtStyle::OF_IMAGE);
  ASSERT_TRUE(style->Make(scan));
  EXPECT_EQ(style->GetNumberOfNotes(), 0);
  // What lines are traced by is not delivered.
  EXPECT_FALSE(style->GetPiece(0)->GetPointData()->HasArray("k1"));
  const double ofImage = MeanAngle(style->GetPiece(1));
  ASSERT_TRUE(style->SetParameterAsString("Curvature", "mesh"));
  ASSERT_TRUE(style->Make(scan));
  const double ofMesh = MeanAngle(style->GetPiece(1));
  // Measured: 0.50 and 0.58 degrees.
  EXPECT_LT(ofImage, 0.75);
  EXPECT_LT(ofImage, 0.95 * ofMesh);
}

TEST(LineArtStyle, FamiliesFollowCrosshatching)
{
  vtkNew<vtkInkLineArtStyle> style;
  const auto families = [&] { return style->GetLinesOfCurvature()->GetFamilies(); };
  EXPECT_EQ(families(), vtkInkLinesOfCurvature::BOTH);
  const vtkMTimeType before = style->GetMTime();
  ASSERT_TRUE(style->SetParameter("Crosshatch", 0.4));
  EXPECT_EQ(families(), vtkInkLinesOfCurvature::BOTH);
  EXPECT_EQ(style->GetMTime(), before) << "the strokes that there are serve";
  ASSERT_TRUE(style->SetParameter("Crosshatch", 0));
  EXPECT_EQ(families(), vtkInkLinesOfCurvature::MAXIMUM);
  EXPECT_GT(style->GetMTime(), before);
  style->InteractiveOn();
  EXPECT_EQ(families(), vtkInkLinesOfCurvature::BOTH);
  style->InteractiveOff();
  EXPECT_EQ(families(), vtkInkLinesOfCurvature::MAXIMUM);
  style->GetStrokeMapper()->SetCrosshatching(0.5);
  EXPECT_EQ(families(), vtkInkLinesOfCurvature::BOTH);
}
