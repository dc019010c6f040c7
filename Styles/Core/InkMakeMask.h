// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkMakeMask_h
#define InkMakeMask_h

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

/// Which labels are at or above an iso-value: 1, others 0, in an array of the labels' type. Values that are
/// not finite stay.
/// @param labels of one component
vtkSmartPointer<vtkDataArray> InkMakeMask(vtkDataArray* labels, double isoValue);

#endif
