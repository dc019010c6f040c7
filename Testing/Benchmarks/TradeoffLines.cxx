// SPDX-License-Identifier: BSD-3-Clause
// Splatting lines with splats summed up for squares of pixels and in 16 bits, and with a part of the points:
// how much pictures differ, against the time of a frame.

#include "BumpySphere.h"
#include "Tradeoff.h"

#include "PictureDifference.h"

#include "vtkInkSplattingLinesMapper.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace
{

constexpr int WindowSize = 600;
constexpr vtkIdType Points = 200'000;

class Scene
{
public:
  Scene()
  {
    const Splats splats = BumpySphere(Points);
    this->Mapper->SetInputData(splats.Points);
    this->Mapper->SetRadius(splats.Radius);
    vtkNew<vtkActor> actor;
    actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(actor);
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(WindowSize, WindowSize);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->ResetCamera();
    this->Renderer->GetActiveCamera()->Zoom(1.4);
  }

  vtkInkSplattingLinesMapper* GetMapper() { return this->Mapper; }

  void Draw(double lambda)
  {
    this->Mapper->SetLambda(lambda);
    this->Window->Render();
    this->Window->WaitForCompletion();
  }

  /// Another view each time: what does not change costs nothing.
  void DrawNext(double lambda)
  {
    this->Renderer->GetActiveCamera()->Azimuth(this->Forward ? 1.0 : -1.0);
    this->Forward = !this->Forward;
    this->Draw(lambda);
  }

  /// How dark each pixel is.
  std::vector<double> TakePicture(double lambda)
  {
    this->Draw(lambda);
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, WindowSize - 1, WindowSize - 1, 0, pixels);
    std::vector<double> darkness;
    for (vtkIdType i = 0; i < pixels->GetNumberOfValues(); i += 3)
    {
      darkness.push_back(255.0 - pixels->GetValue(i));
    }
    return darkness;
  }

private:
  vtkNew<vtkInkSplattingLinesMapper> Mapper;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  bool Forward = true;
};

struct Setting
{
  const char* Name;
  std::function<void(vtkInkSplattingLinesMapper*)> Set;
  Tradeoff::Role Role;
};

/// @param lambda of the frames that are timed
void Measure(Tradeoff& knob, Scene& scene, const std::vector<Setting>& settings,
  const std::vector<double>& lambdas, double lambda)
{
  const auto set = [&scene](const Setting& setting)
  {
    scene.GetMapper()->SetMaximumDownsampling(1);
    scene.GetMapper()->SetHalfFloats(false);
    scene.GetMapper()->SetPointFraction(1.0);
    setting.Set(scene.GetMapper());
  };
  for (const Setting& setting : settings)
  {
    Tradeoff::Errors errors;
    for (const double each : lambdas)
    {
      set({ "", [](vtkInkSplattingLinesMapper*) {}, Tradeoff::Choice });
      const std::vector<double> exact = scene.TakePicture(each);
      set(setting);
      std::string name = "lambda ";
      name += each == std::floor(each) ? std::to_string(static_cast<int>(each)) : "2.5";
      errors.emplace_back(name, ink::pictureDifference(exact, scene.TakePicture(each)));
    }
    knob.Add(
      setting.Name,
      [set, setting, &scene, lambda]
      {
        set(setting);
        scene.DrawNext(lambda);
      },
      errors, setting.Role);
  }
  knob.Print(3);
}

} // namespace

int main()
{
  using Mapper = vtkInkSplattingLinesMapper;
  Tradeoff::PrintHeader();
  Scene scene;
  const std::string picture = "darkness that differs from the exact picture's, of all";
  const std::string work = "a frame of 200,000 points, 600x600, lambda ";

  Tradeoff sums("Sums of splats (vtkInkSplattingLinesMapper)",
    "Keep squares of 2 x 2 pixels; take 1 for a picture to measure in, 4 where Lambda is large and frames "
    "are "
    "to be quick. 16 bits gain time on some graphics cards only.",
    picture, work + "8");
  Measure(sums, scene,
    { { "each pixel", [](Mapper* mapper) { mapper->SetMaximumDownsampling(1); }, Tradeoff::Choice },
      { "2 x 2 pixels", [](Mapper* mapper) { mapper->SetMaximumDownsampling(2); }, Tradeoff::Default },
      { "4 x 4 pixels", [](Mapper* mapper) { mapper->SetMaximumDownsampling(4); }, Tradeoff::Choice },
      { "2 x 2 pixels, 16 bits",
        [](Mapper* mapper)
        {
          mapper->SetMaximumDownsampling(2);
          mapper->SetHalfFloats(true);
        },
        Tradeoff::Choice } },
    { 2.5, 8.0, 16.0 }, 8.0);

  Tradeoff part("Part of the points (vtkInkSplattingLinesMapper)",
    "Keep all points; while something moves, a fifth of them takes a third of the time, and lines are a "
    "little "
    "broader and rougher. ParaView does so beyond its LOD threshold.",
    picture, work + "2.5");
  std::vector<Setting> settings;
  for (const auto& [name, fraction] : std::vector<std::pair<const char*, double>>{
         { "1/20", 0.05 }, { "1/5", 0.2 }, { "1/2", 0.5 }, { "all", 1.0 } })
  {
    settings.push_back({ name, [fraction = fraction](Mapper* mapper) { mapper->SetPointFraction(fraction); },
      fraction == 1.0 ? Tradeoff::Default : Tradeoff::Choice });
  }
  Measure(part, scene, settings, { 2.5, 8.0 }, 2.5);
  return 0;
}
