// SPDX-License-Identifier: BSD-3-Clause
// Images that have values in their cells give what images of points in the cells' centers give: whole, in
// pieces, and a few slices at a time.

#include "InkTestMessages.h"
#include "SamplerTestImages.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkStippleGenerator.h"
#include "vtkNew.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include <unistd.h>

namespace
{

constexpr double IsoValue = 100.0;
constexpr std::array<int, 6> Centers{ 3, 66, -5, 58, 0, 127 };
constexpr std::array<double, 3> Spacing{ 1.0, 0.5, 2.0 };

vtkSmartPointer<vtkImageData> ImageOfPoints()
{
  const auto image = MakeImage(
    VTK_FLOAT, Centers,
    [](double x, double y, double z) { return BallDensity(x - 34, 2 * (y - 13), (z - 127) / 2, 29.0); },
    Spacing);
  image->GetPointData()->GetScalars()->SetName("density");
  return image;
}

/// The same values in cells around these points. Halves of the spacing are exact.
vtkSmartPointer<vtkImageData> ImageOfCells()
{
  const auto points = ImageOfPoints();
  auto image = vtkSmartPointer<vtkImageData>::New();
  std::array<int, 6> extent = Centers;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    ++extent[2 * axis + 1];
  }
  image->SetExtent(extent.data());
  image->SetSpacing(Spacing.data());
  image->SetOrigin(-Spacing[0] / 2, -Spacing[1] / 2, -Spacing[2] / 2);
  image->GetCellData()->SetScalars(points->GetPointData()->GetScalars());
  return image;
}

vtkSmartPointer<vtkInkIsoSurfaceSampler> SamplerOf(vtkImageData* image)
{
  auto sampler = vtkSmartPointer<vtkInkIsoSurfaceSampler>::New();
  sampler->SetInputData(image);
  sampler->SetValue(0, IsoValue);
  return sampler;
}

std::vector<Sample> Expected()
{
  const auto sampler = SamplerOf(ImageOfPoints());
  sampler->Update();
  return SortedSamplesOf(sampler->GetOutput());
}

/// A file with values in cells, which goes with the test.
class IsoSurfaceSamplerCells : public testing::Test
{
protected:
  IsoSurfaceSamplerCells()
  {
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputData(ImageOfCells());
    writer->SetFileName(this->File.c_str());
    writer->SetCompressorTypeToNone();
    writer->Write();
    this->Reader->SetFileName(this->File.c_str());
  }
  ~IsoSurfaceSamplerCells() override { std::filesystem::remove(this->File); }

  vtkNew<vtkXMLImageDataReader> Reader;

private:
  const std::filesystem::path File =
    std::filesystem::temp_directory_path() / ("ink-cells-" + std::to_string(getpid()) + ".vti");
};

} // namespace

TEST_F(IsoSurfaceSamplerCells, AreSampledAsPointsInTheirCenters)
{
  const std::vector<Sample> expected = Expected();
  ASSERT_GT(expected.size(), 1000u);
  const auto image = ImageOfCells();
  vtkNew<InkTestMessages> messages;
  const auto sampler = SamplerOf(image);
  messages->Observe(sampler);
  sampler->Update();
  EXPECT_TRUE(SortedSamplesOf(sampler->GetOutput()) == expected) << sampler->GetOutput()->GetNumberOfPoints();
  for (const int association :
    { vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataObject::FIELD_ASSOCIATION_POINTS })
  {
    sampler->SetInputArrayToProcess(0, 0, 0, association, "density");
    sampler->Update();
    EXPECT_TRUE(SortedSamplesOf(sampler->GetOutput()) == expected) << association;
  }
  sampler->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataSetAttributes::SCALARS);
  sampler->Update();
  EXPECT_TRUE(SortedSamplesOf(sampler->GetOutput()) == expected) << "by attribute";
  messages->Expect("cells", {});
}

TEST_F(IsoSurfaceSamplerCells, PointArraysComeFirst)
{
  const auto image = ImageOfCells();
  vtkNew<vtkFloatArray> zeros;
  zeros->SetName("zeros");
  zeros->SetNumberOfValues(image->GetNumberOfPoints());
  zeros->FillValue(0.0F);
  image->GetPointData()->SetScalars(zeros);
  vtkNew<InkTestMessages> messages;
  const auto sampler = SamplerOf(image);
  messages->Observe(sampler);
  sampler->Update();
  EXPECT_EQ(sampler->GetOutput()->GetNumberOfPoints(), 0);
  messages->Messages.clear();
  sampler->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "density");
  sampler->Update();
  EXPECT_TRUE(SortedSamplesOf(sampler->GetOutput()) == Expected()) << "asked for by its name";
  messages->Expect("the cells' array by its name", {});
  sampler->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "none");
  sampler->Update();
  messages->Expect("an array that is not there",
    { "No numeric point array \"none\"", "Its point arrays: \"zeros\".", "Its cell arrays: \"density\"" });
}

TEST_F(IsoSurfaceSamplerCells, PiecesAreTheWhole)
{
  const std::vector<Sample> expected = Expected();
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputConnection(this->Reader->GetOutputPort());
  sampler->SetValue(0, IsoValue);
  for (const int pieces : { 1, 2, 5 })
  {
    const std::vector<Sample> all = SamplesOfPieces(sampler, pieces);
    EXPECT_TRUE(all == expected) << pieces << " pieces: " << all.size() << " points, expected "
                                 << expected.size();
  }
}

TEST_F(IsoSurfaceSamplerCells, SlicesAreTheWhole)
{
  const std::vector<Sample> expected = Expected();
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputConnection(this->Reader->GetOutputPort());
  sampler->SetValue(0, IsoValue);
  sampler->SetMaximumMemory(97); // room for a few
  sampler->Update();
  EXPECT_TRUE(SortedSamplesOf(sampler->GetOutput()) == expected) << sampler->GetOutput()->GetNumberOfPoints();
  EXPECT_LT(this->Reader->GetOutput()->GetDimensions()[2], 65) << "not all of it at once";
}

TEST_F(IsoSurfaceSamplerCells, ChangesOfTheImageAreSeen)
{
  const auto image = ImageOfCells();
  const auto sampler = SamplerOf(image);
  sampler->SetUseIndex(true);
  sampler->Update();
  const vtkIdType before = sampler->GetOutput()->GetNumberOfPoints();
  sampler->SetValue(0, IsoValue + 50.0);
  sampler->Update();
  EXPECT_LT(sampler->GetOutput()->GetNumberOfPoints(), before);
  auto* values = vtkFloatArray::SafeDownCast(image->GetCellData()->GetScalars());
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    values->SetValue(i, values->GetValue(i) + 50.0F);
  }
  values->Modified();
  image->Modified();
  sampler->Update();
  EXPECT_EQ(sampler->GetOutput()->GetNumberOfPoints(), before);
}

TEST_F(IsoSurfaceSamplerCells, AreStippledAsPointsInTheirCenters)
{
  const auto stipple = [](vtkImageData* image)
  {
    vtkNew<vtkInkStippleGenerator> generator;
    generator->SetInputData(image);
    generator->Update();
    std::vector<double> coordinates;
    for (vtkIdType i = 0; i < generator->GetOutput()->GetNumberOfPoints(); ++i)
    {
      const double* p = generator->GetOutput()->GetPoint(i);
      coordinates.insert(coordinates.end(), p, p + 3);
    }
    return coordinates;
  };
  const std::vector<double> expected = stipple(ImageOfPoints());
  ASSERT_GT(expected.size(), 3000u);
  EXPECT_TRUE(stipple(ImageOfCells()) == expected);
}
