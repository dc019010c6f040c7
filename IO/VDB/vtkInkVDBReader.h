// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkVDBReader
 * @brief   a grid of an OpenVDB file as image data
 *
 * Reads one grid of floats, doubles or half floats of a .vdb file (OpenVDB 2 to 12) into a vtkImageData of
 * type float or double, whose one point array has the grid's name. Origin, spacing and direction matrix are
 * those of the grid's transform, also where it mirrors or shears; sample (i, j, k) is voxel (i, j, k), so
 * that the extent need not begin at 0. The image is the grid's active box and a few voxels of its background
 * around it (Padding), or, for a grid that `ink convert` wrote, the whole box of the volume that it was made
 * from.
 *
 * Level sets are negative inside, while vtkInk takes larger values for denser ones and lets normals point
 * out of the denser side. So the values of grids of the class "level set" are multiplied by -1, unless
 * InvertLevelSets is off: iso-value 0 then is the surface, with normals out of it, and positive values lie
 * within.
 *
 * Which grids there are is known after UpdateInformation(), which does not read voxels (but those of a grid
 * whose file does not say where its active voxels are). Parts of the image (update extents) are made without
 * the rest.
 *
 * Errors, each with an empty output: no such file, none of OpenVDB's, one that is damaged or ends too soon,
 * no such grid, a grid of other values (integers, vectors, booleans, points), a transform that is not linear
 * (frustum), and one that needs more memory than MaximumMemory. An empty grid is a warning.
 *
 * @sa vtkInkVDBIsoSurfaceSampler
 */
#ifndef vtkInkVDBReader_h
#define vtkInkVDBReader_h

#include "vtkImageAlgorithm.h"
#include "vtkInkIOVDBModule.h" // for the export macro
#include "vtkSmartPointer.h"   // for the list of names

#include <memory> // for the file

class vtkStringArray;
class InkVDBSource;

class VTKINKIOVDB_EXPORT vtkInkVDBReader : public vtkImageAlgorithm
{
public:
  static vtkInkVDBReader* New();
  vtkTypeMacro(vtkInkVDBReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. Default: none, which is an error.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Whether a file is one of OpenVDB's whose list of grids can be read.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

  ///@{
  /**
   * The name of the grid to read. Of two grids of one name the file's second is "name[1]". Default: none,
   * which takes the first grid that can be read.
   */
  vtkSetStringMacro(GridName);
  vtkGetStringMacro(GridName);
  ///@}

  ///@{
  /**
   * The grids in the file, after UpdateInformation(). Types are "float", "double", "half" and, for grids that
   * cannot be read, others, as "vec3s"; classes are "level set", "fog volume", "staggered" and "unknown".
   * Dimensions are those of the active voxels' box, 0 where the file does not say them. Empty, or 0, for an
   * index that does not exist.
   */
  int GetNumberOfGrids();
  const char* GetNameOfGrid(int index);
  const char* GetTypeOfGrid(int index);
  const char* GetClassOfGrid(int index);
  void GetDimensionsOfGrid(int index, int dimensions[3]);
  vtkIdType GetNumberOfActiveVoxelsOfGrid(int index);
  ///@}

  /**
   * The names of the grids that can be read, after UpdateInformation().
   */
  vtkStringArray* GetGridNames();

  ///@{
  /**
   * Multiply the values of level sets by -1, so that their inside is the denser side. Default: on.
   */
  vtkSetMacro(InvertLevelSets, bool);
  vtkGetMacro(InvertLevelSets, bool);
  vtkBooleanMacro(InvertLevelSets, bool);
  ///@}

  ///@{
  /**
   * How many voxels of background the image has around the active ones, 0 to 64. With the default, 2,
   * iso-surfaces are closed and have the normals that they have in the grid.
   */
  vtkSetClampMacro(Padding, int, 0, 64);
  vtkGetMacro(Padding, int);
  ///@}

  ///@{
  /**
   * The most memory in MiB that the grid and the image may take together, 0 for any. More is an error that
   * says how much it would be, 0 to 16777216 (16 TiB). Default: 4096.
   */
  vtkSetClampMacro(MaximumMemory, int, 0, 16777216);
  vtkGetMacro(MaximumMemory, int);
  ///@}

protected:
  vtkInkVDBReader();
  ~vtkInkVDBReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkVDBReader(const vtkInkVDBReader&) = delete;
  void operator=(const vtkInkVDBReader&) = delete;

  char* FileName = nullptr;
  char* GridName = nullptr;
  bool InvertLevelSets = true;
  int Padding = 2;
  int MaximumMemory = 4096;
  /// Whether the information could not be read, which then was said.
  bool Failed = false;
  std::unique_ptr<InkVDBSource> Source;
  vtkSmartPointer<vtkStringArray> Names;
};

#endif
