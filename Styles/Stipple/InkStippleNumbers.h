// SPDX-License-Identifier: BSD-3-Clause
/// Of stipples' field data what the mapper needs, as point data: delivery to other processes loses the
/// former.
#ifndef InkStippleNumbers_h
#define InkStippleNumbers_h

class vtkPolyData;

/// @param room by how much a stipple's room is multiplied, a number more
/// @param numbers becomes a point with the numbers, or nothing where there are no stipples
void InkWriteNumbers(vtkPolyData* stipples, double room, vtkPolyData* numbers);

/// Gives stipples their field data back. @return the room
double InkReadNumbers(vtkPolyData* numbers, vtkPolyData* stipples);

#endif
