// SPDX-License-Identifier: BSD-3-Clause
/**
 * Has a view smooth its surfaces before stipples are drawn over them, wherever it is rendered.
 */
#ifndef vtkInkEarlyFXAA_h
#define vtkInkEarlyFXAA_h

#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

/**
 * A renderer applies FXAA to surfaces, before volumes, among which stipples are drawn: dots stay sharp.
 * ParaView applies it to the finished picture instead when a server has rendered that, dots and all. This
 * class has the server's renderer apply it as any renderer does. Where several processes' pictures are put
 * together no process knows the surfaces around its own: there is no FXAA then.
 */
class vtkInkEarlyFXAA
{
public:
  vtkInkEarlyFXAA() = default;
  ~vtkInkEarlyFXAA();
  vtkInkEarlyFXAA(const vtkInkEarlyFXAA&) = delete;
  void operator=(const vtkInkEarlyFXAA&) = delete;

  void Attach(vtkRenderer* renderer);
  void Detach();
  /// Nothing is done while there is nothing to be kept sharp. Default: off.
  void SetActive(bool active) { this->Active = active; }

private:
  void TakeFromView();
  void GiveToRenderer();

  vtkWeakPointer<vtkRenderer> Renderer;
  unsigned long Observers[2] = { 0, 0 };
  bool Active = false;
  bool Taken = false;
};

#endif
