// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeHeader.h"

#include "vtkType.h"

#include <cmath>

namespace ink::io
{

int VolumeHeader::valueType() const
{
  return !this->sliceScales.empty() ? VTK_FLOAT
    : this->isScaled()              ? scaledType(this->voxels.type, this->scale)
                                    : this->voxels.type;
}

void VolumeHeader::scaleValues(vtkImageData* image) const
{
  if (!this->sliceScales.empty())
  {
    scaleSlices(image, this->sliceScales);
  }
  else if (this->isScaled())
  {
    io::scaleValues(image, this->scale);
  }
}

double spacingOf(double given)
{
  return std::isfinite(given) && given != 0.0 ? std::abs(given) : 1.0;
}

} // namespace ink::io
