// SPDX-License-Identifier: BSD-3-Clause
#ifndef ContourUpdates_h
#define ContourUpdates_h

#include "vtkCamera.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

/// When the contours of a vtkInkSilhouetteMapper are found again.
template <class Scene>
class ContourUpdates
{
public:
  /// @param scene kept, with GetContours()
  explicit ContourUpdates(Scene& scene)
    : Drawn(scene)
  {
  }

  /// Draws, and expects that contours were found for it or not.
  void operator()(bool anew, const char* what)
  {
    this->Drawn.Window->Render();
    EXPECT_EQ(this->Drawn.GetContours()->GetMTime() > this->Before, anew) << what;
    this->Before = this->Drawn.GetContours()->GetMTime();
  }

  /// Of a new scene: for the camera and the actor, not for how lines are drawn.
  void ExpectThoseOfTheView()
  {
    auto& expect = *this;
    expect(true, "first picture");
    expect(false, "the same picture");
    this->Drawn.Mapper->SetLineWidth(5.0);
    this->Drawn.Mapper->SetHiddenPartsToFaint();
    expect(false, "another width");
    this->Drawn.Renderer->GetActiveCamera()->Azimuth(10.0);
    expect(true, "another camera");
    this->Drawn.Actor->RotateX(10.0);
    expect(true, "the actor turned");
  }

private:
  Scene& Drawn;
  vtkMTimeType Before = 0;
};

#endif
