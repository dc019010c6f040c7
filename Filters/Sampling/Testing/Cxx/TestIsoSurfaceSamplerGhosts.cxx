// SPDX-License-Identifier: BSD-3-Clause
// Cells marked as duplicate, refined or hidden and points marked as hidden make no samples.

#include "SamplerTestImages.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkNew.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

namespace
{

std::vector<Sample> SampleImage(vtkImageData* image)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(image);
  sampler->SetValue(0, 2.5);
  sampler->Update();
  return SamplesOf(sampler->GetOutput());
}

/// A plane across 6 x 6 cells of layer 2 of 5.
vtkSmartPointer<vtkImageData> MakePlane()
{
  return MakeImage(VTK_SHORT, { 0, 6, 0, 6, 0, 5 }, [](double, double, double z) { return z; });
}

void Mark(vtkDataSetAttributes* attributes, vtkIdType count, vtkIdType element, unsigned char mark)
{
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  marks->SetNumberOfTuples(count);
  marks->Fill(0);
  marks->SetValue(element, mark);
  attributes->AddArray(marks);
}

struct Case
{
  unsigned char Mark;
  std::size_t Points;
};
using Attributes = vtkDataSetAttributes;

} // namespace

TEST(IsoSurfaceSamplerGhosts, MarkedCellsMakeNone)
{
  const auto whole = SampleImage(MakePlane());
  EXPECT_EQ(whole.size(), 36u) << "36 points";

  for (const Case& c : { Case{ Attributes::DUPLICATECELL, 35 }, Case{ Attributes::HIDDENCELL, 35 },
         Case{ Attributes::REFINEDCELL, 35 }, Case{ Attributes::EXTERIORCELL, 36 } })
  {
    auto image = MakePlane();
    int cell[3] = { 3, 4, 2 };
    Mark(image->GetCellData(), image->GetNumberOfCells(), image->ComputeCellId(cell), c.Mark);
    const auto samples = SampleImage(image);
    EXPECT_EQ(samples.size(), c.Points) << c.Points << " points with a cell marked " << int(c.Mark);
    for (const Sample& sample : samples)
    {
      EXPECT_TRUE(c.Points == 36 || sample[0] != 3.5 || sample[1] != 4.5)
        << "no point in the cell marked " << int(c.Mark);
    }
  }
}

TEST(IsoSurfaceSamplerGhosts, CellsOfMarkedPointsMakeNone)
{
  for (const Case& c : { Case{ Attributes::HIDDENPOINT, 32 }, Case{ Attributes::DUPLICATEPOINT, 36 } })
  {
    auto image = MakePlane();
    int point[3] = { 3, 4, 2 };
    Mark(image->GetPointData(), image->GetNumberOfPoints(), image->ComputePointId(point), c.Mark);
    const auto samples = SampleImage(image);
    EXPECT_EQ(samples.size(), c.Points) << c.Points << " points with a point marked " << int(c.Mark);
  }
}

TEST(IsoSurfaceSamplerGhosts, BlankedCellsAndPointsMakeNone)
{
  vtkNew<vtkUniformGrid> grid;
  grid->ShallowCopy(MakePlane());
  grid->BlankCell(3, 4, 2);
  EXPECT_EQ(SampleImage(grid).size(), 35u) << "35 points with a blanked cell";
  grid->BlankPoint(0, 0, 3);
  EXPECT_EQ(SampleImage(grid).size(), 34u) << "34 points with a blanked corner too";
}
