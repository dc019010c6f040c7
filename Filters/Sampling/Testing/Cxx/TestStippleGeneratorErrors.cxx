// SPDX-License-Identifier: BSD-3-Clause
// What cannot be stippled: one message that names what was found, and an empty output. What has nothing to
// stipple: an empty output. What asks to stop: an empty output, too.

#include "InkTestMesh.h"
#include "InkTestMessages.h"
#include "SamplerTestImages.h"

#include "vtkCallbackCommand.h"
#include "vtkInkStippleGenerator.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace
{

using Change = std::function<void(vtkInkStippleGenerator*)>;

/// Stipples the data; expects the words in one message, or no message for none.
void Expect(
  const std::string& name, const std::vector<std::string>& words, vtkDataObject* data,
  const Change& change = [](vtkInkStippleGenerator*) {})
{
  vtkNew<vtkInkStippleGenerator> generator;
  vtkNew<InkTestMessages> messages;
  messages->Observe(generator);
  change(generator);
  generator->SetInputDataObject(data);
  generator->Update();
  EXPECT_TRUE(
    generator->GetOutput()->GetNumberOfPoints() == 0 && generator->GetOutput()->GetNumberOfCells() == 0)
    << name << ": no stipples";
  messages->Expect(name, words);
}

vtkSmartPointer<vtkImageData> Ball()
{
  return MakeImage(VTK_FLOAT, { -9, 9, -9, 9, -9, 9 },
    [](double x, double y, double z) { return BallDensity(x, y, z, 6.0); });
}

void ExpectOfImage(
  const std::string& name, const std::vector<std::string>& words,
  const std::function<void(vtkImageData*)>& alter, const Change& change = [](vtkInkStippleGenerator*) {})
{
  const auto image = Ball();
  alter(image);
  Expect(name, words, image, change);
}

} // namespace

TEST(StippleGeneratorErrors, ArraysThatCannotBeUsed)
{
  const auto as = [](vtkImageData*) {};
  ExpectOfImage("no image", {}, [](vtkImageData* image) { image->Initialize(); });
  ExpectOfImage("no scalars", { "No point scalars", "none" },
    [](vtkImageData* image) { image->GetPointData()->Initialize(); });
  ExpectOfImage("no such array", { "\"Pressure\"", "\"Density\"" }, as,
    [](vtkInkStippleGenerator* g)
    { g->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Pressure"); });
  ExpectOfImage("no such component", { "Density", "Component 1" }, as,
    [](vtkInkStippleGenerator* g) { g->SetArrayComponent(1); });
  ExpectOfImage("no such colors", { "\"Pressure\"", "to pass on" }, as,
    [](vtkInkStippleGenerator* g)
    {
      g->PassScalarsOn();
      g->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Pressure");
    });
}

TEST(StippleGeneratorErrors, ImagesWithoutGradients)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto as = [](vtkImageData*) {};
  ExpectOfImage("no spacing", { "spacing" }, [](vtkImageData* image) { image->SetSpacing(1.0, 0.0, 1.0); });
  ExpectOfImage("flat direction matrix", { "direction matrix" },
    [](vtkImageData* image) { image->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 1, 1, 0); });
  ExpectOfImage("constant", { "No voxel has a gradient", "7 to 7" },
    [](vtkImageData* image) { image->GetPointData()->GetScalars()->Fill(7.0); });
  ExpectOfImage("nothing but NaN", { "None of the values is finite" },
    [nan](vtkImageData* image) { image->GetPointData()->GetScalars()->Fill(nan); });
  ExpectOfImage("one voxel", { "No voxel has a gradient" },
    [](vtkImageData* image)
    {
      image->SetExtent(0, 0, 0, 0, 0, 0);
      image->AllocateScalars(VTK_FLOAT, 1);
      image->GetPointData()->GetScalars()->Fill(1.0);
    });
  ExpectOfImage("window out of range", { "between 1e+06 and 1e+07", "range from" }, as,
    [](vtkInkStippleGenerator* g)
    {
      g->UseScalarWindowOn();
      g->SetScalarWindow(1e6, 1e7);
    });
}

TEST(StippleGeneratorErrors, NoneWhenStopped)
{
  const auto as = [](vtkImageData*) {};
  ExpectOfImage("stopped", {}, as,
    [](vtkInkStippleGenerator* g)
    {
      vtkNew<vtkCallbackCommand> stop;
      stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
        { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
      g->AddObserver(vtkCommand::ProgressEvent, stop);
    });
}

TEST(StippleGeneratorErrors, DataWithoutPolygons)
{
  vtkNew<vtkPolyData> points;
  vtkNew<vtkPoints> some;
  some->InsertNextPoint(0.0, 0.0, 0.0);
  some->InsertNextPoint(1.0, 0.0, 0.0);
  points->SetPoints(some);
  Expect("no polygons", { "2 points", "polygon" }, points);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(some);
  Expect("a grid", { "vtkUnstructuredGrid", "vtkResampleToImage", "vtkDataSetSurfaceFilter" }, grid);
  vtkNew<vtkPolyData> nothing;
  Expect("no points", {}, nothing);
}

TEST(StippleGeneratorErrors, MeshesThatCannotBeStippled)
{
  vtkNew<vtkPlaneSource> flat;
  flat->Update();
  vtkNew<vtkPolyData> line;
  line->DeepCopy(flat->GetOutput());
  for (vtkIdType n = 0; n < line->GetNumberOfPoints(); ++n)
  {
    line->GetPoints()->SetPoint(n, static_cast<double>(n), 0.0, 0.0);
  }
  Expect("no area", { "no area" }, line);
  Expect("nothing finite", { InkTestNotFiniteFaces }, InkTestNotFiniteMesh());
  vtkNew<vtkInkStippleGenerator> generator;
  vtkNew<InkTestMessages> messages;
  messages->Observe(generator);
  generator->SetInputData(InkTestOddMesh(1.0));
  generator->Update();
  messages->Expect("a face that is not finite", { InkTestOddFaces });
  EXPECT_GT(generator->GetOutput()->GetNumberOfPoints(), 0);
  Expect("too many", { "GiB", "expected no more" }, flat->GetOutput(),
    [](vtkInkStippleGenerator* g) { g->SetNumberOfSurfaceStipples(1000000000000); });
  Expect("no colors", { "active scalars" }, flat->GetOutput(),
    [](vtkInkStippleGenerator* g) { g->PassScalarsOn(); });
}
