// SPDX-License-Identifier: BSD-3-Clause
// What has no gradient: one message that names what was found, and an empty output.

#include "GradientTestImages.h"
#include "InkTestMessages.h"

#include "vtkCellData.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkInkGradient.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace
{

/// Runs on an image after `change`; expects the words in one message, or no message for none.
void Expect(const std::string& name, const std::vector<std::string>& words,
  const std::function<void(vtkInkGradient*, vtkImageData*)>& change)
{
  auto image =
    MakeImage(VTK_FLOAT, { 0, 8, 0, 7, 0, 6 }, [](double x, double y, double z) { return x + y - z; });
  vtkNew<vtkInkGradient> filter;
  vtkNew<InkTestMessages> messages;
  messages->Observe(filter);
  messages->Observe(filter->GetExecutive());
  filter->SetComputeLaplacian(true);
  change(filter, image);
  filter->SetInputData(image);
  filter->Update();
  EXPECT_TRUE(filter->GetOutput()->GetNumberOfPoints() == 0 &&
    filter->GetOutput()->GetPointData()->GetNumberOfArrays() == 0)
    << name << ": an empty output";
  messages->Expect(name, words);
}

} // namespace

TEST(GradientErrors, NoImageIsNoError)
{
  Expect("no image", {}, [](vtkInkGradient*, vtkImageData* image) { image->Initialize(); });
}

TEST(GradientErrors, ArraysThatCannotBeUsed)
{
  Expect("no scalars", { "No point scalars", "none" },
    [](vtkInkGradient*, vtkImageData* image) { image->GetPointData()->Initialize(); });
  Expect("no such array", { "\"Pressure\"", "\"Density\"" },
    [](vtkInkGradient* filter, vtkImageData*)
    { filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Pressure"); });
  Expect("cell data", { "OfCells", "336", "504" },
    [](vtkInkGradient* filter, vtkImageData* image)
    {
      vtkNew<vtkFloatArray> cells;
      cells->SetName("OfCells");
      cells->SetNumberOfTuples(image->GetNumberOfCells());
      cells->Fill(1.0);
      image->GetCellData()->AddArray(cells);
      filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "OfCells");
    });
  Expect("words", { "Words" },
    [](vtkInkGradient* filter, vtkImageData* image)
    {
      vtkNew<vtkStringArray> words;
      words->SetName("Words");
      words->SetNumberOfValues(image->GetNumberOfPoints());
      image->GetPointData()->AddArray(words);
      filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Words");
    });
  Expect("short array", { "Density", "10 values", "504" },
    [](vtkInkGradient*, vtkImageData* image) { image->GetPointData()->GetScalars()->SetNumberOfTuples(10); });
  Expect("no such component", { "Density", "Component 1", "1 components" },
    [](vtkInkGradient* filter, vtkImageData*) { filter->SetArrayComponent(1); });
}

TEST(GradientErrors, GeometryThatIsSingular)
{
  Expect("no spacing", { "spacing" },
    [](vtkInkGradient*, vtkImageData* image) { image->SetSpacing(1.0, 0.0, 1.0); });
  Expect("NaN in the spacing", { "spacing" },
    [](vtkInkGradient*, vtkImageData* image)
    { image->SetSpacing(1.0, std::numeric_limits<double>::quiet_NaN(), 1.0); });
  Expect("flat direction matrix", { "direction matrix" },
    [](vtkInkGradient*, vtkImageData* image) { image->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 1, 1, 0); });
}
