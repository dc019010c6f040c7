// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkNotFiniteFaces_h
#define InkNotFiniteFaces_h

#include "vtkInkFiltersCoreModule.h" // for the export macro

#include <string>

class vtkObject;
class vtkPolyData;

/// Warns where some of a mesh's polygons and strips have points that are not finite, and so are left out: how
/// many. Not where all have, which InkMeshTriangles::Check refuses.
VTKINKFILTERSCORE_EXPORT void InkWarnOfNotFiniteFaces(vtkObject* filter, vtkPolyData* mesh);

/// Why a mesh has no face that could be used; empty if it has one, or no faces at all.
std::string InkDescribeNoFiniteFace(vtkPolyData* mesh);

#endif
