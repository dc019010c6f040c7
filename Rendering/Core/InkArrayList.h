// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkArrayList_h
#define InkArrayList_h

#include "vtkInkRenderingCoreModule.h" // for the export macro

#include <string>

class vtkFieldData;

/// The arrays that some data have, for messages about those that they lack: "Normals" (3), "Value" (1), ...
VTKINKRENDERINGCORE_EXPORT std::string InkListArrays(vtkFieldData* data);

#endif
