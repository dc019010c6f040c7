// SPDX-License-Identifier: BSD-3-Clause

// Images of whose arrays none is active, as files of other programs often have it, another one than is
// wanted, or one of several components.
#ifndef InkActiveScalars_h
#define InkActiveScalars_h

#include "vtkInkFiltersCoreModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataSetAttributes;
class vtkImageData;

/// Whether an array has that name which marks of ghosts have, which are no values. @param name or null
VTKINKFILTERSCORE_EXPORT bool InkIsGhostArray(const char* name);

/// Where an array comes among others of which one is used: those of one component first, then by their names,
/// whatever the order in which a file or a process has them. @param name or null
VTKINKFILTERSCORE_EXPORT std::pair<bool, std::string> InkRankOfArray(int components, const char* name);

/// The names of numeric arrays, without those of ghosts.
VTKINKFILTERSCORE_EXPORT std::vector<std::string> InkNamesOfValues(vtkDataSetAttributes* attributes);

/// The numeric array of values that comes first by InkRankOfArray; null if there is none.
VTKINKFILTERSCORE_EXPORT vtkDataArray* InkFirstValues(vtkDataSetAttributes* attributes);

/// Whether an image's points have values, but none of its arrays is active.
VTKINKFILTERSCORE_EXPORT bool InkLacksActiveScalars(vtkImageData* image);

/// The image itself, or one with its arrays of which InkFirstValues of its points is active, or, with a name,
/// that of its points which has it, and none if none has.
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkImageData> InkWithActiveScalars(
  vtkImageData* image, const std::string& array = {});

/// Has a filter take that array of its input's points, or of cells where it takes these; an empty name: the
/// active scalars.
VTKINKFILTERSCORE_EXPORT void InkSelectScalars(vtkAlgorithm* filter, const std::string& array);

/// The image itself, or one whose active scalars are the first component of the image's.
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkImageData> InkWithFirstComponent(vtkImageData* image);

#endif
