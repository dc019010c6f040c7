// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStippleMarks_h
#define InkStippleMarks_h

#include "InkActorResources.h"
#include "InkMarks.h"
#include "InkOccluder.h"
#include "InkStippleInput.h"
#include "InkStipplePasses.h"

#include <memory>
#include <optional>
#include <string>

/// The stipples on the GPU, for one window, what they were made from, and the surface that hides them.
class InkStippleMarks : public InkMarks
{
public:
  explicit InkStippleMarks(vtkOpenGLRenderWindow* window)
    : Passes(window)
    , Occluder(window)
  {
  }

  vtkMTimeType GetUploadTime() const override { return this->Passes.GetUploadTime(); }

  struct Source
  {
    InkStippleInput::Key Input;
    int PositionPrecision;
    bool operator==(const Source&) const = default;
  };

  InkStipplePasses Passes;
  std::optional<Source> Stipples;    ///< what those of Passes were made from
  std::optional<std::string> Colors; ///< as InkScalarColors describes those of Passes
  InkOccluder Occluder;
  InkActorResources<std::unique_ptr<InkOccluderDepth>> Depths; ///< null before they are first drawn
};

#endif
