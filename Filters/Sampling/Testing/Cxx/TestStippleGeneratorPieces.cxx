// SPDX-License-Identifier: BSD-3-Clause
// The pieces of an image, or parts of it with ghost cells, give together exactly the stipples of the whole:
// each once, with the same arrays.

#include "InkTestPieces.h"
#include "SamplerTestImages.h"
#include "Stippling/StippledVoxels.h"

#include "vtkCellData.h"
#include "vtkExtentTranslator.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInkStippleGenerator.h"
#include "vtkNew.h"
#include "vtkRTAnalyticSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <memory>

namespace
{

const int PerVoxel = 4;

/// A stipple as its position, its element's normal and the two numbers.
using Stipple = std::array<double, 8>;

std::vector<Stipple> StipplesOf(vtkPolyData* data)
{
  std::vector<Stipple> stipples(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t n = 0; n < stipples.size(); ++n)
  {
    const auto element = static_cast<vtkIdType>(n / PerVoxel);
    data->GetPoint(static_cast<vtkIdType>(n), stipples[n].data());
    data->GetCellData()->GetNormals()->GetTuple(element, stipples[n].data() + 3);
    stipples[n][6] = data->GetCellData()->GetArray("GradientMagnitude")->GetComponent(element, 0);
    stipples[n][7] = data->GetCellData()->GetArray("Value")->GetComponent(element, 0);
  }
  return stipples;
}

vtkSmartPointer<vtkInkStippleGenerator> MakeGenerator()
{
  auto generator = vtkSmartPointer<vtkInkStippleGenerator>::New();
  generator->SetMaximumStipples(PerVoxel);
  generator->SetGradientPercentile(80.0);
  return generator;
}

/// One that needs nothing of the whole image: as the whole's output says.
vtkSmartPointer<vtkInkStippleGenerator> MakeLocalGenerator(vtkPolyData* whole)
{
  const auto generator = MakeGenerator();
  generator->SetThresholdModeToMagnitude();
  generator->SetGradientThreshold(10.0);
  generator->UseReferenceRangesOn();
  vtkFieldData* field = whole->GetFieldData();
  generator->SetReferenceScalarRange(field->GetArray("ScalarRange")->GetTuple(0));
  generator->SetReferenceGradient(field->GetArray("GradientMagnitudeRange")->GetComponent(0, 1));
  return generator;
}

/// As a simulation hands it over: its own part of an image, with ghost cells.
vtkSmartPointer<vtkTrivialProducer> MakePart(vtkImageData* image, int part, int parts, int levels)
{
  vtkNew<vtkExtentTranslator> translator;
  int own[6];
  int grown[6];
  int extent[6];
  image->GetExtent(extent);
  translator->PieceToExtentThreadSafe(part, parts, 0, extent, own, vtkExtentTranslator::BLOCK_MODE, 0);
  translator->PieceToExtentThreadSafe(part, parts, levels, extent, grown, vtkExtentTranslator::BLOCK_MODE, 0);
  vtkNew<vtkImageData> piece;
  piece->DeepCopy(image);
  piece->Crop(grown);
  piece->GenerateGhostArray(own);
  auto producer = vtkSmartPointer<vtkTrivialProducer>::New();
  producer->SetOutput(piece);
  producer->SetWholeExtent(extent);
  return producer;
}

std::vector<Stipple> StipplePieces(vtkInkStippleGenerator* generator, int pieces)
{
  std::vector<Stipple> all;
  for (int piece = 0; piece < pieces; ++piece)
  {
    generator->UpdatePiece(piece, pieces, 0);
    const auto stipples = StipplesOf(generator->GetOutput());
    all.insert(all.end(), stipples.begin(), stipples.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// An image with the stipples of the whole, sorted: of a share of the voxels, and beyond a threshold.
class StippleGeneratorPieces : public testing::Test
{
protected:
  StippleGeneratorPieces()
  {
    this->Source->SetWholeExtent(-20, 17, -11, 20, -13, 14);
    this->Source->Update();
    this->Image->DeepCopy(this->Source->GetOutput());
    this->Whole = this->StippleAll(MakeGenerator());
    this->Reference->SetThresholdModeToMagnitude();
    this->Reference->SetGradientThreshold(10.0);
    this->Expected = this->StippleAll(this->Reference);
  }

  vtkNew<vtkRTAnalyticSource> Source;
  vtkNew<vtkImageData> Image;
  const vtkSmartPointer<vtkInkStippleGenerator> Reference = MakeGenerator();
  std::vector<Stipple> Whole;
  std::vector<Stipple> Expected;

private:
  std::vector<Stipple> StippleAll(vtkInkStippleGenerator* generator)
  {
    generator->SetInputData(this->Image);
    generator->Update();
    auto stipples = StipplesOf(generator->GetOutput());
    std::sort(stipples.begin(), stipples.end());
    return stipples;
  }
};

} // namespace

TEST_F(StippleGeneratorPieces, AreTheWhole)
{
  EXPECT_GT(Whole.size(), 20000u) << "many stipples";
  const auto generator = MakeGenerator();
  generator->SetInputConnection(Source->GetOutputPort());
  const auto ofData = MakeGenerator();
  ofData->SetInputData(Image);
  for (const int pieces : { 2, 3, 4, 8 })
  {
    for (vtkInkStippleGenerator* one : { generator.Get(), ofData.Get() })
    {
      const auto stipples = StipplePieces(one, pieces);
      EXPECT_EQ(stipples, Whole) << "the whole from " << pieces << " pieces: " << Whole.size()
                                 << " stipples, found " << stipples.size();
    }
  }
}

TEST_F(StippleGeneratorPieces, ByGivenRangesAreTheWhole)
{
  EXPECT_GT(Expected.size(), 1000u) << "stipples beyond a threshold";
  const auto local = MakeLocalGenerator(Reference->GetOutput());
  local->SetInputConnection(Source->GetOutputPort());
  const auto localOfData = MakeLocalGenerator(Reference->GetOutput());
  localOfData->SetInputData(Image);
  for (const int pieces : { 1, 2, 5, 8 })
  {
    for (vtkInkStippleGenerator* one : { local.Get(), localOfData.Get() })
    {
      const auto stipples = StipplePieces(one, pieces);
      EXPECT_EQ(stipples, Expected) << "the whole from " << pieces
                                    << " pieces by given ranges: " << Expected.size() << " stipples, found "
                                    << stipples.size();
    }
    std::vector<Stipple> together;
    for (int part = 0; part < pieces; ++part)
    {
      const auto producer = MakePart(Image, part, pieces, 5);
      const auto ofPart = MakeLocalGenerator(Reference->GetOutput());
      ofPart->SetInputConnection(producer->GetOutputPort());
      ofPart->UpdatePiece(part, pieces, 0);
      const auto stipples = StipplesOf(ofPart->GetOutput());
      together.insert(together.end(), stipples.begin(), stipples.end());
    }
    std::sort(together.begin(), together.end());
    EXPECT_EQ(together, Expected) << "the whole from " << pieces
                                  << " parts with ghost cells: " << Expected.size() << " stipples, found "
                                  << together.size();
  }
}

TEST_F(StippleGeneratorPieces, OfSmoothedValuesAreTheWhole)
{
  const auto whole = MakeGenerator();
  whole->SetInputData(Image);
  whole->SetSmoothing(1.3);
  whole->SetThresholdModeToMagnitude();
  whole->SetGradientThreshold(7.0);
  whole->Update();
  auto expected = StipplesOf(whole->GetOutput());
  std::sort(expected.begin(), expected.end());
  EXPECT_GT(expected.size(), 1000u);
  EXPECT_NE(expected.size(), Expected.size());
  const auto local = MakeLocalGenerator(whole->GetOutput());
  local->SetInputConnection(Source->GetOutputPort());
  local->SetSmoothing(1.3);
  local->SetGradientThreshold(7.0);
  for (const int pieces : { 2, 5 })
  {
    EXPECT_EQ(StipplePieces(local, pieces), expected) << pieces << " pieces";
  }
  constexpr int parts = 3;
  const int levels = vtkInkStippleGenerator::GetGhostLevels(1.3);
  EXPECT_GT(levels, vtkInkStippleGenerator::GetGhostLevels(0.0));
  std::vector<Stipple> together;
  for (int part = 0; part < parts; ++part)
  {
    const auto producer = MakePart(Image, part, parts, levels);
    local->SetInputConnection(producer->GetOutputPort());
    local->UpdatePiece(part, parts, 0);
    const auto stipples = StipplesOf(local->GetOutput());
    together.insert(together.end(), stipples.begin(), stipples.end());
  }
  std::sort(together.begin(), together.end());
  EXPECT_EQ(together, expected) << "the whole from parts with " << levels << " ghost levels";
}

/// Of a reader that knows no pieces: the first process has all.
TEST_F(StippleGeneratorPieces, OfSeveralProcessesAreTheWhole)
{
  for (const int pieces : { 2, 4 })
  {
    std::vector<Stipple> byPercentile;
    std::vector<Stipple> byRanges;
    for (int piece = 0; piece < pieces; ++piece)
    {
      const auto asWhole = MakeGenerator();
      const auto asPiece = MakeLocalGenerator(Reference->GetOutput());
      for (vtkInkStippleGenerator* one : { asWhole.Get(), asPiece.Get() })
      {
        const auto pipeline = InkTestSerialPipeline(Image);
        one->SetInputConnection(pipeline->GetOutputPort());
        one->UpdatePiece(piece, pieces, 0);
        // Other filters of the same reader would find the whole there.
        EXPECT_EQ(pipeline->GetOutput()->GetNumberOfPoints() == 0, piece > 0)
          << "the reader not run on process " << piece;
        const auto stipples = StipplesOf(one->GetOutput());
        auto& all = one == asWhole ? byPercentile : byRanges;
        all.insert(all.end(), stipples.begin(), stipples.end());
      }
    }
    std::sort(byPercentile.begin(), byPercentile.end());
    std::sort(byRanges.begin(), byRanges.end());
    EXPECT_EQ(byPercentile, Whole) << "the whole from " << pieces
                                   << " processes by percentile: " << Whole.size() << " stipples, found "
                                   << byPercentile.size();
    EXPECT_EQ(byRanges, Expected) << "the whole from " << pieces
                                  << " processes by given ranges: " << Expected.size() << " stipples, found "
                                  << byRanges.size();
  }
}

/// By the percentile of all parts together, which no part knows.
TEST_F(StippleGeneratorPieces, ByThePercentileOfAllPartsAreTheWhole)
{
  for (const int parts : { 1, 2, 5 })
  {
    std::vector<vtkSmartPointer<vtkInkStippleGenerator>> generators;
    const auto statistics = std::make_shared<ink::stipple::VolumeStatistics>();
    for (int part = 0; part < parts; ++part)
    {
      const auto producer = MakePart(Image, part, parts, 5);
      generators.push_back(MakeGenerator());
      generators.back()->SetInputConnection(producer->GetOutputPort());
      vtkNew<vtkInformation> request;
      request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), part);
      request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), parts);
      EXPECT_TRUE(generators.back()->Measure(request, *statistics)) << "part " << part << " is measured";
    }
    EXPECT_EQ(statistics->magnitudes.count(), static_cast<std::uint64_t>(Image->GetNumberOfPoints()))
      << "each of " << Image->GetNumberOfPoints() << " points measured once";
    std::vector<Stipple> together;
    for (int part = 0; part < parts; ++part)
    {
      generators[static_cast<std::size_t>(part)]->SetStatistics(statistics);
      generators[static_cast<std::size_t>(part)]->UpdatePiece(part, parts, 0);
      const auto stipples = StipplesOf(generators[static_cast<std::size_t>(part)]->GetOutput());
      together.insert(together.end(), stipples.begin(), stipples.end());
    }
    std::sort(together.begin(), together.end());
    EXPECT_EQ(together, Whole) << "the whole from " << parts << " parts by their percentile: " << Whole.size()
                               << " stipples, found " << together.size();
  }
}
