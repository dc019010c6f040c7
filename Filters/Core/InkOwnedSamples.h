// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkOwnedSamples_h
#define InkOwnedSamples_h

#include "Fields/SampleBox.h"

#include "vtkInkFiltersCoreModule.h" // for the export macro

class vtkImageData;
class vtkInformation;

/// The samples whose voxels the requested piece owns: the lower corners of its cells, and at the upper end of
/// the whole image the last ones, too. ink::PieceOwnership excludes those that the part marks as another
/// piece's.
/// @param input, output the filter's pipeline information
VTKINKFILTERSCORE_EXPORT ink::SampleBox InkGetOwnedSamples(
  vtkInformation* input, vtkInformation* output, vtkImageData* image);

#endif
