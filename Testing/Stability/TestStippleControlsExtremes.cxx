// SPDX-License-Identifier: BSD-3-Clause
// vtkInkStippleControls at the ends of what there is.
#include "InkTestMessages.h"
#include "InkTestStipples.h"
#include "StippleInk.h"

#include "vtkInkStippleControls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace
{

using namespace StippleInk;

class StippleControlsExtremes : public StippleInk::Test
{
};

} // namespace

/// All six sliders at both ends under all presets, on volumes and surfaces.
TEST_F(StippleControlsExtremes, Sliders)
{
  for (const auto& [kind, data] :
    { std::pair<std::string, Data>("volume", InkTestStipples::SphereVoxels(1.0, 0.1, 8)),
      std::pair<std::string, Data>("surface", InkTestStipples::SphereSurface(1.0, 500, 8)) })
  {
    StippleScene scene(data, 60, 60);
    vtkNew<InkTestMessages> messages;
    messages->Observe(scene.Mapper);
    vtkNew<vtkInkStippleControls> controls;
    for (int preset = 0; preset < vtkInkStippleControls::GetNumberOfPresets(); ++preset)
    {
      controls->SetPreset(vtkInkStippleControls::GetPresetName(preset));
      double paper[3];
      controls->GetPaperColor(paper);
      scene.Renderer->SetBackground(paper);
      for (int ends = 0; ends < 64; ++ends)
      {
        controls->SetGradient(ends & 1 ? 1e30 : -1e30);
        controls->SetSharpness(ends >> 1 & 1);
        controls->SetOrientation(ends >> 2 & 1);
        controls->SetDistance(ends >> 3 & 1);
        controls->SetInterior(ends >> 4 & 1);
        controls->SetColor(ends >> 5 & 1);
        controls->Apply(scene.Mapper);
        scene.Mapper->SetSizeUnitToPixels();
        const InkTestImage image(scene.Window);
        const int paperGray = static_cast<int>(255.0 * paper[0]);
        double marks = 0.0;
        for (int y = 0; y < 60; ++y)
        {
          for (int x = 0; x < 60; ++x)
          {
            marks += std::abs(image.Gray(x, y) - paperGray) / 255.0;
          }
        }
        // No ink for gradients, all of it at the thinnest silhouettes, light everywhere: as good as nothing.
        const bool lightest = (ends & 7) == 6;
        EXPECT_TRUE(marks >= (lightest ? 0.0 : 0.6) && marks < 2200.0)
          << kind << ", " << controls->GetPreset() << ", ends " << ends << ": a drawing, found marks of "
          << marks << " pixels";
      }
    }
    EXPECT_TRUE(messages->Messages.empty()) << kind << ": no message from any slider";
  }
  vtkNew<vtkInkStippleControls> controls;
  vtkNew<InkTestMessages> messages;
  messages->Observe(controls);
  controls->SetGradient(0.3);
  controls->SetGradient(NaN);
  messages->Expect("a slider that is not a number", { "from 0 to 1, found nan" });
  EXPECT_EQ(controls->GetGradient(), 0.3) << "the slider where it was, found " << controls->GetGradient();
  controls->SetGradient(Infinity);
  controls->SetSharpness(-Infinity);
  EXPECT_TRUE(controls->GetGradient() == 1.0 && controls->GetSharpness() == 0.0) << "sliders at their ends";
}
