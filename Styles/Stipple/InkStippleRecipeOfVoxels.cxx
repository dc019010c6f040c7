// SPDX-License-Identifier: BSD-3-Clause
// Stipples of images' voxels.
#include "InkActiveScalars.h"
#include "InkChangedGenerator.h"
#include "InkIsoSurface.h"
#include "InkLeaves.h"
#include "InkLongestSide.h"
#include "InkSilhouettes.h"
#include "InkStippleRecipe.h"
#include "InkStyleProcesses.h"

#include "Stippling/StippledVoxels.h"
#include "Stippling/VolumeStipples.h"
#include "Tone/Stipple/ProjectedSize.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace
{

/// Of images of all processes, as many stipples a voxel as it measures pixels in a picture of them all.
int ProjectedListLength(const std::vector<vtkImageData*>& images, double pixels, InkStyleProcesses& processes)
{
  double edge = 0.0;
  for (vtkImageData* image : images)
  {
    const double* steps = image->GetSpacing();
    edge = std::max(edge, std::cbrt(std::abs(steps[0] * steps[1] * steps[2])));
  }
  processes.TakeGreatest({ &edge, 1 });
  // Bounds end at the middles of the outermost voxels.
  const double longest = InkLongestSide(images, processes) + edge;
  return ink::stipple::projectedListLength(static_cast<float>(edge / longest),
    static_cast<float>(1.0 / pixels), ink::stipple::maximumStipplesPerVoxel);
}

} // namespace

/// What images come from: a port that delivers parts of one, or nowhere, being whole.
struct InkStippleRecipe::Source
{
  vtkAlgorithmOutput* Port; ///< null: nowhere
  vtkInformation* Update;   ///< of parts: which

  void Connect(vtkInkStippleGenerator* generator, vtkImageData* image) const
  {
    if (this->Port)
    {
      generator->SetInputConnection(this->Port);
    }
    else
    {
      generator->SetInputData(image);
    }
  }
};

void InkStippleRecipe::SetUp(InkIsoSurface& isoSurface) const
{
  const vtkInkStippleStyle* style = this->Style;
  isoSurface.CopyParameters(*style->IsoSurface);
  // A panel always has an iso-value, which counts where its surface is.
  if (!this->Style->GetInteractive())
  {
    isoSurface.SetIsoValues(style->IsoSurface->GetIsoValues());
  }
}

void InkStippleRecipe::OutlineVoxels(const InkLeaves& leaves)
{
  vtkInkStippleStyle* style = this->Style;
  if (style->Silhouettes->GetMethod()->NeedsVoxels())
  {
    this->OutlineImages(leaves, *style->IsoSurface);
  }
  else if (style->Silhouettes->GetSilhouettes())
  {
    // They are those of a surface, though no surface is stippled.
    InkIsoSurface isoSurface;
    this->SetUp(isoSurface);
    const std::string problem = isoSurface.Prepare(style, leaves.Images);
    if (problem.empty())
    {
      this->OutlineImages(leaves, isoSurface);
    }
    else
    {
      style->AddNote("there are no silhouettes: " + problem);
    }
  }
}

std::vector<vtkImageData*> InkStippleRecipe::MeasureImages(const InkLeaves& leaves, const Source& source)
{
  vtkInkStippleGenerator* generator = this->Generator;
  if (generator->GetThresholdMode() != vtkInkStippleGenerator::PERCENTILE &&
    generator->GetUseReferenceRanges())
  {
    return leaves.Images;
  }
  const auto statistics = std::make_shared<ink::stipple::VolumeStatistics>();
  std::vector<vtkImageData*> measured;
  for (vtkImageData* image : leaves.Images)
  {
    source.Connect(generator, image);
    bool done = true;
    this->Say(this->Style->Follow(
      generator, "measuring gradients", [&] { done = generator->Measure(source.Update, *statistics); }));
    if (done)
    {
      measured.push_back(image);
    }
  }
  this->Style->GetProcesses().AddUp(*statistics);
  generator->SetStatistics(statistics);
  return measured;
}

void InkStippleRecipe::StippleVoxels(const InkLeaves& leaves, const vtkInkStyle::Input& input)
{
  vtkInkStippleStyle* style = this->Style;
  vtkInkStippleGenerator* generator = this->Generator;
  const InkChangedGenerator changed(generator);
  this->OutlineVoxels(leaves);
  // Nor is smoothing chosen unasked for data that comes from a port, whose stipples are the filter's.
  const double smoothing = style->IsoSurface->GetSmoothing();
  generator->SetSmoothing(
    input.Port ? std::max(smoothing, 0.0) : style->IsoSurface->ChooseSmoothing(style, leaves.Images));
  // The leaves of composite data are whole images, and so is an image that comes from nowhere.
  vtkNew<vtkInformation> whole;
  const bool parts = input.Port && !leaves.Composite;
  const Source source{ parts ? input.Port : nullptr, parts && input.Request ? input.Request : whole.Get() };
  InkSelectScalars(generator, source.Port ? style->IsoSurface->GetScalars() : std::string());

  // One whole image is measured when it is stippled; parts and several images are, too, together.
  const bool together = parts || leaves.Composite;
  if (together && generator->GetMaximumStipplesMode() == vtkInkStippleGenerator::PROJECTED)
  {
    generator->SetMaximumStipplesModeToFixed();
    generator->SetMaximumStipples(
      ProjectedListLength(leaves.Images, generator->GetPictureSize(), style->GetProcesses()));
  }
  const std::vector<vtkImageData*> images = together ? this->MeasureImages(leaves, source) : leaves.Images;
  std::vector<vtkSmartPointer<vtkPolyData>> stipples;
  for (vtkImageData* image : images)
  {
    source.Connect(generator, image);
    this->TakeColors(image, false);
    this->Say(style->Follow(generator, "placing stipples", [&] { generator->Update(source.Update); }));
    if (generator->GetOutput()->GetNumberOfPoints() > 0)
    {
      stipples.push_back(vtkSmartPointer<vtkPolyData>::New());
      stipples.back()->ShallowCopy(generator->GetOutput());
    }
  }
  style->GetPiece(vtkInkStippleStyle::STIPPLES)->ShallowCopy(InkAppend(stipples));
  // That of the surface which other styles draw.
  InkIsoSurface isoSurface;
  this->SetUp(isoSurface);
  isoSurface.TakeFrame(style, input, leaves.Images, false);
}
