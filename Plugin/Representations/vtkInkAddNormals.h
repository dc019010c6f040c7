// SPDX-License-Identifier: BSD-3-Clause
/**
 * Normals for the representation "Splatting Lines": of meshes that have none, and at sharp edges.
 */
#ifndef vtkInkAddNormals_h
#define vtkInkAddNormals_h

#include "vtkSmartPointer.h"

class vtkDataObject;

/// The data, of which poly data with polygons, or that of its leaves, have normals as InkWithFeatureNormals
/// makes them: further points of edges follow after all others. The data itself if there is nothing to add.
/// @throws std::invalid_argument for faces of points that there are not
vtkSmartPointer<vtkDataObject> vtkInkAddNormals(vtkDataObject* data);

#endif
