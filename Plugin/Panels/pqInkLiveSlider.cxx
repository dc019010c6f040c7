// SPDX-License-Identifier: BSD-3-Clause
#include "pqInkLiveSlider.h"

#include "pqPropertyWidget.h"
#include "pqUndoStack.h"
#include "pqView.h"

#include "vtkSMInkRepresentationProxy.h"
#include "vtkSMProperty.h"

#include <QElapsedTimer>
#include <QSlider>

namespace
{

/// No one waits for longer while dragging.
constexpr qint64 MostMilliseconds = 1500;

vtkSMInkRepresentationProxy* OwnerOf(const pqPropertyWidget* widget)
{
  vtkSMProperty* property = widget->property();
  return property ? vtkSMInkRepresentationProxy::SafeDownCast(property->GetParent()) : nullptr;
}

} // namespace

void pqInkLiveSlider::Attach(pqPropertyWidget* widget)
{
  auto slider = OwnerOf(widget) ? widget->findChild<QSlider*>() : nullptr;
  if (slider)
  {
    new pqInkLiveSlider(widget, slider);
  }
}

pqInkLiveSlider::pqInkLiveSlider(pqPropertyWidget* widget, QSlider* slider)
  : QObject(slider)
  , Widget(widget)
{
  this->Wait.setSingleShot(true);
  QObject::connect(&this->Wait, &QTimer::timeout, this, &pqInkLiveSlider::Follow);
  QObject::connect(slider, &QSlider::sliderPressed, this, &pqInkLiveSlider::Start);
  QObject::connect(slider, &QSlider::valueChanged, this,
    [this]
    {
      if (this->Trace && this->IsQuick)
      {
        this->Wait.start(0);
      }
    });
  // ParaView's widget has taken the last value when this is called, as it was connected first.
  QObject::connect(slider, &QSlider::sliderReleased, this, &pqInkLiveSlider::Stop);
}

pqInkLiveSlider::~pqInkLiveSlider()
{
  this->Stop();
}

void pqInkLiveSlider::Start()
{
  if (this->Trace || !this->Widget->view())
  {
    return;
  }
  this->View = this->Widget->view();
  this->Owner = OwnerOf(this->Widget);
  BEGIN_UNDO_SET(QObject::tr("Property Changed"));
  this->Trace = std::make_unique<vtkSMTrace::TraceItem>("PropertiesModified");
  *this->Trace = vtkSMTrace::TraceItemArgs().arg("proxy", this->Widget->proxy());
  this->Owner->SetPreview(true);
}

void pqInkLiveSlider::Follow()
{
  QElapsedTimer clock;
  clock.start();
  const QPointer<pqInkLiveSlider> self = this;
  this->Widget->apply();
  if (this->View)
  {
    this->View->forceRender();
  }
  if (self)
  {
    this->IsQuick = clock.elapsed() <= MostMilliseconds;
  }
}

void pqInkLiveSlider::Stop()
{
  if (!this->Trace)
  {
    return;
  }
  this->Wait.stop();
  if (this->Owner)
  {
    this->Owner->SetPreview(false);
  }
  this->Trace.reset();
  END_UNDO_SET();
  if (this->View)
  {
    this->View->render();
  }
}
