// SPDX-License-Identifier: BSD-3-Clause
// The pieces of an image, or parts of it with ghost cells, give together exactly the stipples of the whole:
// each once, with the same arrays.

#include "InkTestChecks.h"
#include "InkTestPieces.h"
#include "SamplerTestImages.h"
#include "Sampling/StippledVoxels.h"

#include "vtkCellData.h"
#include "vtkExtentTranslator.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInkStippleGenerator.h"
#include "vtkNew.h"
#include "vtkRTAnalyticSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include <memory>

namespace
{

const int PerVoxel = 4;

/// A stipple as its place, its element's normal and the two numbers.
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

} // namespace

int TestStippleGeneratorPieces(int, char*[])
{
  InkTestChecks check;
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(-20, 17, -11, 20, -13, 14);
  const auto generator = MakeGenerator();
  generator->SetInputConnection(source->GetOutputPort());
  generator->Update();
  auto whole = StipplesOf(generator->GetOutput());
  std::sort(whole.begin(), whole.end());
  check(whole.size() > 20000, "many stipples, found ", whole.size());

  source->Update();
  vtkNew<vtkImageData> image;
  image->DeepCopy(source->GetOutput());
  const auto ofData = MakeGenerator();
  ofData->SetInputData(image);
  for (const int pieces : { 2, 3, 4, 8 })
  {
    for (vtkInkStippleGenerator* one : { generator.Get(), ofData.Get() })
    {
      const auto stipples = StipplePieces(one, pieces);
      check(stipples == whole, "the whole from ", pieces, " pieces: ", whole.size(), " stipples, found ",
        stipples.size());
    }
  }

  const auto reference = MakeGenerator();
  reference->SetThresholdModeToMagnitude();
  reference->SetGradientThreshold(10.0);
  reference->SetInputData(image);
  reference->Update();
  auto expected = StipplesOf(reference->GetOutput());
  std::sort(expected.begin(), expected.end());
  check(expected.size() > 1000, "stipples beyond a threshold, found ", expected.size());
  const auto local = MakeLocalGenerator(reference->GetOutput());
  local->SetInputConnection(source->GetOutputPort());
  const auto localOfData = MakeLocalGenerator(reference->GetOutput());
  localOfData->SetInputData(image);
  for (const int pieces : { 1, 2, 5, 8 })
  {
    for (vtkInkStippleGenerator* one : { local.Get(), localOfData.Get() })
    {
      const auto stipples = StipplePieces(one, pieces);
      check(stipples == expected, "the whole from ", pieces, " pieces by given ranges: ", expected.size(),
        " stipples, found ", stipples.size());
    }
    std::vector<Stipple> together;
    for (int part = 0; part < pieces; ++part)
    {
      const auto producer = MakePart(image, part, pieces, 5);
      const auto ofPart = MakeLocalGenerator(reference->GetOutput());
      ofPart->SetInputConnection(producer->GetOutputPort());
      ofPart->UpdatePiece(part, pieces, 0);
      const auto stipples = StipplesOf(ofPart->GetOutput());
      together.insert(together.end(), stipples.begin(), stipples.end());
    }
    std::sort(together.begin(), together.end());
    check(together == expected, "the whole from ", pieces, " parts with ghost cells: ", expected.size(),
      " stipples, found ", together.size());
  }

  // A reader that knows no pieces, on several processes: the first one has all.
  for (const int pieces : { 2, 4 })
  {
    std::vector<Stipple> byPercentile;
    std::vector<Stipple> byRanges;
    for (int piece = 0; piece < pieces; ++piece)
    {
      const auto asWhole = MakeGenerator();
      const auto asPiece = MakeLocalGenerator(reference->GetOutput());
      for (vtkInkStippleGenerator* one : { asWhole.Get(), asPiece.Get() })
      {
        const auto pipeline = InkTestSerialPipeline(image);
        one->SetInputConnection(pipeline->GetOutputPort());
        one->UpdatePiece(piece, pieces, 0);
        // Other filters of the same reader would find the whole there.
        check((pipeline->GetOutput()->GetNumberOfPoints() == 0) == (piece > 0),
          "the reader not run on process ", piece);
        const auto stipples = StipplesOf(one->GetOutput());
        auto& all = one == asWhole ? byPercentile : byRanges;
        all.insert(all.end(), stipples.begin(), stipples.end());
      }
    }
    std::sort(byPercentile.begin(), byPercentile.end());
    std::sort(byRanges.begin(), byRanges.end());
    check(byPercentile == whole, "the whole from ", pieces, " processes by percentile: ", whole.size(),
      " stipples, found ", byPercentile.size());
    check(byRanges == expected, "the whole from ", pieces, " processes by given ranges: ", expected.size(),
      " stipples, found ", byRanges.size());
  }

  // By the percentile of all parts together, which no part knows.
  for (const int parts : { 1, 2, 5 })
  {
    std::vector<vtkSmartPointer<vtkInkStippleGenerator>> generators;
    const auto statistics = std::make_shared<ink::VolumeStatistics>();
    for (int part = 0; part < parts; ++part)
    {
      const auto producer = MakePart(image, part, parts, 5);
      generators.push_back(MakeGenerator());
      generators.back()->SetInputConnection(producer->GetOutputPort());
      vtkNew<vtkInformation> request;
      request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), part);
      request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), parts);
      check(generators.back()->Measure(request, *statistics), "part ", part, " is measured");
    }
    check(statistics->magnitudes.count() == static_cast<std::uint64_t>(image->GetNumberOfPoints()),
      "each of ", image->GetNumberOfPoints(), " points measured once, found ",
      statistics->magnitudes.count());
    std::vector<Stipple> together;
    for (int part = 0; part < parts; ++part)
    {
      generators[static_cast<std::size_t>(part)]->SetStatistics(statistics);
      generators[static_cast<std::size_t>(part)]->UpdatePiece(part, parts, 0);
      const auto stipples = StipplesOf(generators[static_cast<std::size_t>(part)]->GetOutput());
      together.insert(together.end(), stipples.begin(), stipples.end());
    }
    std::sort(together.begin(), together.end());
    check(together == whole, "the whole from ", parts, " parts by their percentile: ", whole.size(),
      " stipples, found ", together.size());
  }
  return check.Result();
}
