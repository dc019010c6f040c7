// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqInkLiveSliders_h
#define pqInkLiveSliders_h

#include "pqPropertyWidgetInterface.h"

#include <QObject>

/**
 * Has pictures follow the sliders of all panels that ParaView makes for our representations.
 *
 * @sa pqInkLiveSlider
 */
class pqInkLiveSliders
  : public QObject
  , public pqPropertyWidgetInterface
{
  Q_OBJECT
  Q_INTERFACES(pqPropertyWidgetInterface)

public:
  explicit pqInkLiveSliders(QObject* parent);

  /// Called for each widget of a property.
  void createDefaultWidgetDecorators(pqPropertyWidget* widget) override;

private:
  Q_DISABLE_COPY(pqInkLiveSliders)
};

#endif
