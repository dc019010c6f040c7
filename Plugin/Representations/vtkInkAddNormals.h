// SPDX-License-Identifier: BSD-3-Clause
/**
 * Normals for the representation "Splatting Lines", of meshes that have none.
 */
#ifndef vtkInkAddNormals_h
#define vtkInkAddNormals_h

#include "vtkSmartPointer.h"

class vtkDataObject;

/// The data, where its poly data with polygons, or that of its leaves, have no point normals with those of
/// the polygons around each point; the points stay the same ones. The data itself if there is nothing to add.
vtkSmartPointer<vtkDataObject> vtkInkAddNormals(vtkDataObject* data);

#endif
