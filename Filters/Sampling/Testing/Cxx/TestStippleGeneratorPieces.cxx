// SPDX-License-Identifier: BSD-3-Clause
// The pieces of an image give, together, exactly the stipples of the whole: each once, with the same arrays.

#include "InkTestChecks.h"
#include "SamplerTestImages.h"

#include "vtkCellData.h"
#include "vtkInkStippleGenerator.h"
#include "vtkNew.h"
#include "vtkRTAnalyticSource.h"

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

std::vector<Stipple> StipplePieces(vtkInkStippleGenerator* generator, int pieces, std::size_t& largest)
{
  std::vector<Stipple> all;
  largest = 0;
  for (int piece = 0; piece < pieces; ++piece)
  {
    generator->UpdatePiece(piece, pieces, 0);
    const auto stipples = StipplesOf(generator->GetOutput());
    all.insert(all.end(), stipples.begin(), stipples.end());
    largest = std::max(largest, stipples.size());
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
      std::size_t largest = 0;
      const auto stipples = StipplePieces(one, pieces, largest);
      check(stipples == whole, "the whole from ", pieces, " pieces: ", whole.size(), " stipples, found ",
        stipples.size());
      check(largest < whole.size(), "stipples in more than one piece");
    }
  }
  return check.Result();
}
