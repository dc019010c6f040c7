// SPDX-License-Identifier: BSD-3-Clause
#include "InkViewUniforms.h"

#include "InkShader.h"
#include "InkShiftScale.h"

#include "vtkAbstractMapper.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace
{

std::array<float, 16> ToColumns(vtkMatrix4x4* matrix)
{
  std::array<float, 16> columns;
  for (int i = 0; i < 16; ++i)
  {
    columns[i] = static_cast<float>(matrix->GetElement(i % 4, i / 4));
  }
  return columns;
}

} // namespace

InkViewUniforms::InkViewUniforms(vtkRenderer* renderer, vtkActor* actor, vtkAbstractMapper* mapper,
  const InkShiftScale& frame, const int size[2])
  : Size{ size[0], size[1] }
{
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkMatrix4x4* worldToView = camera->GetModelViewTransformMatrix();
  vtkMatrix4x4* viewToClip = camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0);

  vtkNew<vtkMatrix4x4> pointsToModel;
  for (int axis = 0; axis < 3; ++axis)
  {
    pointsToModel->SetElement(axis, axis, frame.Unit);
    pointsToModel->SetElement(axis, 3, frame.Center[axis]);
  }
  vtkNew<vtkMatrix4x4> modelToWorld;
  actor->GetModelToWorldMatrix(modelToWorld);
  vtkNew<vtkMatrix4x4> pointsToView;
  vtkMatrix4x4::Multiply4x4(modelToWorld, pointsToModel, pointsToView);
  vtkMatrix4x4::Multiply4x4(worldToView, pointsToView, pointsToView);
  this->MCVC = ToColumns(pointsToView);
  this->VCDC = ToColumns(viewToClip);

  // A common factor does not matter to normals; without one tiny or huge scales would leave float's range.
  this->Unit = static_cast<float>(std::cbrt(std::abs(pointsToView->Determinant())));
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(pointsToView, inverse);
  for (int i = 0; i < 9; ++i)
  {
    this->Normal[i] = static_cast<float>(inverse->GetElement(i / 3, i % 3) * this->Unit);
  }

  const bool parallel = viewToClip->GetElement(3, 2) == 0.0;
  this->Eye = parallel ? std::array<float, 4>{ 0.0f, 0.0f, 1.0f, 0.0f }
                       : std::array<float, 4>{ 0.0f, 0.0f, 0.0f, 1.0f };
  const double* range = camera->GetClippingRange();
  this->DepthRange = { static_cast<float>(range[0]), static_cast<float>(range[1]) };
  for (int i = 0; i < 4; ++i)
  {
    this->DepthToClip[i] = static_cast<float>(viewToClip->GetElement(2 + i / 2, 2 + i % 2));
  }
  this->Pixel = static_cast<float>(2.0 / (size[1] * std::abs(viewToClip->GetElement(1, 1))));
  int tile[2];
  renderer->GetTiledSize(&tile[0], &tile[1]);
  // A render pass may draw with more pixels than the renderer has.
  const double finer = static_cast<double>(size[1]) / std::max(tile[1], 1);
  this->PictureHeight = static_cast<int>(std::lround(finer * renderer->GetSize()[1]));
  this->TileScale = renderer->GetRenderWindow()->GetTileScale()[1];
  this->BackFaces = !actor->GetProperty()->GetBackfaceCulling();

  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    vtkNew<vtkMatrix4x4> viewToWorld;
    vtkMatrix4x4::Invert(worldToView, viewToWorld);
    this->NumberOfClippingPlanes = std::min(planes->GetNumberOfItems(), MaximumClippingPlanes);
    for (int i = 0; i < this->NumberOfClippingPlanes; ++i)
    {
      double normal[3];
      double origin[3];
      planes->GetItem(i)->GetNormal(normal);
      planes->GetItem(i)->GetOrigin(origin);
      const double offset = -(normal[0] * origin[0] + normal[1] * origin[1] + normal[2] * origin[2]);
      const double plane[4] = { normal[0], normal[1], normal[2], offset };
      for (int column = 0; column < 4; ++column)
      {
        double sum = 0.0;
        for (int row = 0; row < 4; ++row)
        {
          sum += plane[row] * viewToWorld->GetElement(row, column);
        }
        this->ClippingPlanes[4 * i + column] = static_cast<float>(sum);
      }
    }
  }
}

void InkViewUniforms::Widen(int margin)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    const int wider = this->Size[axis] + 2 * margin;
    for (int column = 0; column < 4; ++column)
    {
      this->VCDC[4 * column + axis] *= static_cast<float>(this->Size[axis]) / static_cast<float>(wider);
    }
    this->Size[axis] = wider;
  }
  this->Margin += margin;
}

void InkViewUniforms::Refine(int factor)
{
  this->Size = { factor * this->Size[0], factor * this->Size[1] };
  this->Margin *= factor;
  this->PictureHeight *= factor;
  this->Pixel /= static_cast<float>(factor);
}

std::string InkViewUniforms::FindFeatures() const
{
  return this->NumberOfClippingPlanes > 0
    ? InkDefine("INK_PLANES", static_cast<std::size_t>(this->NumberOfClippingPlanes))
    : "";
}

void InkViewUniforms::SetUniforms(vtkShaderProgram* program) const
{
  // vtkShaderProgram takes matrices as pointers to values that it does not change.
  auto* mcvc = const_cast<float*>(this->MCVC.data());
  auto* normal = const_cast<float*>(this->Normal.data());
  auto* vcdc = const_cast<float*>(this->VCDC.data());
  program->SetUniformMatrix4x4("MCVCMatrix", mcvc);
  program->SetUniformMatrix3x3("normalMatrix", normal);
  program->SetUniformMatrix4x4("VCDCMatrix", vcdc);
  program->SetUniform4f("eyeVC", this->Eye.data());
  const float size[2] = { static_cast<float>(this->Size[0]), static_cast<float>(this->Size[1]) };
  program->SetUniform2f("viewportSize", size);
  program->SetUniformi("backFaces", this->BackFaces);
  program->SetUniformf("unitVC", this->Unit);
  program->SetUniformf("pixelVC", this->Pixel);
  program->SetUniform2f("depthRange", this->DepthRange.data());
  program->SetUniform4f("depthToClip", this->DepthToClip.data());
  if (this->NumberOfClippingPlanes > 0)
  {
    program->SetUniform4fv("clipPlanesVC", this->NumberOfClippingPlanes, this->ClippingPlanes.data());
  }
}
