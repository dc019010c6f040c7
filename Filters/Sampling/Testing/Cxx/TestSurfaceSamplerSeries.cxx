// SPDX-License-Identifier: BSD-3-Clause
// vtkInkSurfaceSampler behind a mesh that changes with time: sampled once, then moved.

#include "InkTestMessages.h"
#include "SamplerTestMeshes.h"

#include "vtkInkSurfaceSampler.h"

#include "vtkCallbackCommand.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// A square that is sheared and stretched along x more and more with the time, 0 to 9; from 7 on of more
/// faces.
class SquareSeries : public vtkPolyDataAlgorithm
{
public:
  static SquareSeries* New() { VTK_STANDARD_NEW_BODY(SquareSeries); }
  vtkTypeMacro(SquareSeries, vtkPolyDataAlgorithm);

  bool Empty = false;    ///< the first step
  bool Faceless = false; ///< the first step
  int Runs = 0;

  static void Place(double time, double u, double v, double p[3])
  {
    p[0] = u * (1.0 + 0.2 * time) + 0.1 * time * v;
    p[1] = v;
    p[2] = 0.05 * time * u;
  }

protected:
  SquareSeries() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    double steps[10];
    for (int i = 0; i < 10; ++i)
    {
      steps[i] = i;
    }
    const double range[2] = { 0.0, 9.0 };
    outputs->GetInformationObject(0)->Set(Pipeline::TIME_STEPS(), steps, 10);
    outputs->GetInformationObject(0)->Set(Pipeline::TIME_RANGE(), range, 2);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    ++this->Runs;
    vtkInformation* info = outputs->GetInformationObject(0);
    const double time =
      info->Has(Pipeline::UPDATE_TIME_STEP()) ? info->Get(Pipeline::UPDATE_TIME_STEP()) : 0.0;
    vtkPolyData* output = vtkPolyData::GetData(outputs);
    if (!this->Empty || time > 0.0)
    {
      output->ShallowCopy(MakePatch(
        time < 7.0 ? 8 : 10, 8, false, [time](double u, double v, double p[3]) { Place(time, u, v, p); },
        VTK_DOUBLE));
    }
    if (this->Faceless && time == 0.0)
    {
      output->SetPolys(nullptr);
    }
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    return 1;
  }
};

void Configure(vtkInkSurfaceSampler* sampler)
{
  sampler->SetNumberOfSamples(800);
  sampler->FollowDeformationOn();
}

vtkSmartPointer<vtkPolyData> At(vtkInkSurfaceSampler* sampler, double time)
{
  sampler->UpdateTimeStep(time);
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(sampler->GetOutput());
  return copy;
}

} // namespace

TEST(SurfaceSamplerSeries, SamplesMoveWithTheMesh)
{
  vtkNew<SquareSeries> series;
  vtkNew<vtkInkSurfaceSampler> sampler;
  Configure(sampler);
  sampler->SetInputConnection(series->GetOutputPort());
  const auto first = At(sampler, 0.0);
  EXPECT_TRUE(sampler->GetNumberOfSamplings() == 1 && series->Runs == 1) << "the first step at once";
  vtkSmartPointer<vtkPolyData> fifth;
  for (const double time : { 1.0, 2.5, 5.0 })
  {
    fifth = At(sampler, time);
    EXPECT_EQ(fifth->GetNumberOfPoints(), 800) << "all samples at " << time;
    for (vtkIdType i = 0; i < fifth->GetNumberOfPoints(); ++i)
    {
      double a[3];
      double b[3];
      double expected[3];
      first->GetPoint(i, a);
      fifth->GetPoint(i, b);
      SquareSeries::Place(time, a[0], a[1], expected);
      ASSERT_LT(std::hypot(b[0] - expected[0], b[1] - expected[1], b[2] - expected[2]), 1e-12)
        << "sample " << i << " at " << time;
    }
  }
  EXPECT_EQ(sampler->GetNumberOfSamplings(), 1) << "sampled once";
  EXPECT_TRUE(fifth->GetFieldData()->GetNumberOfArrays() == 0 && !fifth->GetPointData()->GetArray("FaceId"))
    << "no arrays that were not asked for";

  // Whichever step is asked for first.
  vtkNew<vtkInkSurfaceSampler> other;
  Configure(other);
  vtkNew<SquareSeries> again;
  other->SetInputConnection(again->GetOutputPort());
  EXPECT_TRUE(AreEqual(At(other, 5.0), fifth)) << "the same samples when step 5 comes first";
  EXPECT_TRUE(again->Runs == 2 && other->GetNumberOfSamplings() == 1) << "the first step was asked for";
  EXPECT_TRUE(AreEqual(At(other, 0.0), first)) << "and the first after it";

  // Other faces: sampled anew, once, and the old ones come back.
  const auto seventh = At(sampler, 7.0);
  EXPECT_TRUE(sampler->GetNumberOfSamplings() == 2 && seventh->GetNumberOfPoints() == 800) << "other faces";
  At(sampler, 8.0);
  EXPECT_TRUE(AreEqual(At(sampler, 5.0), fifth)) << "back to the first faces";
  EXPECT_TRUE(AreEqual(At(sampler, 7.0), seventh)) << "and to the others";
  EXPECT_EQ(sampler->GetNumberOfSamplings(), 2) << "each of the two sampled once";

  sampler->SetSeed(1);
  EXPECT_TRUE(!AreEqual(At(sampler, 5.0), fifth) && sampler->GetNumberOfSamplings() == 3)
    << "another seed: other samples";
  series->Modified();
  At(sampler, 5.0);
  EXPECT_EQ(sampler->GetNumberOfSamplings(), 4) << "another series: other samples";
  sampler->FollowDeformationOff();
  At(sampler, 4.0);
  At(sampler, 5.0);
  EXPECT_EQ(sampler->GetNumberOfSamplings(), 6) << "off: each step anew";
}

