// SPDX-License-Identifier: BSD-3-Clause
// Parts of an image, asked for by extent or by piece, get the same bits as the whole, and the input is asked
// for no more than a part and its neighbors.

#include "GradientTestImages.h"
#include "InkTestPieces.h"

#include "vtkInkGradient.h"
#include "vtkNew.h"
#include "vtkRTAnalyticSource.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace
{

const char* const Names[] = { "Gradient", "GradientMagnitude", "Value", "Laplacian", "RTData" };

vtkSmartPointer<vtkInkGradient> MakeFilter(vtkRTAnalyticSource* source, int method, int neighborhood)
{
  source->SetWholeExtent(-20, 17, -11, 20, -13, 14);
  auto filter = vtkSmartPointer<vtkInkGradient>::New();
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetMethod(method);
  filter->SetNeighborhood(neighborhood);
  filter->ComputeValueOn();
  filter->ComputeLaplacianOn();
  filter->SetLaplacianScale(0.7);
  return filter;
}

/// How many components of the arrays of a part differ from the whole's; all of them where an array is
/// missing.
vtkIdType CountDifferent(vtkImageData* part, vtkImageData* whole)
{
  vtkIdType different = 0;
  for (const char* name : Names)
  {
    vtkDataArray* some = part->GetPointData()->GetArray(name);
    vtkDataArray* all = whole->GetPointData()->GetArray(name);
    if (!some || !all || some->GetNumberOfTuples() != part->GetNumberOfPoints())
    {
      return VTK_ID_MAX;
    }
    const int* extent = part->GetExtent();
    vtkIdType n = 0;
    for (int k = extent[4]; k <= extent[5]; ++k)
    {
      for (int j = extent[2]; j <= extent[3]; ++j)
      {
        for (int i = extent[0]; i <= extent[1]; ++i, ++n)
        {
          int ijk[3] = { i, j, k };
          const vtkIdType m = whole->ComputePointId(ijk);
          for (int c = 0; c < some->GetNumberOfComponents(); ++c)
          {
            different += some->GetComponent(n, c) != all->GetComponent(m, c);
          }
        }
      }
    }
  }
  return different;
}

} // namespace

TEST(GradientPieces, PartsGetTheBitsOfTheWhole)
{
  for (int method = 0; method < 3; ++method)
  {
    const int neighborhood = method == 2 ? vtkInkGradient::NEIGHBORHOOD_5 : vtkInkGradient::NEIGHBORHOOD_3;
    const int kind = method == 0 ? vtkInkGradient::CENTRAL_DIFFERENCE : vtkInkGradient::REGRESSION;
    vtkNew<vtkRTAnalyticSource> source;
    const auto filter = MakeFilter(source, kind, neighborhood);
    filter->Update();
    vtkNew<vtkImageData> whole;
    whole->ShallowCopy(filter->GetOutput());
    EXPECT_EQ(whole->GetNumberOfPoints(), 38 * 32 * 28) << "the whole image";

    vtkNew<vtkRTAnalyticSource> source2;
    const auto parts = MakeFilter(source2, kind, neighborhood);
    for (const std::array<int, 6>& extent : { std::array<int, 6>{ -20, 17, -11, 20, -13, -3 },
           std::array<int, 6>{ -5, 5, 0, 3, 4, 14 }, std::array<int, 6>{ 17, 17, 20, 20, 14, 14 } })
    {
      parts->UpdateExtent(extent.data());
      vtkImageData* part = parts->GetOutput();
      EXPECT_TRUE(std::equal(extent.begin(), extent.end(), part->GetExtent()))
        << "the extent asked for, found " << part->GetExtent()[0] << " " << part->GetExtent()[1] << " "
        << part->GetExtent()[2] << " " << part->GetExtent()[3];
      EXPECT_EQ(CountDifferent(part, whole), 0)
        << "the whole's results in part " << extent[0] << " " << extent[4] << " with method " << method;
      // Four times the Gaussian's deviation, up.
      const int* input = source2->GetOutput()->GetExtent();
      EXPECT_TRUE(input[4] == std::max(-13, extent[4] - 3) && input[5] == std::min(14, extent[5] + 3))
        << "no more than the neighbors from the input, found slices " << input[4] << " to " << input[5];
    }
    // Another filter, because the pipeline does not take an extent and then a piece.
    vtkNew<vtkRTAnalyticSource> source3;
    const auto byPiece = MakeFilter(source3, kind, neighborhood);
    for (const int pieces : { 2, 5 })
    {
      vtkIdType cells = 0;
      for (int piece = 0; piece < pieces; ++piece)
      {
        byPiece->UpdatePiece(piece, pieces, 0);
        EXPECT_EQ(CountDifferent(byPiece->GetOutput(), whole), 0)
          << "the whole's results in piece " << piece << " of " << pieces;
        cells += byPiece->GetOutput()->GetNumberOfCells();
      }
      EXPECT_EQ(cells, whole->GetNumberOfCells()) << "every cell once in " << pieces << " pieces, found "
                                                  << cells << " of " << whole->GetNumberOfCells();
    }
  }
}

