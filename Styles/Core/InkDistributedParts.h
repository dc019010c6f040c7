// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkDistributedParts_h
#define InkDistributedParts_h

#include "IsoSurface/ActiveCellComponents.h"

class InkStyleProcesses;
class vtkPolyData;

/**
 * Removes the points of parts of iso-surfaces that are not selected of the whole, of which each process has a
 * piece; all processes call it at once. Every process needs memory for the cells of all.
 *
 * @param surfaces how many there are; selected from one by one
 * @param points with the point arrays CellId and, of several surfaces, SurfaceIndex, which are removed.
 *   Without CellId, or null: none of them takes part
 */
void InkKeepPartsOfAll(
  InkStyleProcesses& processes, const ink::ComponentSelection& selection, int surfaces, vtkPolyData* points);

#endif
