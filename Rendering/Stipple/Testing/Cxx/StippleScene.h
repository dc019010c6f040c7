// SPDX-License-Identifier: BSD-3-Clause
#ifndef StippleScene_h
#define StippleScene_h

#include "InkTestScene.h"
#include "vtkInkStippleMapper.h"

class StippleScene : public InkTestScene<vtkInkStippleMapper>
{
public:
  /// With sizes in pixels.
  explicit StippleScene(vtkPolyData* data, int width = 200, int height = 200)
    : InkTestScene(data, width, height)
  {
    this->Mapper->SetSizeUnitToPixels();
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
};

#endif
