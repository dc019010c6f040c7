// SPDX-License-Identifier: BSD-3-Clause
// A vtkImageData as the grids, marks and arrays that vtkInk's Common works on.
#ifndef InkImageGrid_h
#define InkImageGrid_h

#include "Fields/GridField.h"
#include "Sampling/CrossedCells.h"

#include "vtkInkFiltersCoreModule.h" // for the export macro
#include "vtkSmartPointer.h"

class vtkAlgorithm;
class vtkDataArray;
class vtkDataSetAttributes;
class vtkImageData;
class vtkInformation;

/// The box of an extent as VTK writes it: the first and last sample along each axis.
struct VTKINKFILTERSCORE_EXPORT InkExtent
{
  glm::ivec3 First;
  glm::ivec3 Last;

  explicit InkExtent(const int extent[6]);
  glm::ivec3 GetDimensions() const;
  bool operator==(const InkExtent&) const = default;
};

/// The extent of the whole image of which `image` may be a piece; its own where `info` does not say.
VTKINKFILTERSCORE_EXPORT InkExtent InkGetWholeExtent(vtkInformation* info, vtkImageData* image);

/// Whether an image is all that there is of it: if it is without result, so are all pieces.
/// @param input, output the filter's pipeline information
VTKINKFILTERSCORE_EXPORT bool InkIsWholeImage(
  vtkInformation* input, vtkInformation* output, vtkImageData* image);

/// Whether an image that was given for a piece is the first piece's.
///
/// What a producer gives for a piece is that piece, but for cells that it marks as another's. Some producers
/// do not know of pieces: VTK lets readers of this kind run for the first piece only, so that of several
/// processes the first one has the whole and the others nothing, and a program that asks for one piece after
/// the other finds the whole each time. Both times, and also where each process has the whole, all is taken
/// once if a whole image without marks is the first piece's.
VTKINKFILTERSCORE_EXPORT bool InkIsOfFirstPiece(
  vtkInformation* input, vtkInformation* output, vtkImageData* image);

/// The image's samples within an extent, which need not be the image's own.
/// \throws std::invalid_argument when the image has a spacing of zero or a direction matrix without inverse
VTKINKFILTERSCORE_EXPORT ink::GridGeometry InkMakeGrid(vtkImageData* image, const InkExtent& extent);

/// Whether points on the grid, rounded to float, move by more than a thousandth of the smallest spacing.
VTKINKFILTERSCORE_EXPORT bool InkNeedsDoublePrecision(const ink::GridGeometry& grid);

/// The ghost array of an image's points or cells as marks with any of the given bits; nothing is marked where
/// there is no such array.
VTKINKFILTERSCORE_EXPORT ink::ElementMarks InkGetMarks(vtkDataSetAttributes* attributes, unsigned char bits);

/// The array of an image that a filter works on: `found`, what GetInputArrayToProcess(0, ...) returned with
/// its `association`, or where an empty name was given, as ParaView does where no array was chosen, the
/// active point scalars. Null where there is none, it is not point data or has no such component: then the
/// filter has reported one error that names what was found and what was expected.
VTKINKFILTERSCORE_EXPORT vtkDataArray* InkChooseScalars(
  vtkAlgorithm* filter, vtkImageData* image, vtkDataArray* found, int association, int component);

/// The array itself where its components lie side by side in memory, otherwise a copy of the given component;
/// `component` becomes the one to read.
VTKINKFILTERSCORE_EXPORT vtkSmartPointer<vtkDataArray> InkMakeContiguous(vtkDataArray* array, int& component);

/// Whether the source that a filter's first input comes from gives pieces. Where not, a process that asks it
/// for the whole in place of a piece that is not the first gets what the first process has already, and so do
/// all others there that read it.
VTKINKFILTERSCORE_EXPORT bool InkKnowsPieces(vtkAlgorithm* filter);

/// The image's cells that the piece asked for owns, see InkIsOfFirstPiece, and that are neither hidden nor
/// refined.
VTKINKFILTERSCORE_EXPORT ink::CellSelection InkSelectCells(
  vtkInformation* input, vtkInformation* output, vtkImageData* image);

#endif
