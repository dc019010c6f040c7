// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Input.h"
#include "PictureFile.h"
#include "StyledScene.h"
#include "Tiles.h"

#include "vtkInkView.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkActor;
class vtkCamera;
class vtkInkCameraFit;
class vtkLight;
class vtkPoints;
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

  /// Chooses how a subject is viewed, where the options do not say. @return what was chosen, where that is
  /// not what it is for volumes
  std::vector<std::string> look(const Input& input, const std::filesystem::path& file);

  /// Chooses it again for what is drawn, which of a volume is known only when its marks are made: of the
  /// first frame, so that a picture's marks and the picture, or all of an animation, are seen from one side.
  /// @return as look
  std::vector<std::string> lookAtFrame(vtkPoints* frame);

  /// A camera that looks as the options ask for, from nowhere in particular.
  /// @param turned degrees that the viewer goes further to the right, around what stands upright
  vtkSmartPointer<vtkCamera> camera(double turned = 0.0) const;

  /// A fit for this window's shape.
  vtkSmartPointer<vtkInkCameraFit> makeFit() const;

  /// The camera of a picture of points, as vtkInkStyle takes it.
  vtkSmartPointer<vtkCamera> stillCamera(vtkPoints* frame) const;

  /// What is said of the pictures in their files.
  io::PictureLayout layout() const;

  /// Draws a picture, in tiles where it is larger than a window can be, and hands over its rows as they come.
  /// @param progress how much is drawn, from 0 to 1; empty: nobody watches
  /// @throws Failure if VTK complains
  void draw(const StyledScene& subject, vtkInkCameraFit* fit, const RowSink& sink,
    const std::function<void(double)>& progress, double turned = 0.0);

private:
  /// The camera for all of the picture.
  vtkSmartPointer<vtkCamera> placedCamera(vtkInkCameraFit* fit, double turned) const;
  /// Makes a camera that looks at all of the picture look at a tile.
  void aim(vtkCamera* camera, const Tiles::Strip& column, const Tiles::Strip& row) const;

  const RenderOptions& Options;
  Tiles Grid;
  vtkNew<vtkInkView> View;
  bool HasFrame = false;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkSmartPointer<vtkLight> Light;
};

} // namespace ink::cli
