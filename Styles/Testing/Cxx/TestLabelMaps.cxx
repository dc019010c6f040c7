// SPDX-License-Identifier: BSD-3-Clause
// Label maps and masks: drawn alike, whatever the ids are, with smooth normals.
#include "StyleData.h"

#include "InkIsoSurface.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkSplattingLinesStyle.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <string>
#include <vector>

namespace
{

constexpr int Side = 40;
constexpr double Middle = 19.3;
constexpr double BallRadius = 15.0;

/// A ball whose octants have ids.
vtkSmartPointer<vtkImageData> MakeLabels(const std::array<int, 8>& ids)
{
  auto image = MakeBall(Side);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    const std::size_t octant = (p[0] > Middle) + 2 * (p[1] > Middle) + 4 * (p[2] > Middle);
    const bool inside = std::hypot(p[0] - Middle, p[1] - Middle, p[2] - Middle) < BallRadius;
    values->SetComponent(i, 0, inside ? ids[octant] : 0);
  }
  return image;
}

const std::array<int, 8> Ids = { 1, 90, 7, 45, 2, 60, 33, 18 };
const std::array<int, 8> Ones = { 1, 1, 1, 1, 1, 1, 1, 1 };
const std::array<int, 8> Brights = { 255, 255, 255, 255, 255, 255, 255, 255 };

/// Points and normals.
std::vector<double> NumbersOf(vtkPolyData* surface)
{
  std::vector<double> numbers;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    const double* n = surface->GetPointData()->GetNormals()->GetTuple(i);
    numbers.insert(numbers.end(), { p[0], p[1], p[2], n[0], n[1], n[2] });
  }
  return numbers;
}

double AngleOf(const std::vector<double>& numbers)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < numbers.size(); i += 6)
  {
    const double d[3] = { numbers[i] - Middle, numbers[i + 1] - Middle, numbers[i + 2] - Middle };
    const double cosine =
      (d[0] * numbers[i + 3] + d[1] * numbers[i + 4] + d[2] * numbers[i + 5]) / std::hypot(d[0], d[1], d[2]);
    sum += std::pow(std::acos(std::clamp(cosine, -1.0, 1.0)), 2);
  }
  return std::sqrt(6.0 * sum / static_cast<double>(numbers.size())) * 180.0 / std::acos(-1.0);
}

/// The deviation of points' distances from the middle, voxels.
double StepOf(const std::vector<double>& numbers)
{
  double sum = 0.0;
  double squares = 0.0;
  const double count = static_cast<double>(numbers.size()) / 6.0;
  for (std::size_t i = 0; i < numbers.size(); i += 6)
  {
    const double distance = std::hypot(numbers[i] - Middle, numbers[i + 1] - Middle, numbers[i + 2] - Middle);
    sum += distance / count;
    squares += distance * distance / count;
  }
  return std::sqrt(std::max(squares - sum * sum, 0.0));
}

struct Drawn
{
  std::vector<double> Points;
  std::vector<double> Mesh;
};

Drawn Draw(vtkImageData* image, const std::vector<double>& isoValues = {}, int labelMap = 0,
  const char* target = "auto")
{
  vtkNew<vtkInkSplattingLinesStyle> style;
  EXPECT_TRUE(style->SetParameterAsString("SmoothingTarget", target));
  style->SetParameterAsString("LabelMap", labelMap == InkIsoSurface::LABELS_OFF ? "off" : "auto");
  style->SetParameterAsString("LabelBorders", "off");
  style->SetParameter("Subdivision", 1);
  std::string values;
  for (const double value : isoValues)
  {
    values += (values.empty() ? "" : ",") + std::to_string(value);
  }
  style->SetParameterAsString("IsoValues", values.c_str());
  EXPECT_TRUE(style->Make(image));
  InkIsoSurface surface;
  surface.CopyParameters(*style->GetIsoSurface());
  surface.SetIsoValues(isoValues);
  vtkNew<vtkPolyData> mesh;
  EXPECT_EQ(surface.Prepare(style, std::array{ image }), "");
  EXPECT_EQ(surface.Mesh(style, image, mesh), "");
  return { NumbersOf(style->GetPiece(0)), NumbersOf(mesh) };
}

TEST(LabelMaps, AreDrawnAsMasks)
{
  const Drawn mask = Draw(MakeLabels(Ones));
  EXPECT_LT(AngleOf(mask.Points), 2.0);
  EXPECT_LT(AngleOf(mask.Mesh), 2.0);
  const auto labels = MakeLabels(Ids);
  const auto bright = MakeLabels(Brights);
  for (const Drawn& same : { Draw(labels), Draw(labels, { 0.5 }), Draw(bright), Draw(bright, { 1.0 }) })
  {
    EXPECT_TRUE(same.Points == mask.Points);
    EXPECT_TRUE(same.Mesh == mask.Mesh);
  }
  const Drawn off = Draw(labels, {}, InkIsoSurface::LABELS_OFF);
  EXPECT_GT(AngleOf(off.Points), 5.0);
  EXPECT_GT(AngleOf(off.Mesh), 5.0);
}

