// SPDX-License-Identifier: BSD-3-Clause
#include "pqInkColoring.h"

#include "pqApplicationCore.h"
#include "pqColorEditorPropertyWidget.h"
#include "pqCoreUtilities.h"
#include "pqDataRepresentation.h"
#include "pqInkEditColorReaction.h"
#include "pqServerManagerModel.h"

#include "vtkSMPropertyGroup.h"

#include <QMenu>
#include <QString>
#include <QToolBar>

namespace
{

void ReplaceInToolBars(pqRepresentation* representation)
{
  const QWidget* window = pqCoreUtilities::mainWidget();
  if (window && pqInkEditColorReaction::CanHaveInk(representation->getProxy()))
  {
    for (QToolBar* toolBar : window->findChildren<QToolBar*>())
    {
      pqInkEditColorReaction::ReplaceBelow(toolBar);
    }
  }
}

} // namespace

pqInkColoring::pqInkColoring(QObject* parent)
  : QObject(parent)
{
  // Plugins are loaded before or after ParaView makes its window; there is one when there are
  // representations.
  QObject::connect(pqApplicationCore::instance()->getServerManagerModel(),
    &pqServerManagerModel::representationAdded, this, ReplaceInToolBars);
}

pqPropertyWidget* pqInkColoring::createWidgetForPropertyGroup(
  vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent)
{
  if (QString(group->GetPanelWidget()) != "ColorEditor" || !pqInkEditColorReaction::CanHaveInk(proxy))
  {
    return nullptr;
  }
  auto widget = new pqColorEditorPropertyWidget(proxy, parent);
  const pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  pqInkEditColorReaction::ReplaceBelow(widget, model->findItem<pqDataRepresentation*>(proxy));
  return widget;
}

bool pqInkColoring::contextMenu(
  QMenu* menu, pqView*, const QPoint&, pqRepresentation*, const QStringList&) const
{
  pqInkEditColorReaction::ReplaceBelow(menu);
  return false;
}
