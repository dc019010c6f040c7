// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FitCamera.h"
#include "StyledScene.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkActor;
class vtkImageData;
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

  /// A fit for this window's shape.
  CameraFit makeFit(const std::array<double, 3>& pivot = { 0, 0, 0 }) const;

  /// @throws Failure if VTK complains
  vtkSmartPointer<vtkImageData> draw(const StyledScene& subject, const CameraFit& fit, double turned = 0.0);

private:
  const RenderOptions& Options;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkSmartPointer<vtkLight> Light;
};

} // namespace ink::cli
