// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkContoursRepresentation
 * @brief   "Contours": shows images, meshes and grids as line drawings of their contours in ParaView's render
 * views
 *
 * What a vtkInkContoursStyle makes of them and how it draws that, on all processes as on one: parts of an
 * image, and of a mesh, are put together on the first process, so that no line ends where a part does. Lines
 * are found again for each camera where they are drawn. Points of a mesh that has normals can be picked
 * beside its lines.
 *
 * How finely an image is sampled goes by how large the view shows it (vtkSMInkRepresentationProxy).
 *
 * @sa vtkInkContoursStyle
 */
#ifndef vtkInkContoursRepresentation_h
#define vtkInkContoursRepresentation_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkInkRepresentation.h"

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkInkContoursRepresentation : public vtkInkRepresentation
{
public:
  static vtkInkContoursRepresentation* New();
  vtkTypeMacro(vtkInkContoursRepresentation, vtkInkRepresentation);

  std::vector<double> GetUsedIsoValues() override;

protected:
  vtkInkContoursRepresentation();
  /// Of a style whose first piece is the surface that contours are drawn of.
  explicit vtkInkContoursRepresentation(vtkSmartPointer<vtkInkStyle> style);
  ~vtkInkContoursRepresentation() override;

  std::string MakeMarks(const vtkInkStyle::Input& input) override;
  /// Lines are of the ink's color, whatever data is colored by.
  bool ServesFor(const std::string&, int) override { return true; }
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkInkContoursRepresentation(const vtkInkContoursRepresentation&) = delete;
  void operator=(const vtkInkContoursRepresentation&) = delete;
};

#endif
