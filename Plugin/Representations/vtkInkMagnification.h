// SPDX-License-Identifier: BSD-3-Clause
/**
 * How large data is seen in a view, for the number of its marks to follow, in steps: each of twice the size
 * of the one before.
 */
#ifndef vtkInkMagnification_h
#define vtkInkMagnification_h

class vtkBoundingBox;
class vtkRenderer;

/**
 * How large data is seen, relative to a view whose height the sphere around its bounds fills: what of it
 * faces the eye, half of the sphere's radius before its middle. Less in views of less than 500 pixels in
 * height, as no mark need be finer than half a pixel.
 * @param bounds of the data; not those of its marks, which others change
 * @return above 0, infinite where the eye is in the data; 0 if it is not in the view, or is a point
 */
double vtkInkFindMagnification(vtkRenderer* renderer, const vtkBoundingBox& bounds);

/**
 * The step of a magnification: -3 to 3, each for those nearest to 2^step, by ratio. It stays what it was up
 * to 1.4 times beyond these, so that it does not change to and fro.
 * @param before the step so far
 */
int vtkInkFollowMagnification(int before, double magnification);

#endif
