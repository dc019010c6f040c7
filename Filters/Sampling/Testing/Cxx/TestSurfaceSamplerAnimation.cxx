// SPDX-License-Identifier: BSD-3-Clause
// Samples of the first frame move with a deformed mesh, and say when they are of another one.

#include "InkTestMessages.h"
#include "SamplerTestMeshes.h"

#include "vtkInkSurfaceSampler.h"

#include <gtest/gtest.h>

namespace
{

void Expect(vtkPolyData* mesh, vtkPolyData* samples, const std::string& word)
{
  vtkNew<vtkInkSurfaceSampler> sampler;
  vtkNew<InkTestMessages> messages;
  messages->Observe(sampler);
  sampler->SetInputData(mesh);
  sampler->SetFirstFrameData(samples);
  sampler->Update();
  EXPECT_EQ(sampler->GetOutput()->GetNumberOfPoints(), 0) << word << ": no points";
  EXPECT_TRUE(messages->Messages.size() == 1 && messages->Messages[0].find(word) != std::string::npos)
    << word << " in one message, found " << messages->Messages.size()
    << (messages->Messages.empty() ? "" : messages->Messages[0]);
}

vtkSmartPointer<vtkPolyData> SampleOnce(vtkPolyData* mesh)
{
  vtkNew<vtkInkSurfaceSampler> sampler;
  sampler->SetInputData(mesh);
  sampler->SetNumberOfSamples(1500);
  sampler->KeepFacesOn();
  sampler->Update();
  return sampler->GetOutput();
}

} // namespace

TEST(SurfaceSamplerAnimation, SamplesFollowTheirFaces)
{
  for (const bool triangles : { true, false })
  {
    const auto first = MakeSquare(12, 1.0, triangles, VTK_DOUBLE);
    const auto samples = SampleOnce(first);

    vtkNew<vtkInkSurfaceSampler> mover;
    mover->SetInputData(first);
    mover->SetFirstFrameData(samples);
    mover->Update();
    EXPECT_TRUE(AreEqual(mover->GetOutput(), samples)) << "unmoved, to the bit";

    // Linear in each triangle, so that each sample is where the map takes it: sheared, scaled by two, tilted.
    const auto moved = MakePatch(
      12, 12, triangles,
      [](double u, double v, double p[3])
      {
        p[0] = 2.0 * u + v;
        p[1] = 2.0 * v;
        p[2] = u;
      },
      VTK_DOUBLE);
    mover->SetInputData(moved);
    mover->Update();
    vtkPolyData* output = mover->GetOutput();
    EXPECT_TRUE(output->GetNumberOfPoints() == 1500 && output->GetPointData()->GetArray("Priority"))
      << "all points with their priority";
    // The normal of the plane: (2, 0, 1) x (1, 2, 0) = (-2, 1, 4).
    const double scale = 1.0 / std::sqrt(21.0);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      double a[3];
      double b[3];
      double n[3];
      samples->GetPoint(i, a);
      output->GetPoint(i, b);
      output->GetPointData()->GetNormals()->GetTuple(i, n);
      const double wrong = std::hypot(b[0] - 2.0 * a[0] - a[1], b[1] - 2.0 * a[1], b[2] - a[0]);
      ASSERT_LT(wrong, 1e-12) << "sample " << i << " moved with its face";
      ASSERT_LT(std::hypot(n[0] + 2.0 * scale, n[1] - scale, n[2] - 4.0 * scale), 1e-5)
        << "normal of sample " << i;
    }
    const double ratio = output->GetPointData()->GetArray("Radius")->GetComponent(0, 0) /
      samples->GetPointData()->GetArray("Radius")->GetComponent(0, 0);
    // The map's larger singular value: its columns are (2, 0, 1) and (1, 2, 0).
    EXPECT_LT(std::abs(ratio - std::sqrt(7.0)), 1e-6) << "the radius grows by the stretch, found " << ratio;
  }
}

TEST(SurfaceSamplerAnimation, RefusesOtherMeshesAndSamples)
{
  for (const bool triangles : { true, false })
  {
    const auto first = MakeSquare(12, 1.0, triangles, VTK_DOUBLE);
    const auto samples = SampleOnce(first);
    Expect(MakeSquare(11, 1.0, triangles), samples, triangles ? "242" : "121");
    // As many cells and points, joined in another way.
    vtkNew<vtkPolyData> turned;
    turned->DeepCopy(first);
    turned->ReverseCell(5);
    Expect(turned, samples, "other points");
    const auto bare = vtkSmartPointer<vtkPolyData>::New();
    bare->SetPoints(samples->GetPoints());
    Expect(first, bare, "KeepFaces");
    samples->GetPointData()->GetArray("FacePoints")->SetComponent(7, 1, 1e6);
    Expect(first, samples, "sample 7");
  }
}
