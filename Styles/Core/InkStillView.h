// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStillView_h
#define InkStillView_h

#include "vtkSmartPointer.h"

class vtkCamera;
class vtkPlanes;
class vtkPoints;
class vtkPolyData;

/// What a still picture shows: see vtkInkStyle::SetStillCamera.

/// The sides of what it shows, and a tenth of it around, with normals out of it; null if all points are
/// within.
vtkSmartPointer<vtkPlanes> InkSeenRegion(vtkPoints* points, vtkCamera* camera);

/// The cells of a surface that the viewer sees, wherever they look (ink::seenTriangles), with their points
/// and arrays; or all of it, which is the surface itself.
/// @param margin how far the part goes on into what is hidden, as a share of the surface's picture
vtkSmartPointer<vtkPolyData> InkSeenPart(vtkPolyData* surface, vtkCamera* camera, double margin);

#endif
