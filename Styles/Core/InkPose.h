// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkPose_h
#define InkPose_h

#include <string>

class vtkPolyData;

/// How a subject is viewed.
struct InkPose
{
  std::string Up = "z";       ///< one of InkOrientation's axes
  std::string View = "front"; ///< one of its views
  double Azimuth = 0.0;       ///< degrees that the viewer goes to the right
  double Elevation = 0.0;     ///< degrees that the viewer is above it
};

/// A guess at how a mesh or a cloud of points stands, of whose axes its file says nothing.
///
/// Up is z, or y where the mesh rests on a clearly larger base then: what it touches the ground with, as a
/// part of what lies below all of it; not, however, if it rests on more with z up, and on a fifth of that at
/// least. OBJ files have y up unless z is clearly better. GIFTI files, which are of brains, have z up, and so
/// have map coordinates: x and y are far away from the origin for its size, and z is not. Of the four sides
/// it is shown from the one from which most of its polygons are seen, without those that are hidden: from the
/// front unless another side shows clearly more, and never along what is long. What lies flat, or on a map,
/// is looked down on; where all that is seen is one flat face, it is seen at an angle.
/// @param file its name, or none
/// @param up where it is known; empty: it is not
InkPose InkFindPose(vtkPolyData* mesh, const std::string& file, const std::string& up);

/// The side from which what is drawn of a volume is seen, whose axes are known: its front, unless that shows
/// so many times less than its left or its top shows, as of a flat animal on its belly or a long skull.
/// @param bounds of what is drawn @param up the axis that is its top
std::string InkFindSideOfFlat(const double bounds[6], const std::string& up, double times);

#endif
