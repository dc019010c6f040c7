// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqInkLiveSlider_h
#define pqInkLiveSlider_h

#include "vtkSMTrace.h"
#include "vtkWeakPointer.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <memory>

class QSlider;
class pqPropertyWidget;
class pqView;
class vtkSMInkRepresentationProxy;

/**
 * Pictures that follow a slider while it is dragged, where ParaView waits until it is let go: of one of our
 * representations' properties. An image's surface is made of fewer of its points then (see
 * vtkInkRepresentation::SetPreview), of all at last. A slider whose picture took too long for that is
 * followed no more.
 *
 * All that one drag changes is undone at once, and one entry of a trace.
 */
class pqInkLiveSlider : public QObject
{
  Q_OBJECT

public:
  /// Follows the slider of a widget; none where the widget has no slider, or is no representation's of ours.
  static void Attach(pqPropertyWidget* widget);

  ~pqInkLiveSlider() override;

private:
  Q_DISABLE_COPY(pqInkLiveSlider)

  pqInkLiveSlider(pqPropertyWidget* widget, QSlider* slider);

  void Start();
  void Follow();
  void Stop();

  pqPropertyWidget* const Widget;
  // Of the drag: the widget may be half gone when this is.
  QPointer<pqView> View;
  vtkWeakPointer<vtkSMInkRepresentationProxy> Owner;
  QTimer Wait;                                  ///< until all that has happened to the slider is known
  std::unique_ptr<vtkSMTrace::TraceItem> Trace; ///< null: it is not dragged
  bool IsQuick = true;
};

#endif
