// SPDX-License-Identifier: BSD-3-Clause
// Scans in thick slices: contours are interpolated between them where values make terraces, by points and
// meshes.
#include "StyleData.h"

#include "InkIsoSurface.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkSplattingLinesStyle.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace
{

constexpr double Slope = 0.8;
constexpr double Radius = 14.0;

/// How far from the axis of a slanted cylinder, in the slice.
double DistanceOf(const double p[3])
{
  return std::hypot(p[0] - Slope * p[2], p[1]);
}

vtkSmartPointer<vtkImageData> MakeSlices(
  double sliceDistance, const std::function<double(double distance)>& value, bool hidesCorner = false)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int slices = 1 + static_cast<int>(48.0 / sliceDistance);
  image->SetDimensions(80, 44, slices);
  image->SetSpacing(1.0, 1.0, sliceDistance);
  image->SetOrigin(-39.5, -21.5, -0.5 * sliceDistance * (slices - 1));
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfValues(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    values->SetValue(i, static_cast<float>(value(DistanceOf(p))));
  }
  image->GetPointData()->SetScalars(values);
  if (hidesCorner)
  {
    image->AllocatePointGhostArray();
    image->GetPointGhostArray()->SetValue(0, vtkDataSetAttributes::HIDDENPOINT);
  }
  return image;
}

/// Sharp, with an iso-value near what is outside.
double Skin(double distance)
{
  return 500.0 * std::erfc((distance - Radius) / 0.99);
}

double Label(double distance)
{
  return distance < Radius ? 3.0 : 0.0;
}

/// Root mean square angle between the normals and those of the cylinder, degrees, away from its cuts.
double AngleOf(vtkPolyData* surface)
{
  double sum = 0.0;
  double count = 0.0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    if (std::abs(p[2]) > 15.0)
    {
      continue;
    }
    const double x = p[0] - Slope * p[2];
    const double* n = surface->GetPointData()->GetNormals()->GetTuple(i);
    const double cosine =
      (x * n[0] + p[1] * n[1] - Slope * x * n[2]) / std::hypot(std::hypot(x, p[1]), Slope * x);
    sum += std::pow(std::acos(std::clamp(cosine, -1.0, 1.0)), 2);
    ++count;
  }
  EXPECT_GT(count, 1000.0);
  return std::sqrt(sum / count) * 180.0 / std::acos(-1.0);
}

struct Angles
{
  double Points;
  double Mesh;
  double Smoothing;
  bool operator==(const Angles&) const = default;
};

Angles Draw(vtkImageData* image, const char* isoValues, const char* interpolation)
{
  vtkNew<vtkInkSplattingLinesStyle> style;
  style->SetParameter("Subdivision", 1);
  EXPECT_TRUE(style->SetParameterAsString("IsoValues", isoValues));
  EXPECT_TRUE(style->SetParameterAsString("ShapeBasedInterpolation", interpolation));
  EXPECT_TRUE(style->Make(image));
  InkIsoSurface* surface = style->GetIsoSurface();
  vtkNew<vtkPolyData> mesh;
  EXPECT_EQ(surface->Prepare(style, std::array{ image }), "");
  EXPECT_EQ(surface->Mesh(style, image, mesh), "");
  return { AngleOf(style->GetPiece(0)), AngleOf(mesh), surface->GetSampler()->GetSmoothing() };
}

TEST(ThickSlices, HaveNoTerraces)
{
  const auto skin = MakeSlices(6.0, Skin);
  const Angles shapes = Draw(skin, "100", "on");
  EXPECT_LT(shapes.Points, 4.0);
  EXPECT_LT(shapes.Mesh, 4.0);
  EXPECT_TRUE(Draw(skin, "100", "auto") == shapes);
  const Angles values = Draw(skin, "100", "off");
  EXPECT_GT(values.Points, 2.0 * shapes.Points);
  EXPECT_GT(values.Mesh, 2.0 * shapes.Mesh);
  // Two surfaces, each with distances of its own; hidden voxels far away.
  const Angles both = Draw(MakeSlices(6.0, Skin, true), "100,500", "auto");
  EXPECT_LT(both.Points, 4.0);
  EXPECT_LT(both.Mesh, 4.0);
}

TEST(ThickSlices, OfLabelsAreSmoothedLess)
{
  const auto labels = MakeSlices(4.0, Label);
  const Angles shapes = Draw(labels, "0.5", "auto");
  const Angles values = Draw(labels, "0.5", "off");
  EXPECT_EQ(shapes.Smoothing, 2.0);
  EXPECT_EQ(values.Smoothing, 4.0);
  EXPECT_LT(shapes.Points, 5.0);
  EXPECT_LT(shapes.Mesh, 5.0);
}

TEST(ThickSlices, OthersStayAsTheyAre)
{
  for (const double distance : { 1.0, 1.7 })
  {
    const auto thin = MakeSlices(distance, Skin);
    const Angles off = Draw(thin, "100", "off");
    EXPECT_TRUE(Draw(thin, "100", "auto") == off);
    EXPECT_TRUE(Draw(thin, "100", "on") == off);
  }
  // At the middle of the step, values are as good.
  const auto skin = MakeSlices(3.0, Skin);
  EXPECT_TRUE(Draw(skin, "500", "auto") == Draw(skin, "500", "off"));
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  EXPECT_FALSE(sampler->GetShapeBasedInterpolation());
  sampler->SetInputData(skin);
  EXPECT_FALSE(sampler->SuggestShapeBasedInterpolation(500.0));
  EXPECT_TRUE(sampler->SuggestShapeBasedInterpolation(20.0));
}

} // namespace
