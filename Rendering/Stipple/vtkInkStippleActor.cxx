// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkStippleActor.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

namespace
{

bool HasVolumes(vtkProp* prop)
{
  vtkNew<vtkPropCollection> volumes;
  prop->GetVolumes(volumes);
  return volumes->GetNumberOfItems() > 0;
}

bool HasOthersTranslucent(vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    // Those of this kind would ask back.
    if (prop->GetVisibility() && !vtkInkStippleActor::SafeDownCast(prop) &&
      (HasVolumes(prop) || prop->HasTranslucentPolygonalGeometry()))
    {
      return true;
    }
  }
  return false;
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
    if (!renderer || HasOthersTranslucent(renderer))
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

int vtkInkStippleActor::RenderVolumetricGeometry(vtkViewport* viewport)
{
  if (this->HasTranslucentPolygonalGeometry())
  {
    return 0;
  }
  this->Drawing = true;
  const int rendered = this->Superclass::RenderTranslucentPolygonalGeometry(viewport);
  this->Drawing = false;
  return rendered;
}
