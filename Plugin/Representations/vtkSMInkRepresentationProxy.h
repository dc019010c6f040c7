// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMInkRepresentationProxy
 * @brief   tells a server, before it draws, whether the client makes a picture on a transparent background
 *
 * ParaView's server draws on nothing, for the client to lay its picture over the background, and so need not
 * know. Where there is paper, which the server draws itself, it has to.
 *
 * @sa vtkInkRepresentation
 */
#ifndef vtkSMInkRepresentationProxy_h
#define vtkSMInkRepresentationProxy_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkSMRepresentationProxy.h"
#include "vtkWeakPointer.h" // for the view

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkSMInkRepresentationProxy : public vtkSMRepresentationProxy
{
public:
  static vtkSMInkRepresentationProxy* New();
  vtkTypeMacro(vtkSMInkRepresentationProxy, vtkSMRepresentationProxy);

  void ViewUpdated(vtkSMProxy* view) override;

protected:
  vtkSMInkRepresentationProxy();
  ~vtkSMInkRepresentationProxy() override;

private:
  vtkSMInkRepresentationProxy(const vtkSMInkRepresentationProxy&) = delete;
  void operator=(const vtkSMInkRepresentationProxy&) = delete;

  void Listen(vtkSMProxy* view);
  void SendTransparentBackground();

  vtkWeakPointer<vtkSMProxy> View;
  unsigned long Observer = 0;
};

#endif
