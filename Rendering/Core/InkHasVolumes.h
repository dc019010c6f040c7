// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkHasVolumes_h
#define InkHasVolumes_h

#include "vtkNew.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"

/// Whether a prop is a volume, or has some as parts: they are drawn after all that is translucent.
inline bool InkHasVolumes(vtkProp* prop)
{
  vtkNew<vtkPropCollection> volumes;
  prop->GetVolumes(volumes);
  return volumes->GetNumberOfItems() > 0;
}

/// Whether a visible one of some props is or has.
inline bool InkHasVolumes(vtkPropCollection* props)
{
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    if (prop->GetVisibility() && InkHasVolumes(prop))
    {
      return true;
    }
  }
  return false;
}

#endif