TEST(SurfaceSamplerSeries, TheFirstStepMayBeEmpty)
{
  vtkNew<SquareSeries> series;
  series->Empty = true;
  vtkNew<vtkInkSurfaceSampler> sampler;
  vtkNew<InkTestMessages> messages;
  messages->Observe(sampler);
  Configure(sampler);
  sampler->SetInputConnection(series->GetOutputPort());
  EXPECT_EQ(At(sampler, 3.0)->GetNumberOfPoints(), 800) << "samples after an empty first step";
  EXPECT_EQ(At(sampler, 0.0)->GetNumberOfPoints(), 0) << "none of it";
  EXPECT_EQ(At(sampler, 4.0)->GetNumberOfPoints(), 800) << "and again";
  EXPECT_EQ(sampler->GetNumberOfSamplings(), 1) << "sampled once";
  EXPECT_TRUE(messages->Messages.empty()) << "no message";
}

/// Points at first, then a mesh.
TEST(SurfaceSamplerSeries, TheFirstStepMayHaveNoFaces)
{
  vtkNew<SquareSeries> series;
  series->Faceless = true;
  vtkNew<vtkInkSurfaceSampler> sampler;
  Configure(sampler);
  sampler->SetInputConnection(series->GetOutputPort());
  EXPECT_EQ(At(sampler, 0.0)->GetNumberOfPoints(), 81) << "the points themselves";
  EXPECT_EQ(At(sampler, 3.0)->GetNumberOfPoints(), 800) << "samples";
  EXPECT_EQ(At(sampler, 0.0)->GetNumberOfPoints(), 81) << "the points again";
  EXPECT_TRUE(At(sampler, 4.0)->GetNumberOfPoints() == 800 && sampler->GetNumberOfSamplings() == 1)
    << "the same samples";
}

TEST(SurfaceSamplerSeries, CanBeAborted)
{
  vtkNew<SquareSeries> series;
  vtkNew<vtkInkSurfaceSampler> sampler;
  Configure(sampler);
  sampler->SetInputConnection(series->GetOutputPort());
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const unsigned long tag = sampler->AddObserver(vtkCommand::ProgressEvent, abort);
  At(sampler, 3.0);
  sampler->RemoveObserver(tag);
  sampler->SetAbortExecute(0);
  EXPECT_EQ(At(sampler, 4.0)->GetNumberOfPoints(), 800) << "samples after an abort";
}

/// A program that deforms its mesh itself.
TEST(SurfaceSamplerSeries, MeshesMayDeformWithoutTime)
{
  const auto mesh = MakeSquare(8, 1.0, true, VTK_DOUBLE);
  vtkNew<vtkInkSurfaceSampler> sampler;
  Configure(sampler);
  sampler->SetInputData(mesh);
  sampler->Update();
  double before[3];
  sampler->GetOutput()->GetPoint(7, before);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    mesh->GetPoints()->SetPoint(i, 2.0 * p[0], p[1], 1.0);
  }
  mesh->GetPoints()->Modified();
  sampler->Update();
  double after[3];
  sampler->GetOutput()->GetPoint(7, after);
  EXPECT_TRUE(std::abs(after[0] - 2.0 * before[0]) < 1e-12 && after[2] == 1.0) << "moved with the points";
  EXPECT_EQ(sampler->GetNumberOfSamplings(), 1) << "sampled once";
  sampler->SetInputData(MakeSquare(9, 1.0, true, VTK_DOUBLE));
  sampler->Update();
  EXPECT_EQ(sampler->GetNumberOfSamplings(), 2) << "another mesh";
}

/// Half of the surface is stretched to four times its length: no holes there, no larger discs elsewhere.
TEST(SurfaceSamplerSeries, StretchedFacesHaveNoHoles)
{
  const auto stretched = [](double u, double factor) { return u <= 0.5 ? u : 0.5 + factor * (u - 0.5); };
  const auto patch = [&](double factor)
  {
    return MakePatch(
      40, 40, true,
      [&](double u, double v, double p[3])
      {
        p[0] = stretched(u, factor);
        p[1] = v;
        p[2] = 0.0;
      },
      VTK_DOUBLE);
  };
  vtkNew<vtkInkSurfaceSampler> sampler;
  Configure(sampler);
  sampler->SetInputData(patch(1.0));
  sampler->Update();
  const double rest = sampler->GetOutput()->GetPointData()->GetArray("Radius")->GetComponent(0, 0);
  sampler->SetInputData(patch(4.0));
  sampler->Update();
  vtkPolyData* output = sampler->GetOutput();
  vtkDataArray* radius = output->GetPointData()->GetArray("Radius");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double x = output->GetPoint(i)[0];
    const double ratio = radius->GetComponent(i, 0) / rest;
    EXPECT_TRUE(x > 0.4 || std::abs(ratio - 1.0) < 1e-6) << "at rest at " << x << ": " << ratio;
    EXPECT_TRUE(x < 0.5 || std::abs(ratio - 4.0) < 1e-5) << "stretched at " << x << ": " << ratio;
  }
  for (int row = 0; row < 60; ++row)
  {
    for (int column = 0; column < 150; ++column)
    {
      const double x = 2.5 * (column + 0.5) / 150;
      const double y = (row + 0.5) / 60;
      bool covered = false;
      for (vtkIdType i = 0; i < output->GetNumberOfPoints() && !covered; ++i)
      {
        const double* p = output->GetPoint(i);
        covered = std::hypot(p[0] - x, p[1] - y) <= radius->GetComponent(i, 0);
      }
      EXPECT_TRUE(covered) << "a hole at " << x << ", " << y;
    }
  }
}
