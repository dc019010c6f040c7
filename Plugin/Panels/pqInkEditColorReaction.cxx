// SPDX-License-Identifier: BSD-3-Clause
#include "pqInkEditColorReaction.h"

#include "pqActiveObjects.h"
#include "pqCoreUtilities.h"
#include "pqDataRepresentation.h"
#include "pqUndoStack.h"

#include "vtkSMPVRepresentationProxy.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"

#include <QColorDialog>

#include <algorithm>
#include <iterator>
#include <string>

namespace
{

/// The property that holds the color of a representation's ink.
struct Ink
{
  const char* Representation;
  const char* Property;
};

constexpr Ink Inks[] = {
  { "Contours", "ContoursInkColor" },
  { "Illustration", "IllustrationInkColor" },
  { "Line Art", "LineArtInkColor" },
  { "Splatting Lines", "InkColor" },
  { "Stipple", "StippleInkColor" },
};

/// Of the ink that all is drawn with now; null: none.
const char* InkProperty(vtkSMProxy* proxy)
{
  if (vtkSMPVRepresentationProxy::GetUsingScalarColoring(proxy))
  {
    return nullptr;
  }
  const std::string shown = vtkSMPropertyHelper(proxy, "Representation", /*quiet=*/true).GetAsString();
  const auto ink = std::find_if(
    std::begin(Inks), std::end(Inks), [&](const Ink& one) { return shown == one.Representation; });
  return ink == std::end(Inks) ? nullptr : ink->Property;
}

void EditColor(vtkSMProxy* proxy, const char* property)
{
  double rgb[3];
  vtkSMPropertyHelper(proxy, property).Get(rgb, 3);
  // Qt's own dialog, as for other solid colors.
  const QColor chosen = QColorDialog::getColor(QColor::fromRgbF(rgb[0], rgb[1], rgb[2]),
    pqCoreUtilities::mainWidget(), QObject::tr("Pick Ink Color"), QColorDialog::DontUseNativeDialog);
  if (chosen.isValid())
  {
    SM_SCOPED_TRACE(PropertiesModified).arg(proxy).arg("comment", " change ink color");
    BEGIN_UNDO_SET(QObject::tr("Changed Ink Color"));
    chosen.getRgbF(&rgb[0], &rgb[1], &rgb[2]);
    vtkSMPropertyHelper(proxy, property).Set(rgb, 3);
    proxy->UpdateVTKObjects();
    END_UNDO_SET();
  }
}

} // namespace

pqInkEditColorReaction::pqInkEditColorReaction(QAction* action, pqDataRepresentation* representation)
  : Superclass(action, /*track_active_objects=*/!representation)
  , Representation(representation)
{
  if (representation)
  {
    this->setRepresentation(representation);
  }
}

void pqInkEditColorReaction::ReplaceBelow(QObject* parent, pqDataRepresentation* representation)
{
  for (pqEditColorMapReaction* reaction : parent->findChildren<pqEditColorMapReaction*>())
  {
    if (!qobject_cast<pqInkEditColorReaction*>(reaction))
    {
      QAction* action = reaction->parentAction();
      delete reaction;
      new pqInkEditColorReaction(action, representation);
    }
  }
}

bool pqInkEditColorReaction::CanHaveInk(vtkSMProxy* representation)
{
  return std::any_of(std::begin(Inks), std::end(Inks),
    [&](const Ink& ink) { return representation->GetProperty(ink.Property) != nullptr; });
}

void pqInkEditColorReaction::onTriggered()
{
  pqDataRepresentation* representation =
    this->Representation ? this->Representation.data() : pqActiveObjects::instance().activeRepresentation();
  const char* property = representation ? InkProperty(representation->getProxy()) : nullptr;
  if (!property)
  {
    this->Superclass::onTriggered();
    return;
  }
  EditColor(representation->getProxy(), property);
  representation->renderViewEventually();
}
