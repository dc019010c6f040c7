// SPDX-License-Identifier: BSD-3-Clause
// Undo, and copy and paste, of a preset as ParaView's client does them, which its Python does not offer:
//     TestUndo PLUGIN
#include "vtkInitializationHelper.h"
#include "vtkNew.h"
#include "vtkPVPluginLoader.h"
#include "vtkProcessModule.h"
#include "vtkSMParaViewPipelineController.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyClipboard.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUndoStack.h"
#include "vtkSMUndoStackBuilder.h"
#include "vtkSmartPointer.h"

#include <iostream>
#include <utility>
#include <vector>

namespace
{

/// A representation's preset, one that is neither the first nor the second, what follows it, and what is set
/// by hand after it.
struct Drawing
{
  const char* Preset;
  int Other;
  std::vector<const char*> Followers;
  std::vector<std::pair<const char*, double>> ByHand;
};

using Values = std::vector<double>;

Values ValuesOf(vtkSMProxy* display, const Drawing& drawing)
{
  Values values{ vtkSMPropertyHelper(display, drawing.Preset).GetAsDouble() };
  for (const char* name : drawing.Followers)
  {
    values.push_back(vtkSMPropertyHelper(display, name).GetAsDouble());
  }
  return values;
}

void Set(vtkSMProxy* display, const char* name, double value)
{
  vtkSMPropertyHelper(display, name).Set(value);
  display->UpdateVTKObjects();
}

vtkSmartPointer<vtkSMProxy> MakeDisplay(vtkSMSessionProxyManager* manager, vtkSMProxy* source)
{
  vtkNew<vtkSMParaViewPipelineController> controller;
  auto display =
    vtkSmartPointer<vtkSMProxy>::Take(manager->NewProxy("representations", "GeometryRepresentation"));
  controller->PreInitializeProxy(display);
  vtkSMPropertyHelper(display, "Input").Set(source);
  controller->PostInitializeProxy(display);
  return display;
}

bool Check(bool right, const char* what)
{
  std::cout << (right ? "right: " : "WRONG: ") << what << "\n";
  return right;
}

bool TestOne(vtkSMSessionProxyManager* manager, vtkSMProxy* source, const Drawing& drawing)
{
  std::cout << drawing.Preset << "\n";
  vtkNew<vtkSMUndoStack> stack;
  vtkNew<vtkSMUndoStackBuilder> builder;
  builder->SetUndoStack(stack);
  vtkSMProxyManager::GetProxyManager()->SetUndoStackBuilder(builder);
  vtkSmartPointer<vtkSMProxy> display = MakeDisplay(manager, source);
  const char* last = drawing.Followers.back();
  const double before = vtkSMPropertyHelper(display, last).GetAsDouble();
  Set(display, drawing.Preset, drawing.Other);
  bool right = Check(vtkSMPropertyHelper(display, last).GetAsDouble() != before, "a preset sets the others");
  for (const auto& [name, value] : drawing.ByHand)
  {
    Set(display, name, value);
  }
  const Values byHand = ValuesOf(display, drawing);

  builder->Begin("preset");
  Set(display, drawing.Preset, 1);
  builder->End();
  builder->PushToStack();
  const Values preset = ValuesOf(display, drawing);
  right &= Check(preset != byHand, "another preset sets them anew");
  stack->Undo();
  right &= Check(ValuesOf(display, drawing) == byHand, "undo brings back what was set by hand");
  stack->Redo();
  right &= Check(ValuesOf(display, drawing) == preset, "redo brings back the preset");
  vtkSMProxyManager::GetProxyManager()->SetUndoStackBuilder(nullptr);
  stack->Clear();

  vtkSmartPointer<vtkSMProxy> other = MakeDisplay(manager, source);
  Set(display, last, vtkSMPropertyHelper(other, last).GetAsDouble());
  vtkNew<vtkSMProxyClipboard> clipboard;
  right &= Check(clipboard->Copy(display) && clipboard->Paste(other), "copy and paste");
  right &= Check(ValuesOf(other, drawing) == ValuesOf(display, drawing), "paste sets what was copied");
  clipboard->Clear();
  return right;
}

bool Test()
{
  vtkNew<vtkSMParaViewPipelineController> controller;
  vtkSMSession* session = vtkSMSession::New();
  vtkProcessModule::GetProcessModule()->RegisterSession(session);
  controller->InitializeSession(session);
  vtkSMSessionProxyManager* manager = session->GetSessionProxyManager();
  bool right = true;
  {
    const auto source = vtkSmartPointer<vtkSMProxy>::Take(manager->NewProxy("sources", "SphereSource"));
    source->UpdateVTKObjects();
    right &= TestOne(manager, source,
      { "StipplePreset", 3,
        { "StippleGradient", "StippleInterior", "BoundaryBase", "InteriorExponent", "SilhouetteGain" },
        { { "BoundaryBase", 0.35 }, { "StippleInterior", 0.9 } } });
    right &= TestOne(manager, source,
      { "IllustrationPreset", 3,
        { "IllustrationDistance", "IllustrationStippleSize", "IllustrationPixelsPerStipple",
          "IllustrationLightingExponent", "IllustrationPhi", "IllustrationTau" },
        { { "IllustrationStippleSize", 3.5 }, { "IllustrationTau", 0.9 } } });
    right &= TestOne(manager, source,
      { "ContoursPreset", 3,
        { "ContoursTaper", "ContoursDepthWidth", "ContoursJoin", "ContoursCreases", "ContoursHiddenLines",
          "ContoursLineWidth" },
        { { "ContoursTaper", 0.3 }, { "ContoursLineWidth", 7.0 } } });
    right &= TestOne(manager, source,
      { "LineArtPreset", 2,
        { "LineArtTone", "LineArtCrosshatch", "LineArtWidth", "LineArtLength", "LineArtTaper",
          "LineArtContourWidth", "LineArtCreases", "LineArtDensity" },
        { { "LineArtTone", 0.8 }, { "LineArtDensity", 0.2 } } });
  }
  vtkProcessModule::GetProcessModule()->UnRegisterSession(session);
  session->Delete();
  return right;
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: " << argv[0] << " PLUGIN\n";
    return 1;
  }
  vtkInitializationHelper::Initialize(argv[0], vtkProcessModule::PROCESS_CLIENT);
  vtkNew<vtkPVPluginLoader> loader;
  const bool right = Check(loader->LoadPlugin(argv[1]), "the plugin is loaded") && Test();
  vtkInitializationHelper::Finalize();
  return right ? 0 : 1;
}
