// SPDX-License-Identifier: BSD-3-Clause
/**
 * From a data object to stipples. The surfaces of all data of all processes are put together and stippled by
 * the first process: of images their iso-surfaces, of other data the outer ones, or that which discs around
 * points cover. Images whose voxels are stippled are so with percentiles and ranges of all processes' images
 * together, so that parts of an image with ghost cells give exactly what the whole does. Where no process has
 * an image, data that is stipples already is taken as it is.
 */
#ifndef InkStippleRecipe_h
#define InkStippleRecipe_h

#include "vtkInkStippleStyle.h"

#include <string>
#include <vector>

class InkIsoSurface;
class vtkCellData;
class vtkDataSet;
class vtkImageData;
class vtkPolyData;
struct InkLeaves;

class InkStippleRecipe
{
public:
  explicit InkStippleRecipe(vtkInkStippleStyle* style);

  /// Fills the style's pieces and what it says of them. @return what is wrong
  std::string Make(const vtkInkStyle::Input& input);

private:
  struct Source;

  /// @return false if that is not asked for and there is no iso-value
  bool StippleIsoSurfaces(const InkLeaves& leaves, const vtkInkStyle::Input& input);
  /// The surface of images whose silhouettes are asked for, of an iso-surface that is prepared.
  void OutlineImages(const InkLeaves& leaves, InkIsoSurface& isoSurface);
  void StippleVoxels(const InkLeaves& leaves, const vtkInkStyle::Input& input);
  /// As the style's own, of images whose surface is not stippled.
  void SetUp(InkIsoSurface& isoSurface) const;
  /// The silhouettes of images whose voxels are stippled, where they are asked for.
  void OutlineVoxels(const InkLeaves& leaves);
  /// Lets the generator use percentiles and ranges of all processes' images together. @return those that were
  /// measured, or need not be
  std::vector<vtkImageData*> MeasureImages(const InkLeaves& leaves, const Source& source);
  void StippleSurfaces(const InkLeaves& leaves);
  /// Stipples polygons, or points with normals.
  void StippleSurface(vtkPolyData* mesh);
  void TakeStipples(const InkLeaves& leaves);
  /// Lets the generator pass on the array to color by, where the data has it.
  void TakeColors(vtkDataSet* data, bool cells);
  /// Activates the array to color ready stipples by.
  void ColorStipples(vtkCellData* cells);
  void Say(const std::string& problem);

  vtkInkStippleStyle* const Style;
  vtkInkStippleGenerator* const Generator;
  std::string Problem;
};

#endif
