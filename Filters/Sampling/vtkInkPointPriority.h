// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkPointPriority
 * @brief   orders points so that every beginning of the list is spread evenly
 *
 * Takes any points, with normals or without: iso-surface samples of vtkInkIsoSurfaceSampler, scans, vertices
 * of a mesh. Gives them back in an order in which the first k of them are for every k a blue noise,
 * as far as the points allow (see ink::priorityOrder), with the point array `Priority`: a float from 0 to
 * below 1, i / n for the i-th point of n. So drawing the points of a priority below p, or the first p n
 * points, thins them out evenly, and nothing needs to be computed again when p changes. All point arrays are
 * carried along; cells are not.
 *
 * `Normals` keep points of different sides or sheets from counting as neighbors. Where there are none they
 * are estimated from the sixteen nearest points, to the same side all over and outwards on closed surfaces,
 * unless EstimateNormals is off. Where there is a point array `Radius`, points keep their distances in
 * proportion to it.
 *
 * The same input gives the same output on any number of threads. In parallel each piece's points are ordered
 * for themselves: those below a priority are spread evenly in each, and as densely in one as in another when
 * the points are.
 *
 * Points at one place, and points that are not finite, come last. Those that `vtkGhostType` marks as hidden
 * or duplicate are left out.
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
   * Another seed gives another order, just as good. Default: 0.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Estimate the point array `Normals` where there is none. Default: on.
   */
  vtkSetMacro(EstimateNormals, bool);
  vtkGetMacro(EstimateNormals, bool);
  vtkBooleanMacro(EstimateNormals, bool);
  ///@}

  ///@{
  /**
   * Estimate the point array `Radius` where there is none, each from the distances to its neighbors (see
   * ink::pointRadii); 0 for points that belong to no surface. Default: on.
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
