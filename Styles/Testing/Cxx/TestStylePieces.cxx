// SPDX-License-Identifier: BSD-3-Clause
// From data to marks, of all styles: what is accepted, what is noted, that making is no change; processes,
// progress, light.
#include "StyleData.h"
#include "StyleErrors.h"

#include "InkStyleProcesses.h"
#include "vtkInkIllustrationStyle.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkStippleGenerator.h"
#include "vtkInkStippleMapper.h"
#include "vtkInkStippleStyle.h"

#include "vtkAppendFilter.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace
{

TEST(StylePieces, WhatIsAcceptedAndWhyNot)
{
  vtkNew<vtkImageData> plain;
  plain->SetDimensions(2, 2, 2);
  vtkNew<vtkTable> table;
  vtkNew<vtkPolyData> empty;
  for (const auto& style : MakeStyles())
  {
    EXPECT_TRUE(style->Accepts(MakeBall()));
    EXPECT_TRUE(style->Accepts(MakeMesh()));
    for (vtkDataObject* wrong : std::initializer_list<vtkDataObject*>{ table, empty, nullptr })
    {
      EXPECT_FALSE(style->Accepts(wrong));
      EXPECT_NE(style->GetReasonAgainst(wrong).find("expected an image"), std::string::npos);
    }
  }
  vtkNew<vtkInkSplattingLinesStyle> lines;
  EXPECT_TRUE(lines->Accepts(MakeCloud()));
  EXPECT_NE(lines->GetReasonAgainst(plain).find("without point scalars"), std::string::npos);
  const StyleErrors errors(lines);
  EXPECT_FALSE(lines->Draw(plain));
  EXPECT_EQ(errors.All.size(), 1u);
  EXPECT_EQ(lines->GetPiece(0)->GetNumberOfPoints(), 0);
  vtkNew<vtkInkStippleStyle> stipple;
  EXPECT_TRUE(stipple->Accepts(MakeCloud()));
}

TEST(StylePieces, MakingMarksIsNoChange)
{
  for (const auto& style : MakeStyles())
  {
    MakeFewMarks(style);
    for (const vtkSmartPointer<vtkDataObject>& data :
      std::initializer_list<vtkSmartPointer<vtkDataObject>>{ MakeBall(), MakeMesh() })
    {
      const vtkMTimeType before = style->GetMTime();
      ASSERT_TRUE(style->Draw(data));
      EXPECT_EQ(style->GetMTime(), before) << style->GetName();
      ASSERT_TRUE(style->Draw(data));
      EXPECT_EQ(style->GetMTime(), before) << style->GetName();
    }
  }
  vtkNew<vtkInkStippleStyle> style;
  MakeFewMarks(style);
  ASSERT_TRUE(style->Draw(MakeBall()));
  const vtkMTimeType made = style->GetMTime();
  style->GetGenerator()->SetSeed(7);
  EXPECT_GT(style->GetMTime(), made);
}

TEST(StylePieces, NothingToDrawIsNoted)
{
  vtkNew<vtkImageData> even;
  even->SetDimensions(8, 8, 8);
  even->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  even->GetPointData()->GetScalars()->Fill(7);
  vtkNew<vtkInkStippleStyle> style;
  EXPECT_TRUE(style->Draw(even));
  ASSERT_EQ(style->GetNumberOfNotes(), 1);
  EXPECT_NE(std::string(style->GetNote(0)).find("nothing to draw"), std::string::npos);
  EXPECT_EQ(style->GetStippleMapper()->GetInput(), nullptr);
  vtkNew<vtkInkSplattingLinesStyle> lines;
  const StyleErrors errors(lines);
  EXPECT_FALSE(lines->Draw(even));
  EXPECT_EQ(errors.All.size(), 1u);
}

TEST(StylePieces, GridsAndCompositesAreDrawnByTheirSurfaces)
{
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(5, 6, 7);
  for (const auto& [axis, count] : { std::pair{ 0, 5 }, { 1, 6 }, { 2, 7 } })
  {
    vtkNew<vtkDoubleArray> coordinates;
    for (int i = 0; i < count; ++i)
    {
      coordinates->InsertNextValue(i * i);
    }
    axis == 0     ? grid->SetXCoordinates(coordinates)
      : axis == 1 ? grid->SetYCoordinates(coordinates)
                  : grid->SetZCoordinates(coordinates);
  }
  vtkNew<vtkAppendFilter> toUnstructured;
  toUnstructured->AddInputData(grid);
  toUnstructured->Update();
  vtkDataObject* unstructured = toUnstructured->GetOutput();
  vtkNew<vtkMultiBlockDataSet> meshes;
  meshes->SetBlock(0, MakeMesh());
  meshes->SetBlock(1, grid);
  vtkNew<vtkMultiBlockDataSet> images;
  images->SetBlock(0, MakeBall(16));
  images->SetBlock(2, MakeBall(20));
  vtkNew<vtkInkIllustrationStyle> illustration;
  vtkNew<vtkInkSplattingLinesStyle> lines;
  for (vtkInkStyle* style : std::initializer_list<vtkInkStyle*>{ illustration, lines })
  {
    MakeFewMarks(style);
    for (vtkDataObject* data : std::initializer_list<vtkDataObject*>{ grid, unstructured, meshes, images })
    {
      EXPECT_TRUE(style->Draw(data)) << style->GetName() << ' ' << data->GetClassName();
      EXPECT_GT(CountOf(style), 1000) << style->GetName() << ' ' << data->GetClassName();
      EXPECT_EQ(style->GetNumberOfNotes(), 1) << style->GetName() << ' ' << data->GetClassName();
    }
    ASSERT_TRUE(style->Draw(grid));
    EXPECT_NE(
      std::string(style->GetNote(0)).find("outer surface of a vtkRectilinearGrid"), std::string::npos);
    ASSERT_TRUE(style->Draw(images));
    const vtkIdType together = CountOf(style);
    ASSERT_TRUE(style->Draw(MakeBall(20)));
    EXPECT_GT(together, CountOf(style));
    images->SetBlock(1, MakeMesh());
    const StyleErrors errors(style);
    EXPECT_FALSE(style->Draw(images));
    ASSERT_EQ(errors.All.size(), 1u);
    EXPECT_NE(errors.All[0].find("1 datasets beside images"), std::string::npos) << errors.All[0];
    EXPECT_EQ(CountOf(style), together);
    images->SetBlock(1, nullptr);
  }
  EXPECT_GT(illustration->GetPiece(2)->GetNumberOfPoints(), 1000);
}

/// What another process says of its part.
class TwoProcesses : public InkStyleProcesses
{
public:
  explicit TwoProcesses(int othersKind)
    : OthersKind(othersKind)
  {
  }
  void TakeGreatest(std::span<double> numbers) override
  {
    if (numbers.size() == 2)
    {
      numbers[static_cast<std::size_t>(OthersKind)] = 1;
    }
  }
  void AgreeOnArray(std::string& name, int&) override { name = name.empty() ? "theirs" : name; }

private:
  int OthersKind;
};

TEST(StylePieces, ProcessesAgree)
{
  vtkNew<vtkInkStippleStyle> style;
  // The other one has images: a mesh here is not drawn, and no data is no error.
  style->SetProcesses(std::make_shared<TwoProcesses>(0));
  EXPECT_NE(style->MakeMarks({ MakeMesh() }).find("beside images"), std::string::npos);
  EXPECT_EQ(style->MakeMarks({}), "");
  EXPECT_TRUE(style->GetOfImage());
  EXPECT_EQ(style->GetMadeColorArray(), "theirs");
  style->SetProcesses(nullptr);
  EXPECT_EQ(style->MakeMarks({ MakeMesh() }), "");
  EXPECT_EQ(style->GetMadeColorArray(), "");
}

TEST(StylePieces, ProgressIsTold)
{
  vtkNew<vtkInkStippleStyle> style;
  std::vector<std::string> steps;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&steps);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void*)
    {
      auto& all = *static_cast<std::vector<std::string>*>(client);
      const std::string text = static_cast<vtkInkStyle*>(caller)->GetProgressText();
      if (all.empty() || all.back() != text)
      {
        all.push_back(text);
      }
    });
  style->AddObserver(vtkCommand::ProgressEvent, command);
  style->SetParameterAsString("IsoValues", "60");
  ASSERT_TRUE(style->Make(MakeBall()));
  EXPECT_EQ(steps, (std::vector<std::string>{ "sampling the surface", "placing stipples" }));
}

TEST(StylePieces, LightComesFromItsSide)
{
  vtkNew<vtkInkStippleStyle> style;
  style->SetParameter("LightDirection", 90, 0);
  EXPECT_NEAR(style->GetLight()->GetPosition()[0], 1, 1e-12);
  style->SetParameter("LightDirection", 0, 90);
  EXPECT_NEAR(style->GetLight()->GetPosition()[1], 1, 1e-12);
}

} // namespace
