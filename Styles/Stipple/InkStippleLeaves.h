// SPDX-License-Identifier: BSD-3-Clause
/// A data object's leaves by how they are stippled.
#ifndef InkStippleLeaves_h
#define InkStippleLeaves_h

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkImageData;
class vtkPolyData;

struct InkStippleLeaves
{
  /// @param input null: none
  explicit InkStippleLeaves(vtkDataObject* input);

  std::vector<vtkImageData*> Images;
  std::vector<vtkPolyData*> Stipples; ///< made before
  std::vector<vtkDataSet*> Others;
  bool Composite = false;
  std::string Problem; ///< what of it cannot be stippled; empty if all can

private:
  void Add(vtkDataObject* leaf);
};

/// Whether data has polygons, or points with normals and radii, which cover a surface with discs.
bool InkHasSurface(vtkPolyData* data);

/// Why data cannot be drawn as stipples; empty if it can.
std::string InkReasonAgainstStipples(vtkDataObject* data);

#endif
