// SPDX-License-Identifier: BSD-3-Clause
#include "pqInkLiveSliders.h"

#include "pqInkLiveSlider.h"

pqInkLiveSliders::pqInkLiveSliders(QObject* parent)
  : QObject(parent)
{
}

void pqInkLiveSliders::createDefaultWidgetDecorators(pqPropertyWidget* widget)
{
  pqInkLiveSlider::Attach(widget);
}
