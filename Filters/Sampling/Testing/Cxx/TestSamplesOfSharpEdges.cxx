// SPDX-License-Identifier: BSD-3-Clause
// Samples and stipples of meshes whose faces share points at sharp edges.

#include "InkTestWeldedBox.h"

#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkInkStippleGenerator.h"
#include "vtkInkSurfaceSampler.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

TEST(SamplesOfSharpEdges, StipplesHaveTheColorsOfSplitMeshes)
{
  const vtkSmartPointer<vtkPolyData> box = InkTestWeldedBox();
  InkTestAddMeanNormals(box);
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetInputData(box);
  generator->SetNumberOfSurfaceStipples(500);
  generator->PassScalarsOn();
  for (const char* name : { "Heat", "" })
  {
    generator->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
    generator->Update();
    vtkPolyData* stipples = generator->GetOutput();
    ASSERT_GT(stipples->GetNumberOfCells(), 0) << name;
    vtkDataArray* heat = stipples->GetCellData()->GetArray("Heat");
    ASSERT_TRUE(heat) << name;
    EXPECT_EQ(heat->GetNumberOfTuples(), stipples->GetNumberOfCells());
  }
}

TEST(SamplesOfSharpEdges, SamplesFaceOneSide)
{
  vtkNew<vtkInkSurfaceSampler> sampler;
  sampler->SetInputData(InkTestWeldedBox());
  sampler->SetNumberOfSamples(2000);
  const auto worst = [&]
  {
    sampler->Update();
    double least = 1.0;
    vtkDataArray* normals = sampler->GetOutput()->GetPointData()->GetNormals();
    for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
    {
      const double* n = normals->GetTuple3(i);
      least = std::min(least, std::max({ std::abs(n[0]), std::abs(n[1]), std::abs(n[2]) }));
    }
    return least;
  };
  EXPECT_GT(worst(), 1.0 - 1e-6);
  // Samples that are to follow a mesh keep its points, and so the means over its edges.
  sampler->KeepFacesOn();
  EXPECT_LT(worst(), 0.7);
}

TEST(SamplesOfSharpEdges, KnowWhereTheirSideEnds)
{
  vtkNew<vtkInkSurfaceSampler> sampler;
  sampler->SetInputData(InkTestWeldedBox());
  sampler->SetNumberOfSamples(2000);
  sampler->Update();
  EXPECT_FALSE(sampler->GetOutput()->GetPointData()->HasArray("EdgeOffsets"));
  sampler->ComputeEdgeOffsetsOn();
  sampler->Update();
  vtkPointData* samples = sampler->GetOutput()->GetPointData();
  vtkDataArray* offsets = samples->GetArray("EdgeOffsets");
  ASSERT_TRUE(offsets);
  ASSERT_EQ(offsets->GetNumberOfComponents(), 6);
  ASSERT_EQ(offsets->GetNumberOfTuples(), sampler->GetOutput()->GetNumberOfPoints());
  vtkIdType near = 0;
  for (vtkIdType i = 0; i < offsets->GetNumberOfTuples(); ++i)
  {
    const double* n = samples->GetNormals()->GetTuple3(i);
    const double along = n[0] * offsets->GetComponent(i, 0) + n[1] * offsets->GetComponent(i, 1) +
      n[2] * offsets->GetComponent(i, 2);
    EXPECT_NEAR(along, 0.0, 1e-6) << "they lie in the sample's face";
    near += offsets->GetComponent(i, 0) != 0.0 || offsets->GetComponent(i, 1) != 0.0 ||
      offsets->GetComponent(i, 2) != 0.0;
  }
  EXPECT_GT(near, 200);
}

TEST(SamplesOfSharpEdges, KnowWhereItEndsOnceMoved)
{
  vtkNew<vtkCubeSource> box;
  vtkNew<vtkInkSurfaceSampler> sampler;
  sampler->SetInputConnection(box->GetOutputPort());
  sampler->SetNumberOfSamples(500);
  sampler->KeepFacesOn();
  sampler->ComputeEdgeOffsetsOn();
  sampler->Update();
  vtkPolyData* samples = sampler->GetOutput();
  vtkDataArray* before = samples->GetPointData()->GetArray("EdgeOffsets");
  ASSERT_TRUE(before);
  vtkNew<vtkTransform> turn;
  turn->RotateWXYZ(50.0, 1.0, 2.0, 3.0);
  turn->Scale(2.0, 2.0, 2.0);
  turn->Translate(7.0, 0.0, 0.0);
  vtkNew<vtkTransformPolyDataFilter> turned;
  turned->SetInputConnection(box->GetOutputPort());
  turned->SetTransform(turn);
  vtkNew<vtkInkSurfaceSampler> mover;
  mover->SetInputConnection(turned->GetOutputPort());
  mover->SetFirstFrameData(samples);
  mover->Update();
  vtkDataArray* moved = mover->GetOutput()->GetPointData()->GetArray("EdgeOffsets");
  ASSERT_TRUE(moved);
  ASSERT_EQ(moved->GetNumberOfTuples(), before->GetNumberOfTuples());
  for (vtkIdType i = 0; i < moved->GetNumberOfTuples(); ++i)
  {
    std::array<double, 6> vectors;
    std::array<double, 6> expected;
    before->GetTuple(i, expected.data());
    moved->GetTuple(i, vectors.data());
    for (std::size_t v = 0; v < 6; v += 3)
    {
      turn->TransformVector(&expected[v], &expected[v]);
      ASSERT_LT(vtkMath::Distance2BetweenPoints(&vectors[v], &expected[v]), 1e-10) << "sample " << i;
    }
  }
}
