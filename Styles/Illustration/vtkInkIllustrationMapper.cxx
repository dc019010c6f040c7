// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkIllustrationMapper.h"

#include "vtkInkSplattingLinesMapper.h"
#include "vtkInkStippleMapper.h"

#include "InkDrawingProgress.h"
#include "InkOpenGLCompat.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <initializer_list>

vtkStandardNewMacro(vtkInkIllustrationMapper);

namespace
{

/// Light from the viewer takes stipples away but for those of the outer surface's rim: fewer are left with a
/// smaller exponent.
constexpr double RimExponent = 0.35;

/// Parts of a picture's time, about.
constexpr double LinesShare = 0.7; ///< of lines and stipples
constexpr double InnerEnds = 0.5;

/// Dots are blended, also where they are drawn with what is opaque, and hide nothing.
void RenderStipples(vtkInkStippleMapper* stipples, vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || !stipples->GetInput())
  {
    return;
  }
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglDepthMask mask(state);
  state->vtkglDepthMask(GL_FALSE);
  stipples->RenderPiece(renderer, actor);
}

} // namespace

vtkInkIllustrationMapper::vtkInkIllustrationMapper()
  : Lines(vtkSmartPointer<vtkInkSplattingLinesMapper>::New())
  , Stipples(vtkSmartPointer<vtkInkStippleMapper>::New())
  , OuterLines(vtkSmartPointer<vtkInkSplattingLinesMapper>::New())
  , OuterStipples(vtkSmartPointer<vtkInkStippleMapper>::New())
{
}

vtkInkIllustrationMapper::~vtkInkIllustrationMapper() = default;

void vtkInkIllustrationMapper::SetMappers(vtkInkSplattingLinesMapper* lines, vtkInkStippleMapper* stipples)
{
  this->Lines = lines;
  this->Stipples = stipples;
  this->Modified();
}

void vtkInkIllustrationMapper::SetOuterMappers(
  vtkInkSplattingLinesMapper* lines, vtkInkStippleMapper* stipples)
{
  this->OuterLines = lines;
  this->OuterStipples = stipples;
  this->Modified();
}

bool vtkInkIllustrationMapper::HasOuter()
{
  vtkPolyData* points = this->OuterLines->GetInput();
  return points && points->GetNumberOfPoints() > 0;
}

void vtkInkIllustrationMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  for (vtkPolyDataMapper* mapper : std::initializer_list<vtkPolyDataMapper*>{
         this->Lines, this->Stipples, this->OuterLines, this->OuterStipples })
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
  // An actor is drawn once with what is opaque and once with what is translucent, if it has both.
  const bool isTranslucentPass = actor->IsRenderingTranslucentPolygonalGeometry();
  if (!isTranslucentPass || !actor->HasOpaqueGeometry())
  {
    this->RenderInner(renderer, actor);
  }
  // Ids are those of the inner lines' points.
  if (!renderer->GetSelector() && this->HasOuter() &&
    (isTranslucentPass || !actor->HasTranslucentPolygonalGeometry()))
  {
    this->RenderOuter(renderer, actor);
  }
}

void vtkInkIllustrationMapper::RenderInner(vtkRenderer* renderer, vtkActor* actor)
{
  const double end = this->HasOuter() ? InnerEnds : 1.0;
  if (this->Lines->GetInput())
  {
    const InkProgressPart part(this, this->Lines, 0.0, LinesShare * end);
    this->Lines->RenderPiece(renderer, actor);
  }
  if (!renderer->GetSelector())
  {
    const InkProgressPart part(this, this->Stipples, LinesShare * end, end);
    RenderStipples(this->Stipples, renderer, actor);
  }
}

void vtkInkIllustrationMapper::RenderOuter(vtkRenderer* renderer, vtkActor* actor)
{
  this->UpdateOuter(actor);
  const double linesEnd = InnerEnds + LinesShare * (1.0 - InnerEnds);
  const InkProgressPart lines(this, this->OuterLines, InnerEnds, linesEnd);
  this->OuterLines->RenderPiece(renderer, actor);
  const InkProgressPart stipples(this, this->OuterStipples, linesEnd, 1.0);
  RenderStipples(this->OuterStipples, renderer, this->OuterActor);
}

