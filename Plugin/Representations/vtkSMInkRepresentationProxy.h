// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMInkRepresentationProxy
 * @brief   tells a server, before it draws, what only the client knows of the picture
 *
 * How large the marks are seen: still pictures ask for as many as they have room for, in steps of two
 * (vtkInkMagnification.h). Pictures of an interaction change nothing, so that nothing is made again while the
 * camera moves. All processes are told the same step.
 *
 * And whether the picture's background is transparent. ParaView's server draws on nothing, for the client to
 * lay its picture over the background, and so need not know. Where there is paper, which the server draws
 * itself, it has to.
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

  void AddConsumer(vtkSMProperty* property, vtkSMProxy* consumer) override;

  /// See vtkInkRepresentation. No property: no state, trace or undo holds it.
  void SetPreview(bool preview);

protected:
  vtkSMInkRepresentationProxy();
  ~vtkSMInkRepresentationProxy() override;

private:
  vtkSMInkRepresentationProxy(const vtkSMInkRepresentationProxy&) = delete;
  void operator=(const vtkSMInkRepresentationProxy&) = delete;

  void Listen(vtkSMProxy* view);
  /// Calls a method of vtkInkRepresentation on all processes.
  template <class Value>
  void Send(const char* method, Value value);
  void StartPicture(vtkObject* view, unsigned long event, void* interactive);
  void EndPicture(vtkObject* view, unsigned long event, void* interactive);
  /// Of the data, see vtkInkMagnification.h; 0: not known.
  double FindMagnification();
  /// Sends the step of the magnification. @return whether it is another one
  bool FollowView();

  vtkWeakPointer<vtkSMProxy> View;
  unsigned long Start = 0; ///< observes the view
  unsigned long End = 0;   ///< observes the view
  int Step = 0;
};

#endif
