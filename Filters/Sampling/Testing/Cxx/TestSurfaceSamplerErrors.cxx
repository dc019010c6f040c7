// SPDX-License-Identifier: BSD-3-Clause
// What cannot be sampled: one message that names what was found, and an empty output. What can be, though it
// is not as it should be: no message, and points.

#include "InkTestMessages.h"
#include "SamplerTestMeshes.h"

#include "vtkCallbackCommand.h"
#include "vtkFloatArray.h"
#include "vtkInkSurfaceSampler.h"

#include <gtest/gtest.h>

namespace
{

using Change = std::function<void(vtkInkSurfaceSampler*, vtkPolyData*)>;

void Expect(
  const std::string& name, const std::vector<std::string>& words, vtkIdType count, const Change& change)
{
  const auto mesh = MakeSquare(4);
  vtkNew<vtkInkSurfaceSampler> sampler;
  vtkNew<InkTestMessages> messages;
  messages->Observe(sampler);
  sampler->SetNumberOfSamples(200);
  change(sampler, mesh);
  sampler->SetInputData(mesh);
  sampler->Update();
  vtkPolyData* output = sampler->GetOutput();
  EXPECT_EQ(output->GetNumberOfPoints(), count) << name << ": " << count << " points";
  EXPECT_TRUE(IsFinite(output)) << name << ": finite numbers";
  messages->Expect(name, words);
}

vtkSmartPointer<vtkFloatArray> MakeArray(vtkIdType tuples, int components, double value)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName("Density");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  array->Fill(value);
  return array;
}

void AskForDensity(vtkInkSurfaceSampler* sampler)
{
  sampler->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Density");
}

} // namespace

TEST(SurfaceSamplerErrors, AmountsThatCannotBeSampled)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Expect("nothing", {}, 0, [](vtkInkSurfaceSampler*, vtkPolyData* mesh) { mesh->Initialize(); });
  for (const double radius : { 0.0, -1.0, nan })
  {
    Expect("no radius", { "SampleRadius", "above 0" }, 0,
      [=](vtkInkSurfaceSampler* sampler, vtkPolyData*)
      {
        sampler->SetAmountToSampleRadius();
        sampler->SetSampleRadius(radius);
      });
  }
  for (const int method : { 0, 1 })
  {
    Expect("too many", { "1e+12 samples", "GiB" }, 0,
      [=](vtkInkSurfaceSampler* sampler, vtkPolyData*)
      {
        sampler->SetMethod(method);
        sampler->SetNumberOfSamples(1'000'000'000'000);
      });
    Expect("too small a radius", { "GiB" }, 0,
      [=](vtkInkSurfaceSampler* sampler, vtkPolyData*)
      {
        sampler->SetMethod(method);
        sampler->SetAmountToSampleRadius();
        sampler->SetSampleRadius(1e-9);
      });
  }
}

TEST(SurfaceSamplerErrors, MeshesWithoutArea)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Expect("no area", { "32 triangles", "no area" }, 0,
    [](vtkInkSurfaceSampler*, vtkPolyData* mesh)
    {
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        mesh->GetPoints()->SetPoint(i, 1.0 * i, 2.0 * i, 0.0);
      }
    });
  Expect("NaN", { "all of its 32 faces have points that are not finite; expected finite" }, 0,
    [=](vtkInkSurfaceSampler*, vtkPolyData* mesh)
    {
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        mesh->GetPoints()->SetPoint(i, nan, 0.0, 0.0);
      }
    });
  Expect("a point that is not there", { "point 99", "0 to 24" }, 0,
    [](vtkInkSurfaceSampler*, vtkPolyData* mesh) {
      mesh->GetPolys()->InsertNextCell({ 0, 1, 99 });
    });
}

TEST(SurfaceSamplerErrors, DensitiesThatCannotBeUsed)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Expect("no such density", { "\"Density\"", "none" }, 0,
    [](vtkInkSurfaceSampler* sampler, vtkPolyData*) { AskForDensity(sampler); });
  Expect("vector density", { "Density", "3 components" }, 0,
    [](vtkInkSurfaceSampler* sampler, vtkPolyData* mesh)
    {
      mesh->GetPointData()->AddArray(MakeArray(25, 3, 1.0));
      AskForDensity(sampler);
    });
  Expect("short density", { "Density", "10 values", "25" }, 0,
    [](vtkInkSurfaceSampler* sampler, vtkPolyData* mesh)
    {
      mesh->GetPointData()->AddArray(MakeArray(10, 1, 1.0));
      AskForDensity(sampler);
    });
  for (const double density : { 0.0, -3.0, nan })
  {
    Expect("no density", { "density", "above 0" }, 0,
      [=](vtkInkSurfaceSampler* sampler, vtkPolyData* mesh)
      {
        mesh->GetPointData()->AddArray(MakeArray(25, 1, density));
        AskForDensity(sampler);
      });
  }
  for (const auto& [unusable, words] :
    { std::pair{ -3.0, "1 negative" }, std::pair{ nan, "1 that are NaN" } })
  {
    Expect("density that is not used", { "density \"Density\"", words, "25 values" }, 200,
      [value = unusable](vtkInkSurfaceSampler* sampler, vtkPolyData* mesh)
      {
        auto density = MakeArray(25, 1, 1.0);
        density->SetValue(7, static_cast<float>(value));
        mesh->GetPointData()->AddArray(density);
        AskForDensity(sampler);
      });
  }
}

TEST(SurfaceSamplerErrors, NoneForSomeBadCells)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Expect("some triangles of no area", {}, 200,
    [](vtkInkSurfaceSampler*, vtkPolyData* mesh)
    {
      mesh->GetPolys()->InsertNextCell({ 0, 0, 1 });
      mesh->GetPolys()->InsertNextCell({ 3, 3, 3 });
    });
  Expect("one NaN", { "6 of 32 faces have points that are not finite; expected finite coordinates" }, 200,
    [=](vtkInkSurfaceSampler*, vtkPolyData* mesh) { mesh->GetPoints()->SetPoint(7, nan, 0.0, 0.0); });
  Expect("the same triangle thrice", {}, 200,
    [](vtkInkSurfaceSampler*, vtkPolyData* mesh)
    {
      mesh->GetPolys()->InsertNextCell({ 0, 1, 6 });
      mesh->GetPolys()->InsertNextCell({ 1, 0, 6 });
    });
  Expect("normals of no length", {}, 200,
    [](vtkInkSurfaceSampler*, vtkPolyData* mesh)
    {
      auto normals = MakeArray(25, 3, 0.0);
      normals->SetName("Normals");
      mesh->GetPointData()->SetNormals(normals);
    });
}

TEST(SurfaceSamplerErrors, NoneWhenStopped)
{
  Expect("stopped", {}, 0,
    [](vtkInkSurfaceSampler* sampler, vtkPolyData*)
    {
      vtkNew<vtkCallbackCommand> stop;
      stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
        { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
      sampler->AddObserver(vtkCommand::ProgressEvent, stop);
      sampler->SetNumberOfSamples(20000);
    });
}
