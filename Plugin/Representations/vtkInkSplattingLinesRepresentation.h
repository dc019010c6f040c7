// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkSplattingLinesRepresentation
 * @brief   "Splatting Lines": shows points with normals as a line drawing in ParaView's render views
 *
 * Takes any vtkPointSet, or a composite dataset of them, whose points carry the array `Normals` (or other
 * active normals), and draws it with a vtkInkSplattingLinesMapper of its own. A point array `Radius` is used
 * if there is one. The leaves of a composite dataset are drawn as one set of points, so that lines run across
 * them; ghost points are left out. Points without normals draw nothing and give one warning.
 *
 * @sa vtkInkSplattingLinesMapper vtkInkIsoSurfaceSampler
 */
#ifndef vtkInkSplattingLinesRepresentation_h
#define vtkInkSplattingLinesRepresentation_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkInkRepresentation.h"
#include "vtkNew.h" // for the mapper

class vtkInkSplattingLinesMapper;

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkInkSplattingLinesRepresentation : public vtkInkRepresentation
{
public:
  static vtkInkSplattingLinesRepresentation* New();
  vtkTypeMacro(vtkInkSplattingLinesRepresentation, vtkInkRepresentation);

  ///@{
  /**
   * The mapper's parameters: see vtkInkSplattingLinesMapper for meaning, range and default.
   */
  void SetLambda(double lambda);
  void SetTau(double tau);
  void SetPhi(double phi);
  void SetSigma(double sigma);
  void SetAsPublished(bool asPublished);
  void SetRadius(double radius);
  void SetInkColor(double red, double green, double blue);
  void SetPaperColor(double red, double green, double blue);
  void SetPaperVisibility(bool visible);
  ///@}

protected:
  vtkInkSplattingLinesRepresentation();
  ~vtkInkSplattingLinesRepresentation() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void Show(const std::vector<vtkPolyData*>& delivered) override;

private:
  vtkInkSplattingLinesRepresentation(const vtkInkSplattingLinesRepresentation&) = delete;
  void operator=(const vtkInkSplattingLinesRepresentation&) = delete;

  vtkNew<vtkInkSplattingLinesMapper> Mapper;
};

#endif