void vtkInkIllustrationMapper::UpdateOuter(vtkActor* actor)
{
  vtkInkSplattingLinesMapper* lines = this->OuterLines;
  lines->SetLambda(this->Lines->GetLambda());
  lines->SetTau(this->Lines->GetTau());
  lines->SetPhi(this->Lines->GetPhi());
  lines->SetMinimumRadius(this->Lines->GetMinimumRadius());
  lines->SetHardness(this->Lines->GetHardness());
  lines->SetSpeckleLength(this->Lines->GetSpeckleLength());
  lines->SetMaximumDownsampling(this->Lines->GetMaximumDownsampling());
  lines->SetPointFraction(this->Lines->GetPointFraction());
  lines->SetLayerLineWidth(0, this->Lines->GetLayerLineWidth(0));
  lines->SetInkColor(this->OuterInkColor);
  lines->SetLayerStrength(0, this->OuterStrength);
  lines->SetPaperVisibility(false);

  vtkInkStippleMapper* stipples = this->OuterStipples;
  stipples->SetSizeUnit(this->Stipples->GetSizeUnit());
  stipples->SetStippleSize(this->Stipples->GetStippleSize());
  stipples->SetPixelsPerStipple(this->Stipples->GetPixelsPerStipple());
  stipples->SetDistanceExponent(this->Stipples->GetDistanceExponent());
  stipples->SetDistanceSize(this->Stipples->GetDistanceSize());
  stipples->SetInkColor(this->OuterInkColor);
  stipples->SetHeadlight(true);
  stipples->SetLightingExponent(RimExponent);

  this->OuterActor->ShallowCopy(actor);
  // Which it is drawn by, and owned by.
  this->OuterActor->SetMapper(nullptr);
  this->OuterActor->SetPropertyKeys(actor->GetPropertyKeys());
  vtkNew<vtkProperty> property;
  property->DeepCopy(actor->GetProperty());
  property->SetOpacity(this->OuterStrength * property->GetOpacity());
  this->OuterActor->SetProperty(property);
}

void vtkInkIllustrationMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Lines->ReleaseGraphicsResources(window);
  this->Stipples->ReleaseGraphicsResources(window);
  this->OuterLines->ReleaseGraphicsResources(window);
  this->OuterStipples->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

double* vtkInkIllustrationMapper::GetBounds()
{
  vtkBoundingBox box;
  box.AddBounds(this->Lines->GetBounds());
  if (this->HasOuter())
  {
    box.AddBounds(this->OuterLines->GetBounds());
  }
  if (box.IsValid())
  {
    box.GetBounds(this->Bounds);
  }
  else
  {
    vtkMath::UninitializeBounds(this->Bounds);
  }
  return this->Bounds;
}

bool vtkInkIllustrationMapper::HasOpaqueGeometry()
{
  return this->Lines->HasOpaqueGeometry();
}

bool vtkInkIllustrationMapper::HasTranslucentPolygonalGeometry()
{
  return this->Lines->HasTranslucentPolygonalGeometry() || this->HasOuter();
}

vtkMTimeType vtkInkIllustrationMapper::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->Lines->GetMTime(), this->Stipples->GetMTime(),
    this->OuterLines->GetMTime(), this->OuterStipples->GetMTime() });
}

void vtkInkIllustrationMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Lines: " << this->Lines.Get() << "\n";
  os << indent << "Stipples: " << this->Stipples.Get() << "\n";
  os << indent << "OuterLines: " << this->OuterLines.Get() << "\n";
  os << indent << "OuterStipples: " << this->OuterStipples.Get() << "\n";
  os << indent << "OuterInkColor: " << this->OuterInkColor[0] << ' ' << this->OuterInkColor[1] << ' '
     << this->OuterInkColor[2] << "\n";
  os << indent << "OuterStrength: " << this->OuterStrength << "\n";
}
