// SPDX-License-Identifier: BSD-3-Clause
// What vtkInkStyle draws that need not be in memory as a whole.
#include "vtkInkStyle.h"

#include "InkImageSlabs.h"
#include "InkIsoSurface.h"
#include "InkMemoryBudget.h"
#include "InkParameter.h"
#include "vtkInkIsoSurfaceSampler.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"

#include <cstdint>
#include <optional>

std::string vtkInkStyle::TryDraw(vtkAlgorithmOutput* source)
{
  vtkAlgorithm* producer = source->GetProducer();
  producer->UpdateInformation();
  const bool isImage = vtkImageData::SafeDownCast(producer->GetOutputDataObject(source->GetIndex())) &&
    !vtkTrivialProducer::SafeDownCast(producer);
  if (isImage &&
    InkImageSlabs::GetBytes(producer->GetOutputInformation(source->GetIndex())) >
      InkMemoryBudget::OfMebibytes(this->MaximumMemory).ForWholeImage())
  {
    vtkNew<vtkInkIsoSurfaceSampler> sampler;
    sampler->SetInputConnection(source);
    sampler->SetMaximumMemory(this->MaximumMemory);
    const std::string problem = this->MakeMarks({ .Surfaces = sampler });
    this->Show();
    return problem;
  }
  const std::string problem = this->Follow(producer, "reading");
  return problem.empty() ? this->TryDraw(producer->GetOutputDataObject(source->GetIndex())) : problem;
}

bool vtkInkStyle::Draw(vtkAlgorithmOutput* source)
{
  return this->ReportProblem(this->TryDraw(source));
}

bool vtkInkStyle::DrawSurfaces(vtkInkIsoSurfaceAlgorithm* sampler)
{
  const std::string problem = this->MakeMarks({ .Surfaces = sampler });
  this->Show();
  return this->ReportProblem(problem);
}

std::string vtkInkStyle::MakePiecesOrSurfaces(const Input& input)
{
  if (!input.Surfaces)
  {
    const std::string problem = this->MakePieces(input);
    const bool isImage = vtkImageData::SafeDownCast(input.Data) != nullptr;
    return problem.empty() && isImage ? this->FindMemoryProblem(this->GetPiece(0)->GetNumberOfPoints())
                                      : problem;
  }
  InkIsoSurface* surface = this->GetSampledSurface();
  if (!surface)
  {
    return this->RefuseParts(input.Surfaces);
  }
  vtkNew<vtkPolyData> points;
  std::string problem = surface->SampleBy(this, input.Surfaces, points);
  problem = problem.empty() ? this->FindMemoryProblem(points->GetNumberOfPoints()) : problem;
  return problem.empty() && points->GetNumberOfPoints() > 0 ? this->MakePieces({ points }) : problem;
}

std::string vtkInkStyle::RefuseParts(vtkInkIsoSurfaceAlgorithm* sampler)
{
  const std::string needs = " needs the whole volume at once";
  const InkParameter* seeThrough = this->GetParameterTable().Find("SeeThrough");
  if (seeThrough && this->GetParameter(seeThrough->Name) != 0.0)
  {
    return seeThrough->Name + needs + ": expected it in memory, or one surface";
  }
  const InkParameter* colors = this->GetParameterTable().Find("ColorMap");
  if (colors && !this->GetParameterAsString(colors->Name).empty())
  {
    return colors->Name + needs + ": expected an image in memory, or no colors";
  }
  const std::string name = this->GetName();
  if (sampler->GetNumberOfInputPorts() == 0)
  {
    return name + needs + ": expected an image, or the style illustration";
  }
  vtkAlgorithmOutput* source = sampler->GetInputConnection(0, 0);
  const std::uint64_t bytes =
    InkImageSlabs::GetBytes(source->GetProducer()->GetOutputInformation(source->GetIndex()));
  return name + needs + ", " + InkFormatMemory(bytes) + ": expected MaximumMemory of " +
    InkFormatMemory(InkMemoryBudget::LimitFor(bytes, 2)) + " or more, or the style illustration";
}

std::string vtkInkStyle::FindMemoryProblem(vtkIdType points) const
{
  const std::uint64_t bytes = static_cast<std::uint64_t>(points) * InkBytesPerDrawnPoint;
  const std::uint64_t limit = InkMemoryBudget::OfMebibytes(this->MaximumMemory).Limit;
  return bytes <= limit
    ? std::string()
    : "the surface has " + std::to_string(points) + " points, which cannot be drawn in less than " +
      InkFormatMemory(bytes) + ": expected MaximumMemory of more than that, found " + InkFormatMemory(limit);
}

int vtkInkStyle::ParseMemory(const char* size)
{
  const std::optional<InkMemoryBudget> budget = InkMemoryBudget::Parse(size ? size : "");
  return budget ? budget->GetMebibytes() : 0;
}
