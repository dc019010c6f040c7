// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkIllustrationMapper.h"

#include "vtkInkSplattingLinesMapper.h"
#include "vtkInkStippleMapper.h"

#include "InkOpenGLCompat.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <initializer_list>

vtkStandardNewMacro(vtkInkIllustrationMapper);

vtkInkIllustrationMapper::vtkInkIllustrationMapper()
  : Lines(vtkSmartPointer<vtkInkSplattingLinesMapper>::New())
  , Stipples(vtkSmartPointer<vtkInkStippleMapper>::New())
{
}

vtkInkIllustrationMapper::~vtkInkIllustrationMapper() = default;

void vtkInkIllustrationMapper::SetMappers(vtkInkSplattingLinesMapper* lines, vtkInkStippleMapper* stipples)
{
  this->Lines = lines;
  this->Stipples = stipples;
  this->Modified();
}

void vtkInkIllustrationMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  for (vtkPolyDataMapper* mapper : std::initializer_list<vtkPolyDataMapper*>{ this->Lines, this->Stipples })
  {
    if (mapper->GetClippingPlanes() != this->GetClippingPlanes())
    {
      mapper->SetClippingPlanes(this->GetClippingPlanes());
    }
    if (this->LookupTable)
    {
      mapper->SetLookupTable(this->LookupTable);
      mapper->SetColorMode(this->ColorMode);
    }
  }
  if (this->Lines->GetInput())
  {
    this->Lines->RenderPiece(renderer, actor);
  }
  // Ids are those of the lines' points.
  if (!this->Stipples->GetInput() || renderer->GetSelector())
  {
    return;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    return;
  }
  // Dots are blended, also where they are drawn with what is opaque, and hide nothing.
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglDepthMask mask(state);
  state->vtkglDepthMask(GL_FALSE);
  this->Stipples->RenderPiece(renderer, actor);
}

void vtkInkIllustrationMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Lines->ReleaseGraphicsResources(window);
  this->Stipples->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

double* vtkInkIllustrationMapper::GetBounds()
{
  return this->Lines->GetBounds();
}

bool vtkInkIllustrationMapper::HasOpaqueGeometry()
{
  return this->Lines->HasOpaqueGeometry();
}

bool vtkInkIllustrationMapper::HasTranslucentPolygonalGeometry()
{
  return this->Lines->HasTranslucentPolygonalGeometry();
}

vtkMTimeType vtkInkIllustrationMapper::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->Lines->GetMTime(), this->Stipples->GetMTime() });
}

void vtkInkIllustrationMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lines: " << this->Lines.Get() << "\n";
  os << indent << "Stipples: " << this->Stipples.Get() << "\n";
}
