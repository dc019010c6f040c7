// SPDX-License-Identifier: BSD-3-Clause
/**
 * From a data object to stipples. Images are stippled with percentiles and ranges of all processes' images
 * together, so that parts of an image with ghost cells give exactly what the whole does. Where no process has
 * an image, data that is stipples already is taken as it is. Where there is neither, the outer surfaces of
 * all data of all processes are put together and stippled by the first process.
 */
#ifndef InkStippleRecipe_h
#define InkStippleRecipe_h

#include "vtkInkStippleStyle.h"

#include <string>
#include <vector>

class vtkCellData;
class vtkDataSet;
class vtkImageData;
struct InkStippleLeaves;

class InkStippleRecipe
{
public:
  explicit InkStippleRecipe(vtkInkStippleStyle* style);

  /// Fills the style's pieces and what it says of them. @return what is wrong
  std::string Make(const vtkInkStyle::Input& input);

private:
  void StippleImages(const InkStippleLeaves& leaves, const vtkInkStyle::Input& input);
  void StippleSurfaces(const InkStippleLeaves& leaves);
  void TakeStipples(const InkStippleLeaves& leaves);
  /// Lets the generator pass on the array to color by, where the data has it.
  void TakeColors(vtkDataSet* data, bool cells);
  /// The iso-values whose surface hides what lies behind it: where none is given, one that is chosen.
  void ChooseHidingValues(const InkStippleLeaves& leaves, bool whole);
  /// Activates the array to color ready stipples by.
  void ColorStipples(vtkCellData* cells);
  vtkSmartPointer<vtkPolyData> MakeIsoSurface(vtkImageData* image);
  void Say(const std::string& problem);

  vtkInkStippleStyle* const Style;
  vtkInkStippleGenerator* const Generator;
  std::vector<double> HidingValues;
  std::string Problem;
};

#endif
