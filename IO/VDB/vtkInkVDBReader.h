// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkVDBReader
 * @brief reads a grid of an OpenVDB file as image data
 *
 * Reads one grid of floats, doubles or half floats of a .vdb file (OpenVDB 2 to 12) into a vtkImageData of
 * type float or double, whose one point array has the grid's name. Origin, spacing and direction matrix are
 * those of the grid's transform, even if it mirrors or shears; sample (i, j, k) is voxel (i, j, k), so that
 * the extent need not begin at 0. The image covers the bounding box of the active voxels and a few voxels of
 * background around it (Padding), or, for a grid written by `ink convert`, the whole extent of the original
 * volume.
 *
 * Level sets are negative inside, while vtkInk treats larger values as denser, with normals pointing out of
 * the denser side. So the values of grids of class "level set" are multiplied by -1, unless InvertLevelSets
 * is off: iso-value 0 is then the surface, with outward normals, and positive values are inside.
 *
 * The list of grids is available after UpdateInformation(), which does not read voxels (except for a grid
 * whose file does not have the bounding box of its active voxels). Parts of the image (update extents) are
 * made without the rest.
 *
 * Errors, each with an empty output: no such file, not an OpenVDB file, a corrupt or truncated file, no such
 * grid, a grid of an unsupported type (integers, vectors, booleans, points), a nonlinear transform (frustum),
 * and a grid that needs more memory than MaximumMemory. An empty grid is a warning.
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
   * Whether a file is an OpenVDB file whose list of grids can be read.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

  ///@{
  /**
   * The name of the grid to read. Of two grids of the same name the second is "name[1]". Default: none, which
   * selects the first readable grid.
   */
  vtkSetStringMacro(GridName);
  vtkGetStringMacro(GridName);
  ///@}

  ///@{
  /**
   * The grids in the file, after UpdateInformation(). Types are "float", "double", "half" and, for unreadable
   * grids, others such as "vec3s"; classes are "level set", "fog volume", "staggered" and "unknown".
   * Dimensions are those of the active voxels' bounding box, 0 if the file does not have it. Empty, or 0, for
   * an index out of range.
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
   * The number of background voxels around the active ones, 0 to 64. With the default, 2, iso-surfaces are
   * closed and have the same normals as in the grid.
   */
  vtkSetClampMacro(Padding, int, 0, 64);
  vtkGetMacro(Padding, int);
  ///@}

  ///@{
  /**
   * The memory limit in MiB for the grid and the image together; 0: none. Exceeding it is an error that names
   * the memory needed. 0 to 16777216 (16 TiB). Default: 4096.
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
  /// Whether reading the information failed, which has been reported.
  bool Failed = false;
  std::unique_ptr<InkVDBSource> Source;
  vtkSmartPointer<vtkStringArray> Names;
};

#endif
