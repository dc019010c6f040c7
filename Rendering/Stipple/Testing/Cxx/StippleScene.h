// SPDX-License-Identifier: BSD-3-Clause
#ifndef StippleScene_h
#define StippleScene_h

#include "vtkInkStippleMapper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

/// Stipples in an off-screen window with a white background, seen along -z.
class StippleScene
{
public:
  explicit StippleScene(vtkPolyData* stipples, int width = 200, int height = 200)
  {
    this->Mapper->SetInputData(stipples);
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(width, height);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->ResetCamera();
  }

  /// No enhancement at all: N_max of each element's stipples.
  void AllOff()
  {
    this->Mapper->BoundaryOff();
    this->Mapper->SilhouetteOff();
    this->Mapper->ResolutionOff();
    this->Mapper->LightingOff();
    this->Mapper->DistanceOff();
    this->Mapper->InteriorOff();
  }

  vtkNew<vtkInkStippleMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

#endif
