// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkHatching
 * @brief   makes lines on a surface into strokes of hatching
 *
 * Gives lines what vtkInkStrokeMapper needs to make tones of them, whatever the camera and the light: how far
 * all lines of a family are from each other, so that a gray is the same at any zoom; and an order in which
 * they are dropped. Lines can be cut into shorter strokes, as a hand draws them.
 *
 * Input: lines, as vtkInkLinesOfCurvature makes them, with the cell arrays `Priority` (the share of the
 * family's total length that comes before a line; without it, lines are dropped by chance, as in Rössl et al.
 * 2000, section 3.2) and `LineFamily` (without it, all are of one), and the point normals. Second input: the
 * surface that they cover, which is not needed where Spacing is set.
 *
 * Output: the lines' points with their arrays; lines, of points that are about two spacings apart where the
 * input's are closer, or half a spacing where lines turn, with their cell arrays, `Priority`, `LineFamily`,
 * and `Spacing` (float), the distance between all lines of the family in world units: the surface's area
 * divided by their length; and, with LocalSpacing, the point array `SpacingRatio`. Vertices, polygons and
 * strips are left out. The result is the same for any number of threads. Errors, each with an empty output:
 * no surface with an area and no Spacing, arrays of a wrong size.
 *
 * @sa vtkInkLinesOfCurvature vtkInkStrokeMapper
 */
#ifndef vtkInkHatching_h
#define vtkInkHatching_h

#include "InkSetters.h"                 // for the setters
#include "vtkInkFiltersStrokesModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the region

class vtkPlanes;

struct InkMeshTriangles;

class VTKINKFILTERSSTROKES_EXPORT vtkInkHatching : public vtkPolyDataAlgorithm
{
public:
  static vtkInkHatching* New();
  vtkTypeMacro(vtkInkHatching, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The surface that the lines cover. Default: none.
   */
  void SetSurfaceData(vtkPolyData* surface) { this->SetInputData(1, surface); }
  void SetSurfaceConnection(vtkAlgorithmOutput* surface) { this->SetInputConnection(1, surface); }
  ///@}

  ///@{
  /**
   * The distance between all lines of each family, in world units. 0 (default) to 1e300; 0: the surface's
   * area divided by their length.
   */
  InkSetClampMacro(Spacing, 0.0, 1e300);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Whether strokes know how far they are from each other around each of their points, so that grays are
   * right where lines are closer or wider apart than elsewhere: the point array `SpacingRatio` (float, 8
   * components), this distance relative to `Spacing`, when all strokes are drawn in full and, half an octave
   * after the other, fewer of them down to a tenth (ink::hatching::localSpacing); between 1/2 and 2. Default:
   * on. Off, or where Spacing is set: all of a family have one distance, as published.
   */
  vtkSetMacro(LocalSpacing, bool);
  vtkGetMacro(LocalSpacing, bool);
  vtkBooleanMacro(LocalSpacing, bool);
  ///@}

  ///@{
  /**
   * Where the lines are, if not all over the surface: vtkInkLinesOfCurvature::SetRegion. Default: none.
   */
  void SetRegion(vtkPlanes* region);
  vtkPlanes* GetRegion();
  ///@}

  ///@{
  /**
   * About how long strokes are at most, in world units: longer lines are cut, at points that they have.
   * Shorter strokes look more like sketched by hand. 0 (default) to 1e300; 0: lines are not cut.
   */
  InkSetClampMacro(StrokeLength, 0.0, 1e300);
  vtkGetMacro(StrokeLength, double);
  ///@}

  ///@{
  /**
   * Another seed gives other cuts, and other lines that are dropped where these have no `Priority`. Default:
   * 0.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkInkHatching();
  ~vtkInkHatching() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkHatching(const vtkInkHatching&) = delete;
  void operator=(const vtkInkHatching&) = delete;

  void MakeStrokes(vtkPolyData* data, vtkPolyData* surface, vtkPolyData* output);
  /// The array `SpacingRatio` of strokes on a surface.
  void AddSpacingRatios(const InkMeshTriangles& triangles, vtkPolyData* output);

  double Spacing = 0.0;
  bool LocalSpacing = true;
  double StrokeLength = 0.0;
  int Seed = 0;
  vtkSmartPointer<vtkPlanes> Region;
};

#endif
