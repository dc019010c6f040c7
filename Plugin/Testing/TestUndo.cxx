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

#include <array>
#include <iostream>
#include <string>

namespace
{

constexpr std::array Names{ "StipplePreset", "StippleGradient", "StippleInterior", "BoundaryBase",
  "SilhouetteGain", "InteriorExponent" };
using Values = std::array<double, Names.size()>;

Values ValuesOf(vtkSMProxy* display)
{
  Values values;
  for (std::size_t i = 0; i < Names.size(); ++i)
  {
    values[i] = vtkSMPropertyHelper(display, Names[i]).GetAsDouble();
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

bool Test()
{
  vtkNew<vtkSMParaViewPipelineController> controller;
  vtkSMSession* session = vtkSMSession::New();
  vtkProcessModule::GetProcessModule()->RegisterSession(session);
  controller->InitializeSession(session);
  vtkSMSessionProxyManager* manager = session->GetSessionProxyManager();
  auto source = vtkSmartPointer<vtkSMProxy>::Take(manager->NewProxy("sources", "SphereSource"));
  source->UpdateVTKObjects();

  vtkNew<vtkSMUndoStack> stack;
  vtkNew<vtkSMUndoStackBuilder> builder;
  builder->SetUndoStack(stack);
  vtkSMProxyManager::GetProxyManager()->SetUndoStackBuilder(builder);
  vtkSmartPointer<vtkSMProxy> display = MakeDisplay(manager, source);
  const double before = vtkSMPropertyHelper(display, "SilhouetteGain").GetAsDouble();
  Set(display, "StipplePreset", 3);
  bool right =
    Check(vtkSMPropertyHelper(display, "SilhouetteGain").GetAsDouble() != before, "a preset sets the others");
  Set(display, "BoundaryBase", 0.35);
  Set(display, "StippleInterior", 0.9);
  const Values byHand = ValuesOf(display);

  builder->Begin("preset");
  Set(display, "StipplePreset", 1);
  builder->End();
  builder->PushToStack();
  const Values preset = ValuesOf(display);
  right &= Check(preset != byHand, "another preset sets them anew");
  stack->Undo();
  right &= Check(ValuesOf(display) == byHand, "undo brings back what was set by hand");
  stack->Redo();
  right &= Check(ValuesOf(display) == preset, "redo brings back the preset");
  vtkSMProxyManager::GetProxyManager()->SetUndoStackBuilder(nullptr);
  stack->Clear();

  vtkSmartPointer<vtkSMProxy> other = MakeDisplay(manager, source);
  Set(display, "SilhouetteGain", vtkSMPropertyHelper(other, "SilhouetteGain").GetAsDouble());
  vtkNew<vtkSMProxyClipboard> clipboard;
  right &= Check(clipboard->Copy(display) && clipboard->Paste(other), "copy and paste");
  right &= Check(ValuesOf(other) == ValuesOf(display), "paste sets what was copied");

  clipboard->Clear();
  other = nullptr;
  display = nullptr;
  source = nullptr;
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
