// SPDX-License-Identifier: BSD-3-Clause
// What cannot be sampled: one message that names what was found, and an empty output.

#include "InkTestMessages.h"
#include "SamplerTestImages.h"

#include "vtkCellData.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace
{

/// Samples a ball after `change`; expects the words in one message, or no message for none.
void Expect(const std::string& name, const std::vector<std::string>& words,
  const std::function<void(vtkInkIsoSurfaceSampler*, vtkImageData*)>& change)
{
  auto image = MakeImage(VTK_FLOAT, { -9, 9, -9, 9, -9, 9 },
    [](double x, double y, double z) { return BallDensity(x, y, z, 6.0); });
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  vtkNew<InkTestMessages> messages;
  messages->Observe(sampler);
  sampler->SetValue(0, 100.0);
  change(sampler, image);
  sampler->SetInputData(image);
  sampler->Update();
  EXPECT_EQ(sampler->GetOutput()->GetNumberOfPoints(), 0) << name << ": no points";
  messages->Expect(name, words);
}

} // namespace

TEST(IsoSurfaceSamplerErrors, ArraysThatCannotBeUsed)
{
  Expect("no image", {}, [](vtkInkIsoSurfaceSampler*, vtkImageData* image) { image->Initialize(); });
  Expect("no scalars", { "No point scalars", "none" },
    [](vtkInkIsoSurfaceSampler*, vtkImageData* image) { image->GetPointData()->Initialize(); });
  Expect("no such array", { "\"Pressure\"", "\"Density\"" },
    [](vtkInkIsoSurfaceSampler* sampler, vtkImageData*)
    { sampler->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Pressure"); });
  Expect("short cell data", { "OfCells", "10 values", "5832" },
    [](vtkInkIsoSurfaceSampler* sampler, vtkImageData* image)
    {
      vtkNew<vtkFloatArray> cells;
      cells->SetName("OfCells");
      cells->SetNumberOfTuples(10);
      cells->Fill(1.0);
      image->GetCellData()->AddArray(cells);
      sampler->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "OfCells");
    });
  Expect("words", { "Words" },
    [](vtkInkIsoSurfaceSampler* sampler, vtkImageData* image)
    {
      vtkNew<vtkStringArray> words;
      words->SetName("Words");
      words->SetNumberOfValues(image->GetNumberOfPoints());
      image->GetPointData()->AddArray(words);
      sampler->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Words");
    });
  Expect("short array", { "Density", "10 values", "6859" },
    [](vtkInkIsoSurfaceSampler*, vtkImageData* image)
    { image->GetPointData()->GetScalars()->SetNumberOfTuples(10); });
  Expect("no such component", { "Density", "Component 1", "1 components" },
    [](vtkInkIsoSurfaceSampler* sampler, vtkImageData*) { sampler->SetArrayComponent(1); });
}

TEST(IsoSurfaceSamplerErrors, GeometryWithoutCells)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Expect("one slice", { "19 x 19 x 1", "at least 2" },
    [](vtkInkIsoSurfaceSampler*, vtkImageData* image)
    {
      image->SetExtent(-9, 9, -9, 9, 0, 0);
      image->AllocateScalars(VTK_FLOAT, 1);
    });
  Expect("one voxel", { "1 x 1 x 1" },
    [](vtkInkIsoSurfaceSampler*, vtkImageData* image)
    {
      image->SetExtent(0, 0, 0, 0, 0, 0);
      image->AllocateScalars(VTK_FLOAT, 1);
    });
  Expect("no spacing", { "spacing" },
    [](vtkInkIsoSurfaceSampler*, vtkImageData* image) { image->SetSpacing(1.0, 0.0, 1.0); });
  Expect("NaN in the spacing", { "spacing" },
    [nan](vtkInkIsoSurfaceSampler*, vtkImageData* image) { image->SetSpacing(1.0, nan, 1.0); });
  Expect("flat direction matrix", { "direction matrix" },
    [](vtkInkIsoSurfaceSampler*, vtkImageData* image)
    { image->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 1, 1, 0); });
}

TEST(IsoSurfaceSamplerErrors, IsoValuesWithoutSurface)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Expect("NaN as iso-value", { "NaN" },
    [nan](vtkInkIsoSurfaceSampler* sampler, vtkImageData*) { sampler->SetValue(0, nan); });
  Expect("iso-value out of range", { "1e+09", "Expected a value above" },
    [](vtkInkIsoSurfaceSampler* sampler, vtkImageData*) { sampler->SetValue(0, 1e9); });
  Expect("no iso-value", { "No iso-value is set" },
    [](vtkInkIsoSurfaceSampler* sampler, vtkImageData*) { sampler->SetNumberOfContours(0); });
  Expect("nothing finite", { "None of the image's values is finite" },
    [nan](vtkInkIsoSurfaceSampler*, vtkImageData* image) { image->GetPointData()->GetScalars()->Fill(nan); });
}

/// It is refused, and the filters that make voxels are named.
TEST(IsoSurfaceSamplerErrors, DataWithoutVoxels)
{
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(3, 3, 3);
  vtkNew<vtkUnstructuredGrid> cells;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  cells->SetPoints(points);
  for (vtkDataSet* data : { static_cast<vtkDataSet*>(grid), static_cast<vtkDataSet*>(cells) })
  {
    vtkNew<vtkInkIsoSurfaceSampler> sampler;
    vtkNew<InkTestMessages> messages;
    messages->Observe(sampler);
    messages->Observe(sampler->GetExecutive());
    sampler->SetValue(0, 1.0);
    sampler->SetInputDataObject(data);
    sampler->Update();
    EXPECT_EQ(sampler->GetOutput()->GetNumberOfPoints(), 0) << data->GetClassName() << ": no points";
    messages->Expect(data->GetClassName(),
      { data->GetClassName(), "expected a vtkImageData", "vtkResampleToImage", "vtkInkSurfaceSampler" });
  }
}
