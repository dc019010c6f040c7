// SPDX-License-Identifier: BSD-3-Clause
// The pieces of an image give, together, exactly the points of the whole: each once, with the same normal.

#include "InkTestPieces.h"
#include "SamplerTestImages.h"

#include "vtkDataSetAttributes.h"
#include "vtkExtentTranslator.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkNew.h"
#include "vtkRTAnalyticSource.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

namespace
{

const double IsoValue = 157.0;

vtkSmartPointer<vtkRTAnalyticSource> MakeSource()
{
  auto source = vtkSmartPointer<vtkRTAnalyticSource>::New();
  source->SetWholeExtent(-20, 17, -11, 20, -13, 14);
  return source;
}

/// All pieces' samples, sorted; how many each piece has goes to `sizes`.
std::vector<Sample> SamplePieces(
  vtkInkIsoSurfaceSampler* sampler, int pieces, int ghostLevels, std::vector<std::size_t>& sizes)
{
  std::vector<Sample> all;
  sizes.clear();
  for (int piece = 0; piece < pieces; ++piece)
  {
    sampler->UpdatePiece(piece, pieces, ghostLevels);
    const auto samples = SamplesOf(sampler->GetOutput());
    all.insert(all.end(), samples.begin(), samples.end());
    sizes.push_back(samples.size());
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// All of an image's samples, sorted.
std::vector<Sample> SampleWhole(vtkImageData* image)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetValue(0, IsoValue);
  sampler->SetInputData(image);
  std::vector<std::size_t> sizes;
  return SamplePieces(sampler, 1, 0, sizes);
}

} // namespace

TEST(IsoSurfaceSamplerPieces, OfASourceAndOfAnImageAreTheWhole)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetValue(0, IsoValue);
  const auto source = MakeSource();
  sampler->SetInputConnection(source->GetOutputPort());
  sampler->Update();
  auto whole = SamplesOf(sampler->GetOutput());
  std::sort(whole.begin(), whole.end());
  EXPECT_GT(whole.size(), 2000u) << "many points";
  EXPECT_EQ(std::adjacent_find(whole.begin(), whole.end()), whole.end()) << "no point twice";

  const auto source2 = MakeSource();
  source2->Update();
  vtkNew<vtkInkIsoSurfaceSampler> ofData;
  ofData->SetValue(0, IsoValue);
  ofData->SetInputData(source2->GetOutput());
  for (const int pieces : { 1, 2, 3, 4, 8 })
  {
    std::vector<std::size_t> sizes;
    for (const int ghostLevels : { 0, 1 })
    {
      const auto samples = SamplePieces(sampler, pieces, ghostLevels, sizes);
      EXPECT_EQ(samples, whole) << "the whole from " << pieces << " pieces of a source with " << ghostLevels
                                << " ghost levels: " << whole.size() << " points, found " << samples.size();
      EXPECT_TRUE(*std::max_element(sizes.begin(), sizes.end()) < whole.size() || pieces == 1)
        << "points in more than one piece";
    }
    const auto ofWhole = SamplePieces(ofData, pieces, 0, sizes);
    EXPECT_EQ(ofWhole, whole) << "the whole from " << pieces << " pieces of an image: " << whole.size()
                              << " points, found " << ofWhole.size();
  }
}

/// Of a reader that knows no pieces.
TEST(IsoSurfaceSamplerPieces, OfSeveralProcessesAreTheWhole)
{
  const auto source = MakeSource();
  source->Update();
  const auto whole = SampleWhole(source->GetOutput());
  for (const int pieces : { 2, 4 })
  {
    std::vector<Sample> ofProcesses;
    for (int piece = 0; piece < pieces; ++piece)
    {
      vtkNew<vtkInkIsoSurfaceSampler> one;
      one->SetValue(0, IsoValue);
      one->SetInputConnection(InkTestSerialPipeline(source->GetOutput())->GetOutputPort());
      one->UpdatePiece(piece, pieces, 0);
      const auto samples = SamplesOf(one->GetOutput());
      ofProcesses.insert(ofProcesses.end(), samples.begin(), samples.end());
    }
    std::sort(ofProcesses.begin(), ofProcesses.end());
    EXPECT_EQ(ofProcesses, whole) << "the whole from " << pieces << " processes: " << whole.size()
                                  << " points, found " << ofProcesses.size();
  }
}

/// In one process that asks a reader that knows no pieces for them in any order.
TEST(IsoSurfaceSamplerPieces, FromTheLastToTheFirstAreTheWhole)
{
  const auto source = MakeSource();
  source->Update();
  const auto whole = SampleWhole(source->GetOutput());
  for (const int pieces : { 2, 4 })
  {
    std::vector<Sample> ofOne;
    vtkNew<vtkInkIsoSurfaceSampler> one;
    one->SetValue(0, IsoValue);
    one->SetInputConnection(InkTestSerialPipeline(source->GetOutput())->GetOutputPort());
    for (int piece = pieces - 1; piece >= 0; --piece)
    {
      one->UpdatePiece(piece, pieces, 0);
      const auto samples = SamplesOf(one->GetOutput());
      ofOne.insert(ofOne.end(), samples.begin(), samples.end());
    }
    std::sort(ofOne.begin(), ofOne.end());
    EXPECT_EQ(ofOne, whole) << "the whole from " << pieces << " pieces, the last first: " << whole.size()
                            << " points, found " << ofOne.size();
  }
}

/// As a simulation hands them over: each process its own part with ghost cells, told of the whole extent.
TEST(IsoSurfaceSamplerPieces, OfPartsWithGhostCellsAreTheWhole)
{
  const auto source = MakeSource();
  source->Update();
  const auto whole = SampleWhole(source->GetOutput());
  const int pieces = 4;
  std::vector<Sample> together;
  for (int piece = 0; piece < pieces; ++piece)
  {
    int wholeExtent[6];
    source->GetOutput()->GetExtent(wholeExtent);
    vtkNew<vtkExtentTranslator> translator;
    int own[6];
    int grown[6];
    translator->PieceToExtentThreadSafe(
      piece, pieces, 0, wholeExtent, own, vtkExtentTranslator::BLOCK_MODE, 0);
    translator->PieceToExtentThreadSafe(
      piece, pieces, 1, wholeExtent, grown, vtkExtentTranslator::BLOCK_MODE, 0);
    vtkNew<vtkImageData> part;
    part->DeepCopy(source->GetOutput());
    part->Crop(grown);
    part->GenerateGhostArray(own);
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(part);
    producer->SetWholeExtent(wholeExtent);
    vtkNew<vtkInkIsoSurfaceSampler> ofPart;
    ofPart->SetValue(0, IsoValue);
    ofPart->SetInputConnection(producer->GetOutputPort());
    ofPart->UpdatePiece(piece, pieces, 0);
    const auto samples = SamplesOf(ofPart->GetOutput());
    together.insert(together.end(), samples.begin(), samples.end());
  }
  std::sort(together.begin(), together.end());
  EXPECT_EQ(together, whole) << "the whole from parts with ghost cells: " << whole.size() << " points, found "
                             << together.size();
}
