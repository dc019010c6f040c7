// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkFeatureNormals_h
#define InkFeatureNormals_h

#include "vtkInkFiltersCoreModule.h" // for the export macro
#include "vtkSmartPointer.h"

class vtkPolyData;

/// A mesh with point normals that are those of one side at feature edges (ink::cutFeatures), where points are
/// repeated for each side after all others, with all their values but global ids, and InkSourcePoints. Cells
/// stay in their order, but strips become triangles, and all polygons beside strips.
///
/// Without normals (InkPointNormals) they are computed, as InkMeshTriangles does, and polygons turned the
/// same way round as their neighbors. Given ones are kept but where they enclose more than
/// ink::defaultFeatureAngle with that of a side: such means are nobody's normals. A mesh with normals and
/// without such points is returned itself.
/// @throws std::invalid_argument as InkMeshTriangles does
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkPolyData> InkWithFeatureNormals(vtkPolyData* mesh);

/// Whether points that share a position have normals that enclose more than ink::defaultFeatureAngle.
VTKINKFILTERSCORE_EXPORT bool InkHasFeatureEdges(vtkPolyData* mesh);

#endif
