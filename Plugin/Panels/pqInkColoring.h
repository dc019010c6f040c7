// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqInkColoring_h
#define pqInkColoring_h

#include "pqContextMenuInterface.h"
#include "pqPropertyWidgetInterface.h"

#include <QObject>

/**
 * Wherever ParaView's client offers to edit a representation's solid color, has it edit the color of our
 * representations' ink: in the panel, in the toolbar and in the views' context menu. ParaView's solid color,
 * which its other representations share, stays theirs.
 *
 * @sa pqInkEditColorReaction
 */
class pqInkColoring
  : public QObject
  , public pqPropertyWidgetInterface
  , public pqContextMenuInterface
{
  Q_OBJECT
  Q_INTERFACES(pqPropertyWidgetInterface pqContextMenuInterface)

public:
  explicit pqInkColoring(QObject* parent);

  /// ParaView's panel "Coloring". Plugins are asked for widgets before ParaView itself.
  pqPropertyWidget* createWidgetForPropertyGroup(
    vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent) override;

  using pqContextMenuInterface::contextMenu;
  /// Called when ParaView has made its menu.
  bool contextMenu(QMenu* menu, pqView* view, const QPoint& position, pqRepresentation* representation,
    const QStringList& blocks) const override;

private:
  Q_DISABLE_COPY(pqInkColoring)
};

#endif
