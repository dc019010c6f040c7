// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkBlendedActor.h"

#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkInkBlendedActor);

vtkInkBlendedActor::vtkInkBlendedActor() = default;

vtkInkBlendedActor::~vtkInkBlendedActor() = default;

void vtkInkBlendedActor::SetRenderer(vtkRenderer* renderer)
{
  this->Renderer = renderer;
}

bool vtkInkBlendedActor::IsBesideOthers()
{
  if (!this->Renderer)
  {
    return false;
  }
  vtkPropCollection* props = this->Renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    // Those of this kind would ask back.
    if (prop->GetVisibility() && !vtkInkBlendedActor::SafeDownCast(prop) &&
      prop->HasTranslucentPolygonalGeometry())
    {
      return true;
    }
  }
  return false;
}

vtkTypeBool vtkInkBlendedActor::HasTranslucentPolygonalGeometry()
{
  return this->Superclass::HasTranslucentPolygonalGeometry() && (this->Drawing || this->IsBesideOthers());
}

int vtkInkBlendedActor::RenderVolumetricGeometry(vtkViewport* viewport)
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
