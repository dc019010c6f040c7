// SPDX-License-Identifier: BSD-3-Clause
#include "InkOwnedSamples.h"

#include "InkImageGrid.h"

#include "vtkImageData.h"

ink::SampleBox InkGetOwnedSamples(vtkInformation* input, vtkInformation* output, vtkImageData* image)
{
  if (InkIsOfFirstPiece(input, output, image))
  {
    return {};
  }
  const InkExtent all(image->GetExtent());
  const InkExtent whole = InkGetWholeExtent(input, image);
  ink::SampleBox own{ glm::ivec3(0), all.GetDimensions() };
  for (int axis = 0; axis < 3; ++axis)
  {
    own.end[axis] -= all.Last[axis] != whole.Last[axis] ? 1 : 0;
  }
  return own;
}
