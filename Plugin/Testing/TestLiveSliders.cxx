// SPDX-License-Identifier: BSD-3-Clause
// What a person sees who drags a slider of the panel: pictures that follow, and at last what ParaView's own
// sliders would leave, with one step to undo.
//     TestLiveSliders                        with an image of its own
//     TestLiveSliders FILE ISO [STYLE ...]   how long pictures take, of a volume near an iso-value
#include "ClientTest.h"

#include "pqPropertyWidget.h"
#include "pqProxyWidget.h"

#include "vtkObjectBase.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"
#include "vtkSMProperty.h"
#include "vtkSMTrace.h"
#include "vtkSMViewProxy.h"

#include <QElapsedTimer>
#include <QSlider>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace
{

/// The representations with iso-sliders: their iso-values' properties.
const std::map<std::string, std::string> IsoValues = {
  { "Contours", "ContoursIsoValue" },
  { "Illustration", "IllustrationIsoValue" },
  { "Splatting Lines", "LinesIsoValue" },
};

class TestLiveSliders : public ClientTest
{
public:
  explicit TestLiveSliders(std::vector<std::string> arguments)
    : ClientTest(
        [&](pqObjectBuilder* builder, pqServer* server)
        {
          if (!arguments.empty())
          {
            return builder->createReader(
              "sources", "InkNIfTIReader", QStringList(QString::fromStdString(arguments[0])), server);
          }
          pqPipelineSource* source = builder->createSource("sources", "RTAnalyticSource", server);
          vtkSMPropertyHelper extent(source->getProxy(), "WholeExtent");
          const int whole[] = { -130, 130, -130, 130, -130, 130 };
          extent.Set(whole, 6);
          source->getProxy()->UpdateVTKObjects();
          return source;
        })
    , Arguments(std::move(arguments))
  {
    this->Window.setCentralWidget(this->View->widget());
    const bool measures = !this->Arguments.empty();
    this->Window.resize(measures ? 1024 : 200, measures ? 768 : 200);
  }

  bool Run()
  {
    if (this->Arguments.size() == 1)
    {
      std::cerr << "expected FILE ISO [STYLE ...]\n";
      return false;
    }
    if (!this->Arguments.empty())
    {
      const std::size_t given = this->Arguments.size() - 2;
      for (const auto& [style, property] : IsoValues)
      {
        if (given == 0 ||
          std::find(this->Arguments.begin() + 2, this->Arguments.end(), style) != this->Arguments.end())
        {
          this->Measure(style, property, std::stod(this->Arguments.at(1)));
        }
      }
      return true;
    }
    this->TestIsoValue();
    this->TestValueOfDrawing();
    this->TestClick();
    return this->Right;
  }

private:
  /// What a representation says of itself.
  struct Made
  {
    int Points = 0;
    int Times = 0;
  };

  static int NumberAfter(const std::string& text, const std::string& words)
  {
    const std::size_t found = text.find(words);
    return found == std::string::npos ? -1 : std::stoi(text.substr(found + words.size()));
  }

  Made GetMade()
  {
    std::ostringstream text;
    this->Display->GetProperty("LinesIsoValue")->GetParent()->GetClientSideObject()->Print(text);
    return { NumberAfter(text.str(), "Points drawn: "), NumberAfter(text.str(), "Times made: ") };
  }

  /// Of all that is drawn.
  std::array<double, 6> GetBounds()
  {
    std::array<double, 6> bounds;
    auto* view = vtkPVRenderView::SafeDownCast(this->View->getViewProxy()->GetClientSideObject());
    view->GetRenderer()->ComputeVisiblePropBounds(bounds.data());
    return bounds;
  }

  /// A panel of the representation, and one of its sliders.
  struct Panel
  {
    std::unique_ptr<pqProxyWidget> Widget;
    QSlider* Slider = nullptr;
  };

  Panel MakePanel(const std::string& property)
  {
    Panel panel{ std::make_unique<pqProxyWidget>(this->Display) };
    panel.Widget->setApplyChangesImmediately(true);
    panel.Widget->setView(this->View);
    QObject::connect(panel.Widget.get(), &pqProxyWidget::changeFinished, this->View, &pqView::render);
    for (pqPropertyWidget* widget : panel.Widget->findChildren<pqPropertyWidget*>())
    {
      if (widget->property() && this->Display->GetProperty(property.c_str()) == widget->property())
      {
        panel.Slider = widget->findChild<QSlider*>();
      }
    }
    this->Check(panel.Slider, "the panel has a slider for " + property);
    return panel;
  }

  double Get(const std::string& property)
  {
    return vtkSMPropertyHelper(this->Display, property.c_str()).GetAsDouble();
  }

  /// All that waits, also what a view draws a little later.
  void Wait()
  {
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < 100)
    {
      QApplication::processEvents(QEventLoop::AllEvents, 20);
    }
    this->View->forceRender();
  }

  void TestIsoValue()
  {
    this->Show("Splatting Lines");
    this->View->resetDisplay();
    this->Wait();
    this->Wait(); // also for what the first picture asked for
    Panel panel = this->MakePanel("LinesIsoValue");
    const double chosen = this->Get("LinesIsoValue");
    const int position = panel.Slider->value();
    const Made before = this->GetMade();
    GetUndoStack()->clear();

    panel.Slider->setSliderDown(true);
    panel.Slider->setValue(position + 5);
    QApplication::processEvents();
    const double dragged = this->Get("LinesIsoValue");
    this->Check(dragged > chosen, "the iso-value follows the slider");
    this->Check(this->Get("LinesAutomaticIsoValue") == 0.0, "and is automatic no more");
    this->Check(this->GetMade().Times == before.Times + 1, "with a picture");
    panel.Slider->setValue(position + 6);
    panel.Slider->setValue(position + 7);
    QApplication::processEvents();
    const Made coarse = this->GetMade();
    const std::array coarseBounds = this->GetBounds();
    this->Check(coarse.Times == before.Times + 2, "the last of several values is followed, once");
    panel.Slider->setSliderDown(false);
    this->Wait();
    const double last = this->Get("LinesIsoValue");
    const Made whole = this->GetMade();
    this->Check(last > dragged, "the last value stays");
    this->Check(whole.Times == coarse.Times + 1, "and is drawn once more");
    this->Check(coarse.Points > 0 && coarse.Points < 0.6 * whole.Points,
      "of more points: " + std::to_string(whole.Points) + ", not " + std::to_string(coarse.Points));

    const std::array wholeBounds = this->GetBounds();
    double moved = 0.0;
    for (std::size_t i = 0; i < 6; ++i)
    {
      moved = std::max(moved, std::abs(wholeBounds[i] - coarseBounds[i]));
    }
    this->Check(
      moved <= 2.0, "of which none were farther away than a coarse voxel: " + std::to_string(moved));

    this->Check(GetUndoStack()->canUndo(), "it can be undone");
    GetUndoStack()->undo();
    this->Wait();
    this->Check(this->Get("LinesIsoValue") == chosen && this->Get("LinesAutomaticIsoValue") == 1.0,
      "to what was before it was dragged");
    this->Check(this->GetMade().Points == before.Points, "and the picture, too");
    this->Check(!GetUndoStack()->canUndo(), "in one step");
    GetUndoStack()->redo();
    this->Wait();
    this->Check(
      this->Get("LinesIsoValue") == last && this->Get("LinesAutomaticIsoValue") == 0.0, "and redone");
  }

  void TestValueOfDrawing()
  {
    Panel panel = this->MakePanel("Phi");
    const Made before = this->GetMade();
    const double phi = this->Get("Phi");
    GetUndoStack()->clear();
    vtkSMTrace::StartTrace();
    panel.Slider->setSliderDown(true);
    panel.Slider->setValue(panel.Slider->value() + 5);
    QApplication::processEvents();
    this->Check(this->Get("Phi") > phi, "a value of the drawing follows its slider");
    panel.Slider->setValue(panel.Slider->value() + 5);
    QApplication::processEvents();
    const double dragged = this->Get("Phi");
    panel.Slider->setSliderDown(false);
    this->Wait();
    const std::string trace = vtkSMTrace::StopTrace();
    const std::size_t traced = trace.find(".Phi = ");
    this->Check(
      traced != std::string::npos && traced == trace.rfind(".Phi = "), "a trace has it once\n" + trace);
    this->Check(this->Get("Phi") == dragged, "and stays");
    this->Check(this->GetMade().Times == before.Times, "without new points");
    GetUndoStack()->undo();
    this->Check(this->Get("Phi") == phi, "and is undone");
  }

  void TestClick()
  {
    Panel panel = this->MakePanel("LinesIsoValue");
    const Made before = this->GetMade();
    GetUndoStack()->clear();
    panel.Slider->setSliderDown(true);
    panel.Slider->setSliderDown(false);
    this->Wait();
    this->Check(!GetUndoStack()->canUndo() && this->GetMade().Times == before.Times,
      "a slider that was not moved changes nothing");
    panel.Slider->setSliderDown(true);
    panel.Slider->setValue(panel.Slider->value() + 3);
    QApplication::processEvents();
    panel.Widget.reset();
    this->Wait();
    this->Check(GetUndoStack()->canUndo(), "a panel that closes ends what can be undone");
    this->Check(this->GetMade().Points > 0.6 * before.Points, "a panel that closes leaves a whole surface");
  }

  void Measure(const std::string& style, const std::string& property, double isoValue)
  {
    this->Show(style.c_str());
    this->View->resetDisplay();
    this->Wait();
    Panel panel = this->MakePanel(property);
    vtkSMPropertyHelper(this->Display, property.c_str()).Set(isoValue);
    this->Display->UpdateVTKObjects();
    this->Wait();
    this->Wait(); // also for what the first picture of the iso-value asked for
    QElapsedTimer clock;
    const auto seconds = [&] { return static_cast<double>(clock.restart()) / 1e3; };
    std::cout << style << ":";
    panel.Slider->setSliderDown(true);
    for (int step = 0; step < 5; ++step)
    {
      clock.start();
      panel.Slider->setValue(panel.Slider->value() + 1);
      QApplication::processEvents();
      std::cout << ' ' << seconds();
    }
    clock.start();
    panel.Slider->setSliderDown(false);
    QApplication::processEvents();
    this->View->forceRender();
    std::cout << ", then " << seconds() << std::endl;
  }

  const std::vector<std::string> Arguments;
};

} // namespace

int main(int argc, char* argv[])
{
  return ClientTest::Run<TestLiveSliders>(argc, argv);
}
