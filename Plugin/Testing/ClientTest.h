// SPDX-License-Identifier: BSD-3-Clause
/// A window of ParaView's client with a view and a source that it shows, for tests of what is in its widgets.
/// They run with the plugin that PV_PLUGIN_PATH holds.
#ifndef ClientTest_h
#define ClientTest_h

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqInterfaceTracker.h"
#include "pqObjectBuilder.h"
#include "pqPVApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqServerResource.h"
#include "pqStandardPropertyWidgetInterface.h"
#include "pqUndoRedoBehavior.h"
#include "pqUndoStack.h"
#include "pqView.h"

#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <QApplication>
#include <QMainWindow>

#include <functional>
#include <iostream>
#include <string>
#include <vector>

class ClientTest
{
public:
  using MakeSource = std::function<pqPipelineSource*(pqObjectBuilder*, pqServer*)>;

  explicit ClientTest(const MakeSource& makeSource)
  {
    pqApplicationCore* core = pqApplicationCore::instance();
    core->interfaceTracker()->addInterface(new pqStandardPropertyWidgetInterface(core->interfaceTracker()));
    new pqUndoRedoBehavior(core);
    this->Window.show();

    pqObjectBuilder* builder = core->getObjectBuilder();
    pqServer* server = builder->createServer(pqServerResource("builtin:"));
    pqPipelineSource* source = makeSource(builder, server);
    source->updatePipeline();
    this->View = builder->createView("RenderView", server);
    this->Representation = builder->createDataRepresentation(source->getOutputPort(0), this->View);
    this->Display = this->Representation->getProxy();
    pqActiveObjects::instance().setActiveServer(server);
    pqActiveObjects::instance().setActiveView(this->View);
    pqActiveObjects::instance().setActiveSource(source);
  }

  /// Runs Test(), made from what is left of the arguments, with its Run(). @return the exit status
  template <class Test>
  static int Run(int argc, char* argv[])
  {
    QApplication application(argc, argv);
    const std::vector<std::string> own(argv + 1, argv + argc);
    // The person's own settings are left alone.
    std::string withoutSettings = "--dr";
    std::vector<char*> arguments{ argv[0], withoutSettings.data(), nullptr };
    int count = 2;
    pqPVApplicationCore core(count, arguments.data());
    return Test(own).Run() ? 0 : 1;
  }

protected:
  void Show(const char* style)
  {
    vtkSMPropertyHelper(this->Display, "Representation").Set(style);
    this->Display->UpdateVTKObjects();
  }

  static pqUndoStack* GetUndoStack() { return pqApplicationCore::instance()->getUndoStack(); }

  bool Check(bool right, const std::string& what)
  {
    std::cout << (right ? "right: " : "WRONG: ") << what << "\n";
    this->Right = this->Right && right;
    return right;
  }

  QMainWindow Window;
  pqView* View;
  pqDataRepresentation* Representation;
  vtkSMProxy* Display;
  bool Right = true;
};

#endif
