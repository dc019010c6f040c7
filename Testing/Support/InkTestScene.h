// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTestScene_h
#define InkTestScene_h

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

/// What a mapper draws of some data, in an off-screen window with a white background, seen along -z.
template <class MapperType>
class InkTestScene
{
public:
  explicit InkTestScene(vtkPolyData* data, int width = 200, int height = 200)
  {
    this->Mapper->SetInputData(data);
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(width, height);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->ResetCamera();
  }

  vtkNew<MapperType> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

#endif
