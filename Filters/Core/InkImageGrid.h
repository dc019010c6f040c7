// SPDX-License-Identifier: BSD-3-Clause

// Converts a vtkImageData to the grids, masks and arrays of vtkInk's Common.
#ifndef InkImageGrid_h
#define InkImageGrid_h

#include "Fields/Grid/ElementMarks.h"
#include "Fields/Grid/GridGeometry.h"
#include "IsoSurface/ActiveCells.h"

#include "vtkInkFiltersCoreModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataSetAttributes;
class vtkImageData;
class vtkInformation;

/// A VTK extent: the first and last sample along each axis.
struct VTKINKFILTERSCORE_EXPORT InkExtent
{
  glm::ivec3 First;
  glm::ivec3 Last;

  explicit InkExtent(const int extent[6]);
  glm::ivec3 GetDimensions() const;
  bool operator==(const InkExtent&) const = default;
};

/// The whole extent of the image that `image` may be a piece of; its own extent if `info` has none.
VTKINKFILTERSCORE_EXPORT InkExtent InkGetWholeExtent(vtkInformation* info, vtkImageData* image);

/// Where the voxels of a whole image lie of which only this pipeline information has been made: an image with
/// its extent, origin, spacing and direction, without values.
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkImageData> InkMakeFrame(vtkInformation* info);

/// Whether `image` is the whole image rather than a piece: if it gives no result, no piece does.
/// @param input, output the filter's pipeline information
VTKINKFILTERSCORE_EXPORT bool InkIsWholeImage(
  vtkInformation* input, vtkInformation* output, vtkImageData* image);

/// Whether an image that arrived for another piece belongs to the first one, which then processes all of it.
///
/// A producer delivers the requested piece, in which it may mark cells of other pieces. Some producers do not
/// support pieces: VTK executes such readers for the first piece only, so that in parallel the first process
/// has the whole image and the others nothing, while a program that requests one piece after the other
/// receives the whole each time. In both cases, and where each process has the whole, everything is processed
/// exactly once if a whole image without marks belongs to the first piece.
VTKINKFILTERSCORE_EXPORT bool InkIsOfFirstPiece(
  vtkInformation* input, vtkInformation* output, vtkImageData* image);

/// The image's samples within an extent, which need not be the image's own.
/// @throws std::invalid_argument when the image has a spacing of zero or a singular direction matrix
VTKINKFILTERSCORE_EXPORT ink::GridGeometry InkMakeGrid(vtkImageData* image, const InkExtent& extent);

/// Whether rounding points on the grid to float moves them by more than a thousandth of the smallest spacing.
VTKINKFILTERSCORE_EXPORT bool InkNeedsDoublePrecision(const ink::GridGeometry& grid);

/// The points or cells of an image whose ghost array has any of the given bits; none without such an array.
VTKINKFILTERSCORE_EXPORT ink::ElementMarks InkGetMarks(vtkDataSetAttributes* attributes, unsigned char bits);

/// The array of an image that a filter works on: `found`, the result of GetInputArrayToProcess(0, ...) with
/// its `association`, or if an empty name was given, as ParaView does when no array is chosen, the active
/// point scalars; of cells' centers (InkPointInput) also what was chosen among cells. Null if there is none,
/// it is not point data or has no such component; the filter has then reported one error that names what was
/// found and what was expected.
VTKINKFILTERSCORE_EXPORT vtkDataArray* InkChooseScalars(
  vtkAlgorithm* filter, vtkImageData* image, vtkDataArray* found, int association, int component);

/// The same of the array to process of any index, without the report.
/// @param problem becomes what is wrong; empty if nothing is
VTKINKFILTERSCORE_EXPORT vtkDataArray* InkChooseScalars(vtkAlgorithm* filter, int index, vtkImageData* image,
  vtkDataArray* found, int association, int component, std::string& problem);

/// The array itself if it is contiguous in memory, otherwise a copy of the given component; sets `component`
/// to the one to read.
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkDataArray> InkMakeContiguous(vtkDataArray* array, int& component);

/// Whether the source of a filter's first input supports pieces. If it does not, a process that requests the
/// whole instead of its piece gets a copy of what the first process has already, and so do all other
/// consumers of the source there.
VTKINKFILTERSCORE_EXPORT bool InkKnowsPieces(vtkAlgorithm* filter);

/// The cells of an image that are another piece's, hidden or refined.
VTKINKFILTERSCORE_EXPORT ink::ElementMarks InkGetLeftOutCells(vtkImageData* image);

/// The cells that the requested piece owns, see InkIsOfFirstPiece, and that are neither hidden nor refined.
VTKINKFILTERSCORE_EXPORT ink::CellSelection InkSelectCells(
  vtkInformation* input, vtkInformation* output, vtkImageData* image);

#endif
