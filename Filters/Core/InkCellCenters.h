// SPDX-License-Identifier: BSD-3-Clause

// Images whose values belong to cells, as those of simulations and segmentations do, as images of points.
#ifndef InkCellCenters_h
#define InkCellCenters_h

#include "vtkInkFiltersCoreModule.h" // for the export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkImageData;
class vtkInformation;
class vtkInformationVector;

/// Whether what is wanted of an image are values of its cells: an array of that name, where no point array
/// has it, or, without a name, any, where no point has a value. Marks of ghosts are no values.
VTKINKFILTERSCORE_EXPORT bool InkTakesCells(vtkImageData* image, const std::string& array = {});

/// The same of an image of which only this pipeline information has been made; false where it says nothing.
VTKINKFILTERSCORE_EXPORT bool InkAnnouncesCells(vtkInformation* info, const std::string& array = {});

/// An image with a point at the center of each cell of another one, which has the cell's values: the arrays
/// are the same, nothing is averaged. An axis of one sample, along which there are no cells, stays as it is.
/// The first array is active where none was. A cell between centers belongs to the piece that its first
/// corner's cell belongs to; hidden cells become hidden points, and a cell is refined where all of its
/// corners' are.
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkImageData> InkAtCellCenters(vtkImageData* image);

/// The image itself, or that of its cells' centers where InkTakesCells, or, without a name, that with active
/// scalars (InkActiveScalars.h).
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkImageData> InkWithPointValues(
  vtkImageData* image, const std::string& array = {});

/// Where the points of a whole image lie that InkWithPointValues makes of one of which only this pipeline
/// information has been made, see InkMakeFrame.
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkImageData> InkMakePointFrame(
  vtkInformation* info, const std::string& array = {});

///@{
/// Between an extent of points and that of the centers of the cells between them, in place. Points of an axis
/// that has one in `whole` stay.
VTKINKFILTERSCORE_EXPORT void InkToCellExtent(int extent[6]);
VTKINKFILTERSCORE_EXPORT void InkToPointExtent(int extent[6], const int whole[6]);
///@}

/// Makes an image without values, which has the points of another, one of its cells' centers.
VTKINKFILTERSCORE_EXPORT void InkMoveToCellCenters(vtkImageData* frame);

/// What a filter takes of images: points, also of images that have values in cells alone, or whose array to
/// process 0 is one of cells, or of whose arrays none is active. What is made of an image is kept as long as
/// the image and the array to process stay as they are, so that what a filter keeps for an image stays valid.
class VTKINKFILTERSCORE_EXPORT InkPointInput
{
public:
  InkPointInput();
  ~InkPointInput();
  InkPointInput(const InkPointInput&) = delete;
  void operator=(const InkPointInput&) = delete;

  /// The filter's input, where an image at `port` may be replaced by what InkWithPointValues makes. Valid as
  /// long as this object and the input are, until the next call.
  vtkInformationVector** Take(vtkAlgorithm* filter, vtkInformationVector** input, int port = 0);

  /// How many levels of ghost cells more a filter needs for the same points: 1 where it takes cells, else 0.
  static int GetGhostLevels(vtkAlgorithm* filter, vtkInformation* input);

private:
  vtkSmartPointer<vtkInformationVector> Replaced;
  std::vector<vtkInformationVector*> All;
  vtkSmartPointer<vtkImageData> Made;
  vtkWeakPointer<vtkImageData> From;
  std::string Array;
  vtkMTimeType Time = 0;
};

#endif
