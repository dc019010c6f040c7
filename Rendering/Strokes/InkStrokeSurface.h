// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStrokeSurface_h
#define InkStrokeSurface_h

#include "InkActorResources.h"
#include "InkOccluder.h"
#include "InkShiftScale.h"

#include <memory>

/// The surface that hides strokes, on the GPU, for one window, with its depth in the views of it.
struct InkStrokeSurface
{
  explicit InkStrokeSurface(vtkOpenGLRenderWindow* window)
    : Occluder(window, false)
  {
  }

  InkOccluder Occluder;
  InkShiftScale Frame;
  vtkMTimeType Time = 0; ///< of the surface that Frame is of
  InkActorResources<std::unique_ptr<InkOccluderDepth>> Depths;
};

#endif
