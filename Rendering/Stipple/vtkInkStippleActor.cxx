// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkStippleActor.h"

#include "InkHasVolumes.h"

#include "vtkCameraPass.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkLightsPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkOverlayPass.h"
#include "vtkPropCollection.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkTranslucentPass.h"

#include <utility>

namespace
{

bool HasOthersTranslucent(vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    // Those of this kind would ask back.
    if (prop->GetVisibility() && !vtkInkStippleActor::SafeDownCast(prop) &&
      (InkHasVolumes(prop) || prop->HasTranslucentPolygonalGeometry()))
    {
      return true;
    }
  }
  return false;
}

/// Whether no pass of a chain draws volumes; false where there are passes of other libraries, which may.
bool LacksVolumetricPass(vtkRenderPass* pass)
{
  if (auto* sequence = vtkSequencePass::SafeDownCast(pass))
  {
    vtkRenderPassCollection* passes = sequence->GetPasses();
    vtkCollectionSimpleIterator cookie;
    passes->InitTraversal(cookie);
    while (vtkRenderPass* one = passes->GetNextRenderPass(cookie))
    {
      if (!LacksVolumetricPass(one))
      {
        return false;
      }
    }
    return true;
  }
  if (auto* camera = vtkCameraPass::SafeDownCast(pass))
  {
    return LacksVolumetricPass(camera->GetDelegatePass());
  }
  if (auto* processing = vtkImageProcessingPass::SafeDownCast(pass))
  {
    return LacksVolumetricPass(processing->GetDelegatePass());
  }
  if (auto* peeling = vtkDualDepthPeelingPass::SafeDownCast(pass))
  {
    return LacksVolumetricPass(peeling->GetVolumetricPass());
  }
  return !pass || vtkOpaquePass::SafeDownCast(pass) || vtkTranslucentPass::SafeDownCast(pass) ||
    vtkDepthPeelingPass::SafeDownCast(pass) || vtkOrderIndependentTranslucentPass::SafeDownCast(pass) ||
    vtkOverlayPass::SafeDownCast(pass) || vtkLightsPass::SafeDownCast(pass);
}

vtkRenderPass* FindChain(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  return renderer ? renderer->GetPass() : nullptr;
}

} // namespace

vtkStandardNewMacro(vtkInkStippleActor);

vtkInkStippleActor::vtkInkStippleActor() = default;

vtkInkStippleActor::~vtkInkStippleActor() = default;

bool vtkInkStippleActor::IsAlone()
{
  // An assembly with this actor as a part asks its parts.
  if (this->Asking)
  {
    return false;
  }
  this->Asking = true;
  const bool alone = this->FindAlone();
  this->Asking = false;
  return alone;
}

bool vtkInkStippleActor::FindAlone()
{
  // In an assembly, whose renderers it does not know, it is like any actor.
  const int count = this->GetNumberOfConsumers();
  for (int i = 0; i < count; ++i)
  {
    auto* renderer = vtkRenderer::SafeDownCast(this->GetConsumer(i));
    if (!renderer || HasOthersTranslucent(renderer) ||
      (renderer->GetPass() && LacksVolumetricPass(renderer->GetPass())))
    {
      return false;
    }
  }
  return count > 0;
}

vtkTypeBool vtkInkStippleActor::HasTranslucentPolygonalGeometry()
{
  return this->Superclass::HasTranslucentPolygonalGeometry() && (this->Drawing || !this->IsAlone());
}

int vtkInkStippleActor::RenderTranslucentPolygonalGeometry(vtkViewport* viewport)
{
  // A chain that comes here may have no pass for volumes.
  this->DrawnBy = FindChain(viewport);
  return this->DrawnBy ? this->Draw(viewport)
                       : this->Superclass::RenderTranslucentPolygonalGeometry(viewport);
}

int vtkInkStippleActor::RenderVolumetricGeometry(vtkViewport* viewport)
{
  vtkRenderPass* const drawnBy = std::exchange(this->DrawnBy, nullptr);
  if ((drawnBy && drawnBy == FindChain(viewport)) || this->HasTranslucentPolygonalGeometry())
  {
    return 0;
  }
  return this->Draw(viewport);
}

int vtkInkStippleActor::Draw(vtkViewport* viewport)
{
  this->Drawing = true;
  const int rendered = this->Superclass::RenderTranslucentPolygonalGeometry(viewport);
  this->Drawing = false;
  return rendered;
}