/// A reader that knows no pieces, on several processes: the first one has all.
TEST(GradientPieces, ReadersWithoutPiecesGiveAllToTheFirstProcess)
{
  vtkNew<vtkRTAnalyticSource> all;
  vtkNew<vtkRTAnalyticSource> source;
  const auto filter = MakeFilter(all, vtkInkGradient::REGRESSION, vtkInkGradient::NEIGHBORHOOD_3);
  filter->Update();
  for (int piece = 0; piece < 2; ++piece)
  {
    const auto serial = MakeFilter(source, vtkInkGradient::REGRESSION, vtkInkGradient::NEIGHBORHOOD_3);
    serial->SetInputConnection(InkTestSerialPipeline(all->GetOutput())->GetOutputPort());
    serial->UpdatePiece(piece, 2, 1);
    vtkImageData* part = serial->GetOutput();
    const vtkIdType expected = piece == 0 ? filter->GetOutput()->GetNumberOfPoints() : 0;
    EXPECT_EQ(part->GetNumberOfPoints(), expected)
      << expected << " points of a whole image on process " << piece;
    EXPECT_TRUE(piece > 0 || CountDifferent(part, filter->GetOutput()) == 0) << "the whole's results";
  }
}

TEST(GradientPieces, ImagesThatCameInPartsKeepThem)
{
  vtkNew<vtkRTAnalyticSource> all;
  all->SetWholeExtent(0, 20, 0, 20, 0, 20);
  vtkNew<vtkImageData> piece;
  all->Update();
  piece->DeepCopy(all->GetOutput());
  const int own[6] = { 0, 20, 0, 20, 0, 3 };
  piece->Crop(own);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(piece);
  int wholeExtent[6] = { 0, 20, 0, 20, 0, 20 };
  producer->SetWholeExtent(wholeExtent);
  vtkNew<vtkInkGradient> ofPart;
  ofPart->SetInputConnection(producer->GetOutputPort());
  ofPart->UpdatePiece(1, 2, 0);
  EXPECT_EQ(ofPart->GetOutput()->GetNumberOfPoints(), 21 * 21 * 4) << "all of the part";
}

TEST(GradientPieces, ImagesInMemoryAreCutToThePart)
{
  auto image =
    MakeImage(VTK_FLOAT, { 0, 9, 0, 8, 0, 7 }, [](double x, double y, double z) { return x * y + z; });
  vtkNew<vtkInkGradient> filter;
  filter->SetInputData(image);
  const int extent[6] = { 2, 5, 0, 8, 3, 3 };
  filter->UpdateExtent(extent);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 4 * 9) << "36 points";
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetScalars()->GetNumberOfTuples(), 36)
    << "36 values passed on";
}

TEST(GradientPieces, AreTheSameOnOneThreadAndOnTwo)
{
  vtkNew<vtkRTAnalyticSource> source;
  const auto any = MakeFilter(source, vtkInkGradient::REGRESSION, vtkInkGradient::NEIGHBORHOOD_3);
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  any->Update();
  vtkNew<vtkImageData> one;
  one->DeepCopy(any->GetOutput());
  setenv("VTK_SMP_MAX_THREADS", "2", 1);
  any->Modified();
  any->Update();
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_EQ(CountDifferent(any->GetOutput(), one), 0) << "values that differ";
}
