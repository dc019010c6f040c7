// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStrokeMarks_h
#define InkStrokeMarks_h

#include "InkActorResources.h"
#include "InkMarks.h"
#include "InkStrokePasses.h"
#include "InkStrokePoints.h"
#include "InkToonPass.h"
#include "InkViewUniforms.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

/// The strokes on the GPU, for one window, and what they were made from.
class InkStrokeMarks : public InkMarks
{
public:
  explicit InkStrokeMarks(vtkOpenGLRenderWindow* window)
    : Passes(window)
    , Toon(window)
    , Window(window)
  {
  }

  vtkMTimeType GetUploadTime() const override
  {
    vtkMTimeType latest = std::max(this->Passes.GetUploadTime(), this->Toon.GetUploadTime());
    this->OfViews.ForEach([&](const std::unique_ptr<InkStrokeMarks>& marks)
      { latest = std::max(latest, marks ? marks->GetUploadTime() : 0); });
    return latest;
  }

  /// Those of an actor in a renderer alone, where strokes depend on the eye.
  InkStrokeMarks& GetOfView(vtkRenderer* renderer, vtkActor* actor)
  {
    std::unique_ptr<InkStrokeMarks>& marks = this->OfViews.Get(renderer, actor);
    if (!marks)
    {
      marks = std::make_unique<InkStrokeMarks>(this->Window);
    }
    return *marks;
  }

  InkStrokePasses Passes;
  InkStrokePoints Strokes;
  std::optional<InkStrokeArrays::Key> Source; ///< of Strokes
  std::optional<std::string> Colors;          ///< as InkScalarColors describes those of Passes

  InkToonPass Toon;

  /// What an actor in a renderer shows of the strokes.
  struct View
  {
    /// What the runs were made from.
    struct Source
    {
      vtkMTimeType Strokes;
      vtkMTimeType Surface; ///< 0: none hides them
      std::optional<InkViewUniforms> Shown;
      bool WithHidden;
      double Tolerance;
      double LeastRun;
      bool operator==(const Source&) const = default;
    };
    std::optional<Source> RunsSource;
    std::unique_ptr<InkStrokeRunBuffers> Runs;
  };
  InkActorResources<View> Views;

  vtkOpenGLRenderWindow* const Window;

private:
  InkActorResources<std::unique_ptr<InkStrokeMarks>> OfViews;
};

#endif
