// SPDX-License-Identifier: BSD-3-Clause
/// A data object's leaves by how they are drawn: of composite data all of them, otherwise the data itself.
/// Images with values in their cells alone are those of the cells' centers (InkCellCenters.h); the array that
/// is wanted is active, or, of those without active scalars, the first, of several components the first one
/// alone (InkActiveScalars.h).
#ifndef InkLeaves_h
#define InkLeaves_h

#include "vtkInkStylesModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkImageData;
class vtkPolyData;

struct VTKINKSTYLES_EXPORT InkLeaves
{
  /// @param input null: none
  /// @param array of images that is wanted; empty: the active scalars
  explicit InkLeaves(vtkDataObject* input, const std::string& array = {});

  /// Their surfaces, and stipples' points as they are: of grids the outer surface.
  std::vector<vtkSmartPointer<vtkPolyData>> MakeMeshes() const;
  /// Why images cannot be drawn, as "an image without point scalars"; empty if they can.
  std::string FindImageProblem() const;
  /// That what is no image is not drawn beside images, as an error; empty if all are images or none is.
  std::string FindBesideImages() const;
  /// That what is drawn, images, or else stipples, or else the others, has no such numeric array to be
  /// colored by, of images' points, of stipples, or of others' points or cells, with those that there are, as
  /// an error; empty if all have it.
  std::string FindMissingColors(const std::string& array) const;
  /// What becomes of grids, in a sentence without its dot; empty if there is none.
  std::string DescribeGrids() const;

  std::vector<vtkImageData*> Images;  ///< as long as the leaves are there
  std::vector<vtkPolyData*> Stipples; ///< made before
  std::vector<vtkDataSet*> Others;    ///< meshes, points and grids
  bool Composite = false;
  std::string Problem; ///< what of it is no dataset, "a vtkTable", or has not the array; empty if all is well

private:
  void Add(vtkDataObject* leaf, const std::string& array);

  std::vector<vtkSmartPointer<vtkImageData>> KeptImages;
};

#endif
