#pragma once

#include "View.h"

class vtkCamera;
class vtkPoints;

namespace ink::cli
{

/// Places camera so that all points just fit into the picture.
///
/// With a perspective camera the points themselves are fitted into the four sides of the view, not their
/// bounding sphere: each side asks for one distance, and opposite sides share the centre.
///
/// \param points at least one finite; others are skipped.
/// \param aspect width of the picture by its height.
/// \param margin the part of the picture's half width and height that stays free, 0 to 1.
/// \param parallel parallel instead of perspective projection.
void fitCamera(
  vtkCamera* camera, const View& view, vtkPoints* points, double aspect, double margin, bool parallel);

} // namespace ink::cli
