// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "StyledScene.h"
#include "View.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkActor;
class vtkCamera;
class vtkImageData;
class vtkInkCameraFit;
class vtkLight;
class vtkRenderWindow;
class vtkRenderer;

namespace ink::cli
{

/// The window that pictures are drawn in, one after the other.
class Drawing
{
public:
  /// @param options kept as a reference
  explicit Drawing(const RenderOptions& options);
  ~Drawing();
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  /// The view that the options ask for.
  /// @param turned degrees that the viewer goes further to the right, around what stands upright
  View view(double turned = 0.0) const;

  /// A camera that looks as `view` says, from nowhere in particular.
  vtkSmartPointer<vtkCamera> camera(double turned = 0.0) const;

  /// A fit for this window's shape.
  vtkSmartPointer<vtkInkCameraFit> makeFit() const;

  /// @throws Failure if VTK complains
  vtkSmartPointer<vtkImageData> draw(const StyledScene& subject, vtkInkCameraFit* fit, double turned = 0.0);

private:
  const RenderOptions& Options;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkSmartPointer<vtkLight> Light;
};

} // namespace ink::cli
