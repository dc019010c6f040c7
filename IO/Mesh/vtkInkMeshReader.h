// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkMeshReader
 * @brief   a mesh or points of any format as poly data, checked
 *
 * Reads PLY, OBJ, OFF, STL, VTK XML meshes (.vtp) and unstructured grids (.vtu), legacy VTK ones of both
 * (.vtk), points as lines of numbers (.xyz: x, y and z, and perhaps a normal) and of the Point Cloud Library
 * (.pcd), and GIFTI surfaces (.gii), in the coordinates of their points, in mm. Which format it is the file's
 * name tells.
 *
 * Of an unstructured grid it is the outer surface, as of vtkGeometryFilter, with point and cell arrays: of
 * solid cells, of which curved (quadratic) faces are subdivided once; cells that are faces, lines or vertices
 * are taken as they are, and so are the points of a grid without cells. Cells of a higher order are refused,
 * and so are polyhedra in legacy files.
 *
 * Coordinates are double where the file's are written as text or in double, so that those far from the origin
 * keep their digits; of STL, which has float, equal corners become one point. Normals become the array
 * Normals, colors of bytes RGB or RGBA, and what else a PLY's vertices or a PCD's points have, and a GIFTI
 * file has for each point, arrays of its names. What of a file was not used, or that a surface was made, say
 * the notes.
 *
 * Whatever is in the file, it is read whole or refused in one error that says what was found and what was
 * expected; no cell has points that are not there, and a header is believed only as far as there are bytes
 * for what it promises. VTK's own readers of these formats crash or read on beyond their memory with some
 * files.
 *
 * Errors, each with an empty output: no such file, none of these formats, one that is damaged or ends too
 * soon, no points, and too little memory.
 *
 * @sa vtkInkVolumeReader vtkInkSurfaceSampler
 */
#ifndef vtkInkMeshReader_h
#define vtkInkMeshReader_h

#include "vtkInkIOMeshModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the notes
#include <vector> // for the notes

class VTKINKIOMESH_EXPORT vtkInkMeshReader : public vtkPolyDataAlgorithm
{
public:
  static vtkInkMeshReader* New();
  vtkTypeMacro(vtkInkMeshReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. Default: none, which is an error.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Whether there is such a file and its name is one of these formats'; of a legacy VTK file, whether it says
   * that it holds poly data or an unstructured grid.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

  /**
   * The ends of the names of files that are read, separated by spaces.
   */
  static const char* GetFileExtensions();

  /**
   * The format in a few words, as "PLY mesh", by the end of FileName; empty if it is none of them.
   */
  const char* GetFormat();

  ///@{
  /**
   * What of the file is not used, or that a surface was made of it, after Update(), each a sentence without
   * its dot. Null for an index that does not exist.
   */
  int GetNumberOfNotes();
  const char* GetNote(int index);
  ///@}

protected:
  vtkInkMeshReader();
  ~vtkInkMeshReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkMeshReader(const vtkInkMeshReader&) = delete;
  void operator=(const vtkInkMeshReader&) = delete;

  char* FileName = nullptr;
  std::vector<std::string> Notes;
};

#endif
