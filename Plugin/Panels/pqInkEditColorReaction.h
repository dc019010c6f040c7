// SPDX-License-Identifier: BSD-3-Clause
#ifndef pqInkEditColorReaction_h
#define pqInkEditColorReaction_h

#include "pqEditColorMapReaction.h"

class pqDataRepresentation;
class vtkSMProperty;
class vtkSMProxy;

/**
 * Edits the color of the ink where ParaView's own reaction would edit the solid color, which our
 * representations have no use for: one of them is shown, and is not colored by an array. Otherwise as
 * ParaView's.
 */
class pqInkEditColorReaction : public pqEditColorMapReaction
{
  Q_OBJECT
  using Superclass = pqEditColorMapReaction;

public:
  /// Takes the place of ParaView's reactions of all actions below the parent. Without a representation they
  /// edit the color of the active one.
  static void ReplaceBelow(QObject* parent, pqDataRepresentation* representation = nullptr);

  /// Whether one of our representations can be chosen for that one.
  static bool CanHaveInk(vtkSMProxy* representation);

protected:
  void onTriggered() override;

private:
  pqInkEditColorReaction(QAction* action, pqDataRepresentation* representation);
  Q_DISABLE_COPY(pqInkEditColorReaction)

  const QPointer<pqDataRepresentation> Representation;
};

#endif
