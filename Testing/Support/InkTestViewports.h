// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTestViewports_h
#define InkTestViewports_h

#include "InkTestImage.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <cstdlib>

/// Draws a scene (InkTestScene) in the left half of its window and an actor, which may be the scene's own, in
/// the right half.
/// @param alone what each of them draws in a window of half the width
/// @return how many pixels of both halves are brighter or darker than it by more than the tolerance
template <class Scene>
int CountDifferentInViewports(const InkTestImage& alone, Scene& scene, vtkActor* actor, int tolerance = 0)
{
  scene.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkRenderer> right;
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  right->SetBackground(1.0, 1.0, 1.0);
  right->AddActor(actor);
  scene.Window->AddRenderer(right);
  scene.Renderer->ResetCamera();
  right->ResetCamera();
  const InkTestImage both(scene.Window);
  int different = 0;
  for (int y = 0; y < alone.GetHeight(); ++y)
  {
    for (int x = 0; x < alone.GetWidth(); ++x)
    {
      for (const int half : { 0, alone.GetWidth() })
      {
        different += std::abs(both.Gray(x + half, y) - alone.Gray(x, y)) > tolerance;
      }
    }
  }
  return different;
}

#endif