TEST(LabelMaps, BordersAreGroovesUnlessTheyAreNoise)
{
  // The mean angle between normals and those of the ball.
  const auto angleOf = [](vtkImageData* image, const char* borders)
  {
    vtkNew<vtkInkSplattingLinesStyle> style;
    style->SetParameter("Subdivision", 1);
    EXPECT_TRUE(style->SetParameterAsString("LabelBorders", borders));
    EXPECT_TRUE(style->Make(image));
    return AngleOf(NumbersOf(style->GetPiece(0)));
  };
  const auto labels = MakeLabels(Ids);
  EXPECT_GT(angleOf(labels, "auto"), 8.0);
  EXPECT_EQ(angleOf(labels, "on"), angleOf(labels, "auto"));
  EXPECT_LT(angleOf(labels, "off"), 2.0);
  EXPECT_LT(angleOf(MakeLabels(Ones), "on"), 2.0);
  // Noise has labels beside each other everywhere.
  vtkDataArray* values = labels->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < labels->GetNumberOfPoints(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    values->SetComponent(i, 0, value > 0.0 ? 1.0 + static_cast<double>(i * i % 7) : 0.0);
  }
  values->Modified();
  EXPECT_LT(angleOf(labels, "auto"), 2.0);
  EXPECT_GT(angleOf(labels, "on"), 2.0);
}

TEST(LabelMaps, OutlinesHaveNoSteps)
{
  const auto labels = MakeLabels(Ids);
  const Drawn automatic = Draw(labels);
  EXPECT_LT(StepOf(automatic.Points), 0.1);
  EXPECT_LT(StepOf(automatic.Mesh), 0.1);
  const Drawn normals = Draw(labels, {}, 0, "normals");
  EXPECT_GT(StepOf(normals.Points), 2.0 * StepOf(automatic.Points));
  EXPECT_TRUE(Draw(labels, {}, 0, "surface").Points == automatic.Points);
}

TEST(LabelMaps, ThinPartsAndScansKeepTheirSurface)
{
  vtkNew<vtkInkSplattingLinesStyle> style;
  InkIsoSurface surface;
  const auto targetOf = [&](vtkImageData* image, double isoValue)
  {
    surface.SetIsoValues({ isoValue });
    EXPECT_EQ(surface.Prepare(style, std::array{ image }), "");
    return surface.GetSampler()->GetSmoothingTarget();
  };
  const auto labels = MakeLabels(Ones);
  EXPECT_EQ(targetOf(labels, 0.5), vtkInkIsoSurfaceSampler::SURFACE);
  EXPECT_EQ(targetOf(MakeBall(Side), 100.0), vtkInkIsoSurfaceSampler::NORMALS);
  // In slices that lie far apart, a Gaussian as wide as their distance would take a sheet away.
  labels->SetSpacing(1.0, 1.0, 3.0);
  vtkDataArray* values = labels->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < labels->GetNumberOfPoints(); ++i)
  {
    const int x = static_cast<int>(i) % Side;
    values->SetComponent(i, 0, x == 20 || x == 21 ? 1 : 0);
  }
  values->Modified();
  EXPECT_EQ(targetOf(labels, 0.5), vtkInkIsoSurfaceSampler::NORMALS);
}

TEST(LabelMaps, MeshesHaveTheMasksOfAllIsoValues)
{
  const auto labels = MakeLabels(Ids);
  const Drawn low = Draw(labels, { 0.5 });
  const Drawn high = Draw(labels, { 40.5 });
  ASSERT_FALSE(high.Mesh.empty());
  std::vector<double> both = low.Mesh;
  both.insert(both.end(), high.Mesh.begin(), high.Mesh.end());
  EXPECT_TRUE(Draw(labels, { 0.5, 40.5 }).Mesh == both);
}

TEST(LabelMaps, ScansAreNone)
{
  const auto ball = MakeBall(Side);
  const Drawn automatic = Draw(ball, { 100.0 });
  const Drawn off = Draw(ball, { 100.0 }, InkIsoSurface::LABELS_OFF);
  EXPECT_TRUE(automatic.Points == off.Points);
  EXPECT_TRUE(automatic.Mesh == off.Mesh);
}

