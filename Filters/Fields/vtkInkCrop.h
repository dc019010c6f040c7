// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkCrop
 * @brief   what of an image, a mesh or points lies in a box
 *
 * Of an image the voxels whose centers lie in the box stay, as an image of its own whose voxels are counted
 * from zero; of an oblique image those in the box of voxels around it. Parts of it are made of parts of the
 * input (update extents), so that no more is read of a file than what stays. Polygons are cut at the box's
 * sides, and of points without polygons those in the box stay, with their arrays.
 *
 * Errors, each with an empty output: data that is no image and no poly data, and a box in which nothing lies.
 *
 * @sa vtkExtractVOI vtkClipPolyData
 */
#ifndef vtkInkCrop_h
#define vtkInkCrop_h

#include "vtkInkFiltersFieldsModule.h" // for the export macro
#include "vtkPassInputTypeAlgorithm.h"

class vtkImageData;
class vtkPolyData;

class VTKINKFILTERSFIELDS_EXPORT vtkInkCrop : public vtkPassInputTypeAlgorithm
{
public:
  static vtkInkCrop* New();
  vtkTypeMacro(vtkInkCrop, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The box in world coordinates: x, y and z from and to. An axis whose ends are not numbers, or the wrong
   * way round, is refused with a warning. Default: from -1 to 1 each.
   */
  void SetBox(double x0, double x1, double y0, double y1, double z0, double z1);
  void SetBox(const double box[6]);
  vtkGetVector6Macro(Box, double);
  ///@}

protected:
  vtkInkCrop() = default;
  ~vtkInkCrop() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkCrop(const vtkInkCrop&) = delete;
  void operator=(const vtkInkCrop&) = delete;

  /// The voxels of an image that stay. @param frame where all of them lie @return whether there are any
  bool FindExtent(vtkImageData* frame, int extent[6]);
  void CropImage(vtkImageData* image, const int extent[6], vtkImageData* output);
  void CropMesh(vtkPolyData* mesh, vtkPolyData* output);
  /// @param bounds of the data
  void ReportNothing(const double bounds[6]);

  double Box[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  int Kept[6] = { 0, -1, 0, -1, 0, -1 }; ///< of an image, found by RequestInformation
};

#endif
