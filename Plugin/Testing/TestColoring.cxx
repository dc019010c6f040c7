// SPDX-License-Identifier: BSD-3-Clause
// What a person changes who edits the solid color: of our representations the ink's, of others ParaView's. In
// widgets of ParaView's client, with the plugin that PV_PLUGIN_PATH holds.
#include "ClientTest.h"

#include "pqColorToolbar.h"
#include "pqDefaultContextMenu.h"
#include "pqEditColorMapReaction.h"
#include "pqProxyWidget.h"

#include "vtkDataObject.h"
#include "vtkSMPVRepresentationProxy.h"

#include <QColorDialog>
#include <QMenu>
#include <QPushButton>
#include <QTimer>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace
{

using Colors = std::map<std::string, QColor>; ///< by the properties that hold them

Colors ColorsOf(vtkSMProxy* display)
{
  Colors colors;
  for (const char* property :
    { "DiffuseColor", "AmbientColor", "InkColor", "StippleInkColor", "ContoursInkColor", "LineArtInkColor" })
  {
    const std::vector<double> rgb = vtkSMPropertyHelper(display, property).GetArray<double>();
    colors[property] = QColor::fromRgbF(rgb.at(0), rgb.at(1), rgb.at(2));
  }
  return colors;
}

/// What the dialog showed that doing so opened, if it opened one, where the new color is picked then; an
/// invalid color cancels.
std::optional<QColor> Pick(const QColor& color, const std::function<void()>& openDialog)
{
  std::optional<QColor> shown;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout,
    [&]
    {
      if (auto dialog = qobject_cast<QColorDialog*>(QApplication::activeModalWidget()))
      {
        shown = dialog->currentColor();
        dialog->setCurrentColor(color);
        color.isValid() ? dialog->accept() : dialog->reject();
      }
    });
  timer.start(10);
  openDialog();
  return shown;
}

class TestColoring : public ClientTest
{
public:
  explicit TestColoring(const std::vector<std::string>&)
    : ClientTest(
        [this](pqObjectBuilder* builder, pqServer* server)
        {
          // Before there is a representation.
          pqInterfaceTracker* tracker = pqApplicationCore::instance()->interfaceTracker();
          tracker->addInterface(new pqDefaultContextMenu(tracker));
          this->Window.addToolBar(new pqColorToolbar(&this->Window));
          return builder->createSource("sources", "SphereSource", server);
        })
  {
  }

  bool Run()
  {
    const std::map<std::string, std::function<void()>> places = {
      { "panel", [this] { this->ClickInPanel(); } },
      { "toolbar", [this] { this->TriggerBelow(&this->Window); } },
      { "context menu", [this] { this->TriggerInContextMenu(); } },
    };
    for (const auto& [place, edit] : places)
    {
      std::cout << place << ":\n";
      this->ColorByArray(false);
      this->TestEdits("Splatting Lines", edit, { "InkColor" }, "Changed Ink Color");
      this->TestEdits("Stipple", edit, { "StippleInkColor" }, "Changed Ink Color");
      this->TestEdits("Contours", edit, { "ContoursInkColor" }, "Changed Ink Color");
      this->TestEdits("Line Art", edit, { "LineArtInkColor" }, "Changed Ink Color");
      this->TestEdits("Surface", edit, { "DiffuseColor", "AmbientColor" }, "Changed Solid Color");
      this->Show("Stipple");
      this->TestCancel(edit);
      this->ColorByArray(true);
      this->Check(!Pick(Qt::cyan, edit), "colors of an array are no solid color");
    }
    return this->Right;
  }

private:
  void TestEdits(const char* style, const std::function<void()>& edit,
    const std::vector<std::string>& properties, const std::string& undo)
  {
    this->Show(style);
    pqUndoStack* stack = GetUndoStack();
    for (const QColor color : { Qt::red, Qt::blue })
    {
      const Colors before = ColorsOf(this->Display);
      Colors expected = before;
      for (const std::string& property : properties)
      {
        expected[property] = color;
      }
      const std::string what = std::string(style) + ' ' + color.name().toStdString();
      this->Check(
        Pick(color, edit) == before.at(properties[0]), what + " is picked where the present color was");
      this->Check(ColorsOf(this->Display) == expected, what + " is set, and no other color");
      this->Check(
        stack->canUndo() && stack->undoLabel().toStdString() == undo, what + " can be undone by its name");
      stack->undo();
      this->Check(ColorsOf(this->Display) == before, what + " is undone");
      stack->redo();
      this->Check(ColorsOf(this->Display) == expected, what + " is redone");
    }
  }

  void TestCancel(const std::function<void()>& edit)
  {
    pqUndoStack* stack = GetUndoStack();
    stack->clear();
    const Colors before = ColorsOf(this->Display);
    this->Check(Pick(QColor(), edit).has_value(), "a dialog to cancel");
    this->Check(ColorsOf(this->Display) == before, "cancel leaves the colors");
    this->Check(!stack->canUndo(), "cancel leaves nothing to undo");
  }

  void ClickInPanel()
  {
    pqProxyWidget panel(this->Display);
    auto button = panel.findChild<QPushButton*>("EditColorMap");
    if (this->Check(button, "the panel has a button to edit the color"))
    {
      button->click();
    }
  }

  void TriggerInContextMenu()
  {
    QMenu menu;
    auto interfaces =
      pqApplicationCore::instance()->interfaceTracker()->interfaces<pqContextMenuInterface*>();
    std::sort(interfaces.begin(), interfaces.end(),
      [](const auto* one, const auto* other) { return one->priority() > other->priority(); });
    for (const pqContextMenuInterface* one : interfaces)
    {
      one->contextMenu(&menu, this->View, QPoint(), this->Representation, QList<unsigned int>());
      one->contextMenu(&menu, this->View, QPoint(), this->Representation, QStringList());
    }
    this->TriggerBelow(&menu);
  }

  void TriggerBelow(QWidget* parent)
  {
    const auto reactions = parent->findChildren<pqEditColorMapReaction*>();
    if (this->Check(reactions.size() == 1, "there is one action that edits the color"))
    {
      reactions[0]->parentAction()->trigger();
    }
  }

  void ColorByArray(bool byArray)
  {
    vtkSMPVRepresentationProxy::SetScalarColoring(
      this->Display, byArray ? "Normals" : nullptr, vtkDataObject::POINT);
  }
};

} // namespace

int main(int argc, char* argv[])
{
  return ClientTest::Run<TestColoring>(argc, argv);
}