TEST(LabelMaps, CutsAreClosed)
{
  // Half a ball, cut by the side at x = 0.
  const auto half = [](double blur)
  {
    auto image = MakeBall(Side);
    vtkDataArray* values = image->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      double p[3];
      image->GetPoint(i, p);
      const double depth = BallRadius - std::hypot(p[0], p[1] - Middle, p[2] - Middle);
      values->SetComponent(i, 0, 200.0 * std::clamp(0.5 + depth / blur, 0.0, 1.0));
    }
    return image;
  };
  /// How many points the side has, of the points and of the mesh.
  const auto countCaps = [](vtkImageData* image, const char* cut)
  {
    vtkNew<vtkInkSplattingLinesStyle> style;
    EXPECT_TRUE(style->SetParameterAsString("Cut", cut));
    EXPECT_TRUE(style->Make(image));
    InkIsoSurface& surface = *style->GetIsoSurface();
    vtkNew<vtkPolyData> mesh;
    EXPECT_EQ(surface.Mesh(style, image, mesh), "");
    std::array<int, 2> caps{};
    for (int n = 0; n < 2; ++n)
    {
      const std::vector<double> numbers = NumbersOf(n == 0 ? style->GetPiece(0) : mesh.Get());
      for (std::size_t i = 0; i < numbers.size(); i += 6)
      {
        // Not of the line along the cut.
        const bool isWithin = std::hypot(numbers[i + 1] - Middle, numbers[i + 2] - Middle) < BallRadius - 3.0;
        caps[n] += isWithin && numbers[i] < 0.1 && numbers[i + 3] < -0.99 ? 1 : 0;
      }
    }
    return caps;
  };
  const std::array<int, 2> none{};
  const auto labels = half(1e-6);
  const std::array<int, 2> caps = countCaps(labels, "auto");
  EXPECT_GT(caps[0], 200);
  EXPECT_GT(caps[1], 200);
  EXPECT_EQ(countCaps(labels, "cap"), caps);
  EXPECT_EQ(countCaps(labels, "rim"), none);
  const auto scan = half(4.0);
  EXPECT_EQ(countCaps(scan, "auto"), none);
  EXPECT_GT(countCaps(scan, "cap")[0], 200);
  // Slices a third as far apart make a slab of it.
  const auto slab = half(4.0);
  slab->SetSpacing(1.0 / 3.0, 1.0, 1.0);
  const std::array<int, 2> ends = countCaps(slab, "auto");
  EXPECT_GT(ends[0], 200);
  EXPECT_GT(ends[1], 200);
  EXPECT_EQ(countCaps(slab, "rim"), none);
}

TEST(LabelMaps, WhatSurroundsAnObjectIsNotClosed)
{
  const auto cutOf = [](vtkImageData* image, std::initializer_list<double> values)
  {
    vtkNew<vtkInkSplattingLinesStyle> style;
    InkIsoSurface surface;
    surface.SetIsoValues(values);
    EXPECT_EQ(surface.Prepare(style, std::array{ image }), "");
    const int cut = surface.GetSampler()->GetCut();
    // The same of slices that are read a few at a time.
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(image);
    vtkNew<vtkInkIsoSurfaceSampler> inParts;
    inParts->SetInputConnection(producer->GetOutputPort());
    vtkNew<vtkPolyData> points;
    EXPECT_EQ(surface.SampleBy(style, inParts, points), "");
    EXPECT_EQ(inParts->GetCut(), cut);
    return cut;
  };
  auto object = MakeLabels(Ones);
  EXPECT_EQ(cutOf(object, {}), vtkInkIsoSurfaceAlgorithm::CAP);
  vtkDataArray* values = object->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetComponent(i, 0, values->GetComponent(i, 0) > 0.0 ? 0.0 : 1.0);
  }
  EXPECT_EQ(cutOf(object, {}), vtkInkIsoSurfaceAlgorithm::RIM);
  EXPECT_EQ(cutOf(object, { 0.7, 0.5 }), vtkInkIsoSurfaceAlgorithm::RIM);
  // Distances that are negative inside, in a slab.
  auto distances = MakeBall(Side);
  distances->SetSpacing(1.0 / 3.0, 1.0, 1.0);
  EXPECT_EQ(cutOf(distances, { 100.0 }), vtkInkIsoSurfaceAlgorithm::CAP);
  values = distances->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetComponent(i, 0, 200.0 - values->GetComponent(i, 0));
  }
  EXPECT_EQ(cutOf(distances, { 100.0 }), vtkInkIsoSurfaceAlgorithm::RIM);
}

TEST(LabelMaps, GivenSmoothingStays)
{
  vtkNew<vtkInkSplattingLinesStyle> style;
  InkIsoSurface surface;
  const auto labels = MakeLabels(Ids);
  surface.SetSmoothing(0.7);
  EXPECT_EQ(surface.Prepare(style, std::array{ labels.Get() }), "");
  EXPECT_TRUE(surface.GetSampler()->GetLabelMap());
  EXPECT_EQ(surface.GetSampler()->GetSmoothing(), 0.7);
  surface.SetSmoothing(-1.0);
  EXPECT_EQ(surface.Prepare(style, std::array{ labels.Get() }), "");
  EXPECT_EQ(surface.GetSampler()->GetSmoothing(), 2.0);
  // Of what seems to be none, when asked for.
  surface.SetLabelMap(InkIsoSurface::LABELS_ON);
  surface.SetIsoValues({ 100.0 });
  EXPECT_EQ(surface.Prepare(style, std::array{ MakeBall(Side).Get() }), "");
  EXPECT_TRUE(surface.GetSampler()->GetLabelMap());
}

} // namespace
