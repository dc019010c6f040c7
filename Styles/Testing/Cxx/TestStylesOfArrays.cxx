// SPDX-License-Identifier: BSD-3-Clause
// All styles draw the array of images that is asked for by its name: of images themselves, in composite data,
// from a port as ParaView's are, and read a few slices at a time.
#include "StyleData.h"
#include "StyleErrors.h"

#include "InkActiveScalars.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkStyle.h"

#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace
{

/// The ball, with a smaller one in another array.
vtkSmartPointer<vtkImageData> MakeTwoBalls()
{
  auto both = vtkSmartPointer<vtkImageData>::New();
  both->ShallowCopy(MakeBall());
  vtkDataArray* density = both->GetPointData()->GetScalars();
  const auto core = vtk::TakeSmartPointer(density->NewInstance());
  core->SetName("core");
  core->SetNumberOfTuples(density->GetNumberOfTuples());
  for (vtkIdType i = 0; i < core->GetNumberOfTuples(); ++i)
  {
    core->SetTuple1(i, std::max(0.0, 2.0 * density->GetTuple1(i) - 200.0));
  }
  both->GetPointData()->AddArray(core);
  return both;
}

} // namespace

TEST(StylesOfArrays, DrawTheOneThatIsNamed)
{
  const auto both = MakeTwoBalls();
  const auto core = InkWithActiveScalars(both, "core");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, both);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(both);
  for (const auto& style : MakeStyles())
  {
    style->SetPictureSize(100.0);
    ASSERT_TRUE(style->Make(both)) << style->GetName();
    const std::vector<double> outer = MarksOf(style);
    ASSERT_TRUE(style->Make(core)) << style->GetName();
    const std::vector<double> expected = MarksOf(style);
    ASSERT_GT(expected.size(), 300u) << style->GetName();
    EXPECT_FALSE(outer == expected) << style->GetName();
    style->SetParameterAsString("Scalars", "core");
    ASSERT_TRUE(style->Make(both)) << style->GetName();
    EXPECT_TRUE(MarksOf(style) == expected) << style->GetName() << ": " << MarksOf(style).size();
    ASSERT_TRUE(style->Make(blocks)) << style->GetName();
    EXPECT_GT(CountOf(style), 0) << style->GetName();
    ASSERT_EQ(style->MakeMarks({ .Data = core, .Port = producer->GetOutputPort() }), "");
    const std::vector<double> fromPort = MarksOf(style);
    ASSERT_EQ(style->MakeMarks({ .Data = both, .Port = producer->GetOutputPort() }), "");
    EXPECT_TRUE(MarksOf(style) == fromPort) << style->GetName() << ": " << fromPort.size();
  }
}

TEST(StylesOfArrays, AreReadAFewSlicesAtATime)
{
  const auto style = vtk::TakeSmartPointer(vtkInkStyle::CreateStyle("splatting-lines"));
  style->SetParameterAsString("Scalars", "core");
  ASSERT_TRUE(style->Make(MakeTwoBalls()));
  const std::vector<double> expected = MarksOf(style);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(MakeTwoBalls());
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputConnection(producer->GetOutputPort());
  ASSERT_EQ(style->MakeMarks({ .Surfaces = sampler }), "");
  EXPECT_TRUE(MarksOf(style) == expected) << MarksOf(style).size() << " of " << expected.size();
}

TEST(StylesOfArrays, SayWhatThereIsInPlaceOfOneThatIsNot)
{
  const auto both = MakeTwoBalls();
  for (const auto& style : MakeStyles())
  {
    style->SetParameterAsString("Scalars", "velocity");
    const std::string expected = "an image without the array 'velocity', with 'density', 'core'";
    EXPECT_NE(style->GetReasonAgainst(both).find(expected), std::string::npos)
      << style->GetName() << ": " << style->GetReasonAgainst(both);
    const StyleErrors errors(style);
    EXPECT_FALSE(style->Make(both)) << style->GetName();
    ASSERT_EQ(errors.All.size(), 1u) << style->GetName();
    EXPECT_NE(errors.All[0].find(expected), std::string::npos) << style->GetName() << ": " << errors.All[0];
    EXPECT_EQ(CountOf(style), 0) << style->GetName();
  }
}
