// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTubes_h
#define InkTubes_h

#include "vtkInkStylesModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;

/// Whether it is drawn as InkMakeTubes makes of it: it has lines, and neither polygons nor discs as a sampler
/// makes them (InkHasDiscs).
bool InkIsOfLines(vtkPolyData* mesh);

/**
 * Lines as tubes around them, of triangles, with the values of their points and cells, and InkSourcePoints.
 * Two lines that end at one point, where no other does, are one, but where cells have values. Segments
 * without length, to points that are not finite, and those that are there already are left out.
 *
 * Their radius is that which an array of the points says, "MaximumInscribedSphereRadius" as of center lines
 * of vessels, or "radius" in letters of any case, where it has a value above 0 and none below; or else it is
 * .003 of the diagonal of the box around them, in which a picture of them shows each.
 * @param note what was drawn, in words
 * @return without points if no line has a length
 */
VTKINKSTYLES_EXPORT vtkSmartPointer<vtkPolyData> InkMakeTubes(vtkPolyData* lines, std::string& note);

#endif
