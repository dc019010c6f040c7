// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkPointPriority
 * @brief sorts points into progressive order, in which every prefix is evenly distributed
 *
 * Takes any points, with or without normals: iso-surface samples of vtkInkIsoSurfaceSampler, scans, vertices
 * of a mesh. Sorts them so that for every k the first k points have a blue-noise distribution, as far as the
 * points allow (see ink::progressiveOrder), and adds the point array `Priority`: a float in [0, 1), i / n for
 * the i-th point of n. Drawing only the points with a priority below p, or the first p n points, thins them
 * out evenly, and nothing is recomputed when p changes. All point arrays are passed on; cells are not.
 *
 * `Normals` keep points of different sides or sheets from counting as neighbors. Where missing, they are
 * estimated from the sixteen nearest points, consistently oriented and outwards on closed surfaces, unless
 * EstimateNormals is off. With a point array `Radius`, distances between points are kept in proportion to it.
 *
 * The same input gives the same output for any number of threads. In parallel each piece is sorted by itself:
 * the points below a priority are evenly distributed in each piece, and equally dense in all pieces if the
 * points are.
 *
 * Coincident points, and points that are not finite, come last. Points that `vtkGhostType` marks as hidden or
 * duplicate are removed.
 *
 * @sa vtkInkIsoSurfaceSampler vtkInkSurfaceSampler
 */
#ifndef vtkInkPointPriority_h
#define vtkInkPointPriority_h

#include "vtkInkFiltersSamplingModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class VTKINKFILTERSSAMPLING_EXPORT vtkInkPointPriority : public vtkPolyDataAlgorithm
{
public:
  static vtkInkPointPriority* New();
  vtkTypeMacro(vtkInkPointPriority, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The random seed: each gives a different order of the same quality. Default: 0.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Estimate the point array `Normals` if the input has none. Default: on.
   */
  vtkSetMacro(EstimateNormals, bool);
  vtkGetMacro(EstimateNormals, bool);
  vtkBooleanMacro(EstimateNormals, bool);
  ///@}

  ///@{
  /**
   * Estimate the point array `Radius` if the input has none, from each point's distances to its neighbors
   * (see ink::pointRadii); 0 for isolated points. Default: on.
   */
  vtkSetMacro(EstimateRadius, bool);
  vtkGetMacro(EstimateRadius, bool);
  vtkBooleanMacro(EstimateRadius, bool);
  ///@}

  ///@{
  /**
   * Make one poly-vertex cell over all points, so that any VTK mapper draws them. Default: on.
   */
  vtkSetMacro(GenerateVertices, bool);
  vtkGetMacro(GenerateVertices, bool);
  vtkBooleanMacro(GenerateVertices, bool);
  ///@}

protected:
  vtkInkPointPriority();
  ~vtkInkPointPriority() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkPointPriority(const vtkInkPointPriority&) = delete;
  void operator=(const vtkInkPointPriority&) = delete;

  int Seed = 0;
  bool EstimateNormals = true;
  bool EstimateRadius = true;
  bool GenerateVertices = true;
};

#endif
