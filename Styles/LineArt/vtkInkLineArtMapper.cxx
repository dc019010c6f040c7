// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkLineArtMapper.h"

#include "InkDrawingProgress.h"
#include "vtkInkSilhouetteMapper.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <initializer_list>

vtkStandardNewMacro(vtkInkLineArtMapper);

namespace
{

/// Of a picture's time, about.
constexpr double StrokesEnd = 0.6;

} // namespace

vtkInkLineArtMapper::vtkInkLineArtMapper()
  : Strokes(vtkSmartPointer<vtkInkStrokeMapper>::New())
  , Contours(vtkSmartPointer<vtkInkSilhouetteMapper>::New())
{
}

vtkInkLineArtMapper::~vtkInkLineArtMapper() = default;

void vtkInkLineArtMapper::SetMappers(vtkInkStrokeMapper* strokes, vtkInkSilhouetteMapper* contours)
{
  this->Strokes = strokes;
  this->Contours = contours;
  // They lie on one surface.
  strokes->ShareSurface(contours);
  this->Modified();
}

void vtkInkLineArtMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  for (vtkInkStrokeMapper* mapper :
    std::initializer_list<vtkInkStrokeMapper*>{ this->Strokes, this->Contours })
  {
    if (mapper->GetClippingPlanes() != this->GetClippingPlanes())
    {
      mapper->SetClippingPlanes(this->GetClippingPlanes());
    }
    const bool chosen = mapper == this->Contours || !renderer->GetSelector();
    if (mapper->GetInput() && chosen)
    {
      const bool isFirst = mapper == this->Strokes;
      const InkProgressPart part(this, mapper, isFirst ? 0.0 : StrokesEnd, isFirst ? StrokesEnd : 1.0);
      mapper->RenderPiece(renderer, actor);
    }
  }
}

void vtkInkLineArtMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Strokes->ReleaseGraphicsResources(window);
  this->Contours->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

double* vtkInkLineArtMapper::GetBounds()
{
  // Hatching lies on the surface.
  const double* bounds = this->Contours->GetBounds();
  if (bounds)
  {
    std::copy_n(bounds, 6, this->Bounds);
  }
  else
  {
    vtkMath::UninitializeBounds(this->Bounds);
  }
  return this->Bounds;
}

vtkMTimeType vtkInkLineArtMapper::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->Strokes->GetMTime(), this->Contours->GetMTime() });
}

void vtkInkLineArtMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Strokes: " << this->Strokes.Get() << "\n";
  os << indent << "Contours: " << this->Contours.Get() << "\n";
}
