// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkEdgeVoxels
 * @brief the voxels of an image that lie on an edge, for silhouettes as segments through voxels
 *
 * Edges are where the image's Laplacian of Gaussian (LoG) changes its sign: of two neighbors with different
 * signs the one that is closer to zero is an edge voxel (Lu et al. 2003, section 5.6). They do not depend on
 * the eye. vtkInkSilhouetteMapper with the method VOXEL_SEGMENTS draws a segment through those that are on a
 * silhouette, and finds on the GPU which these are.
 *
 * The input array is set with SetInputArrayToProcess(0, ...); by default it is the active point scalars.
 *
 * Output: a point, and a vertex, for each edge voxel, in the image's order, with the point arrays `Gradient`
 * (3 components: central differences, in value per world unit), `Value`, and `Radius`, half of a voxel's
 * diagonal. Points are floats where these do for the image's coordinates. The voxels of pieces together are
 * those of the whole image, for any number of threads.
 *
 * Errors, each with an empty output: no such point array, ArrayComponent beyond its components, a spacing of
 * zero or a singular direction matrix.
 *
 * @sa vtkInkContours vtkInkSilhouetteMapper
 */
#ifndef vtkInkEdgeVoxels_h
#define vtkInkEdgeVoxels_h

#include "InkSetters.h"
#include "vtkInkFiltersContoursModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class VTKINKFILTERSCONTOURS_EXPORT vtkInkEdgeVoxels : public vtkPolyDataAlgorithm
{
public:
  static vtkInkEdgeVoxels* New();
  vtkTypeMacro(vtkInkEdgeVoxels, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The component of the array; from 0. Default: 0.
   */
  vtkSetClampMacro(ArrayComponent, int, 0, VTK_INT_MAX);
  vtkGetMacro(ArrayComponent, int);
  ///@}

  ///@{
  /**
   * The standard deviation of the Laplacian's Gaussian, in voxels: fewer edges of noise, and rounder ones,
   * with a larger one. 0 (not smoothed) to 16; default: 1. NaN is refused with a warning.
   */
  InkSetClampMacro(EdgeScale, 0.0, 16.0);
  vtkGetMacro(EdgeScale, double);
  ///@}

  ///@{
  /**
   * Voxels with a smaller gradient magnitude are left out, of which a volume with noise has many; in value
   * per world unit. 0 (default: none is left out but those without a gradient) to 1e38. NaN is refused with a
   * warning.
   */
  InkSetClampMacro(LeastGradientMagnitude, 0.0, 1e38);
  vtkGetMacro(LeastGradientMagnitude, double);
  ///@}

protected:
  vtkInkEdgeVoxels();
  ~vtkInkEdgeVoxels() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkEdgeVoxels(const vtkInkEdgeVoxels&) = delete;
  void operator=(const vtkInkEdgeVoxels&) = delete;

  int ArrayComponent = 0;
  double EdgeScale = 1.0;
  double LeastGradientMagnitude = 0.0;
};

#endif
