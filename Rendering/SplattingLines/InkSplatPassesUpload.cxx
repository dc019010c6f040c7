// SPDX-License-Identifier: BSD-3-Clause
// What InkSplatPasses draws, on the GPU.
#include "InkSplatPasses.h"

#include "InkSplatPoints.h"

#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <vector>

namespace
{

/// Ids as shaders read them: in two numbers, as one of single precision has room for the first 16 million.
vtkSmartPointer<vtkFloatArray> SplitIds(vtkIdTypeArray* ids)
{
  constexpr int bits = 12;
  auto halves = vtkSmartPointer<vtkFloatArray>::New();
  halves->SetNumberOfComponents(2);
  halves->SetNumberOfTuples(ids->GetNumberOfTuples());
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    const vtkIdType id = ids->GetValue(i);
    halves->SetTypedComponent(i, 0, static_cast<float>(id & ((1 << bits) - 1)));
    halves->SetTypedComponent(i, 1, static_cast<float>(id >> bits));
  }
  return halves;
}

} // namespace

void InkSplatPasses::Upload(InkSplatPoints& points, vtkUnsignedCharArray* colors, vtkIdTypeArray* sources)
{
  // Appending, unlike caching, does not keep the arrays alive.
  this->Buffers->ClearAllVBOs();
  this->Buffers->AppendDataArray("pointMC", points.GetPositions(), VTK_FLOAT);
  this->Buffers->AppendDataArray("normalRadiusMC", points.GetNormalsAndRadii(), VTK_FLOAT);
  this->HasEdges = points.GetEdges()[0]->GetNumberOfTuples() > 0;
  if (this->HasEdges)
  {
    this->Buffers->AppendDataArray("firstEdgeMC", points.GetEdges()[0], VTK_FLOAT);
    this->Buffers->AppendDataArray("secondEdgeMC", points.GetEdges()[1], VTK_FLOAT);
  }
  if (colors)
  {
    this->Buffers->AppendDataArray("colorMC", colors, VTK_UNSIGNED_CHAR);
  }
  this->HasSources = sources != nullptr;
  const vtkSmartPointer<vtkFloatArray> halves = sources ? SplitIds(sources) : nullptr;
  if (halves)
  {
    this->Buffers->AppendDataArray("sourceId", halves, VTK_FLOAT);
  }
  this->Buffers->BuildAllVBOs(static_cast<vtkOpenGLVertexBufferObjectCache*>(nullptr));
  this->Buffers->Modified();
  this->NumberOfPoints = static_cast<int>(points.GetPositions()->GetNumberOfTuples());
  this->LargestRadius = points.GetLargestRadius();
  this->Bounds = points.GetBounds();
  this->Ordered = false;
}

vtkMTimeType InkSplatPasses::GetUploadTime() const
{
  return this->NumberOfPoints > 0 ? this->Buffers->GetMTime() : 0;
}

void InkSplatPasses::SetOrder(std::span<const std::uint32_t> order)
{
  this->Order->Upload(
    std::vector<std::uint32_t>(order.begin(), order.end()), vtkOpenGLBufferObject::ElementArrayBuffer);
  this->Ordered = true;
}
