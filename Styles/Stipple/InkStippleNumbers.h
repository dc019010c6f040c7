// SPDX-License-Identifier: BSD-3-Clause
/// Of stipples' field data what the mapper needs, as point data: delivery to other processes loses the
/// former.
#ifndef InkStippleNumbers_h
#define InkStippleNumbers_h

class vtkPolyData;

/// @param numbers becomes a point with the numbers, or nothing where there are no stipples
void InkWriteNumbers(vtkPolyData* stipples, vtkPolyData* numbers);

/// Gives stipples their field data back.
void InkReadNumbers(vtkPolyData* numbers, vtkPolyData* stipples);

#endif
