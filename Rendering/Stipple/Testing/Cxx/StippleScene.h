// SPDX-License-Identifier: BSD-3-Clause
#ifndef StippleScene_h
#define StippleScene_h

#include "InkTestScene.h"
#include "vtkInkStippleMapper.h"

class StippleScene : public InkTestScene<vtkInkStippleMapper>
{
public:
  using InkTestScene::InkTestScene;

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
