// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkIllustrationRepresentation
 * @brief   "Illustration": shows images, meshes, grids and points as stipples with lines in ParaView's render
 * views
 *
 * What a vtkInkIllustrationStyle makes of them and how it draws that, on all processes as on one: each
 * samples its part of an image's surface; meshes, points and stipples are those of the first process.
 *
 * How finely an image is sampled, and how many stipples there are, goes by how large the view shows them
 * (vtkSMInkRepresentationProxy), of stipples up to two million, of samples up to four.
 *
 * @sa vtkInkIllustrationStyle
 */
#ifndef vtkInkIllustrationRepresentation_h
#define vtkInkIllustrationRepresentation_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkInkRepresentation.h"

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkInkIllustrationRepresentation : public vtkInkRepresentation
{
public:
  static vtkInkIllustrationRepresentation* New();
  vtkTypeMacro(vtkInkIllustrationRepresentation, vtkInkRepresentation);

  std::vector<double> GetUsedIsoValues() override;

  ///@{
  /// See-through, the outer surface: at a value that suits the image (default), or at this one.
  void SetAutomaticOuterIsoValue(bool automatic);
  void SetOuterIsoValue(double value);
  ///@}

protected:
  vtkInkIllustrationRepresentation();
  ~vtkInkIllustrationRepresentation() override;

  /// Also before the outer surface of a see-through one is known.
  bool BlendsMarks() override;

  std::string MakeMarks(const vtkInkStyle::Input& input) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkInkIllustrationRepresentation(const vtkInkIllustrationRepresentation&) = delete;
  void operator=(const vtkInkIllustrationRepresentation&) = delete;

  Choice OuterIsoValue;
};

#endif
