// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkIllustrationStyle
 * @brief   stipples that shade a surface, and splatting lines that outline it, as in a medical plate
 *
 * The styles vtkInkSplattingLinesStyle and vtkInkStippleStyle on one surface: the points that lines are drawn
 * of are made once, and of images and points stipples lie on the discs around them, so that both register
 * exactly; of a mesh they lie on its polygons. Parameters are those of the two styles, as far as they matter
 * here, and their inks are one. A preset sets light, size and density of stipples, and number, darkness and
 * width of lines.
 *
 * See-through, there are two surfaces of an image: an inner one, and a faint one around it, at OuterIsoValue.
 *
 * Pieces: those of vtkInkSplattingLinesStyle, silhouettes being drawn with its lines, and those of
 * vtkInkStippleStyle; then the same of the outer surface, empty without one, which has no silhouettes.
 *
 * @sa vtkInkSplattingLinesStyle vtkInkStippleStyle vtkInkIllustrationMapper
 */
#ifndef vtkInkIllustrationStyle_h
#define vtkInkIllustrationStyle_h

#include "vtkInkStyle.h"
#include "vtkNew.h" // for what the style owns

#include <memory> // for iso-values

class InkIsoSurface;
class InkIsoValues;
class InkSilhouettes;
class vtkInkIllustrationMapper;
class vtkInkSplattingLinesStyle;
class vtkInkStippleStyle;
struct InkLeaves;

class VTKINKSTYLES_EXPORT vtkInkIllustrationStyle : public vtkInkStyle
{
public:
  static vtkInkIllustrationStyle* New();
  vtkTypeMacro(vtkInkIllustrationStyle, vtkInkStyle);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  const char* GetName() override { return "illustration"; }
  const char* GetLabel() override { return "Illustration"; }
  const char* GetDescription() override;
  std::string GetReasonAgainst(vtkDataObject* data) override;

  int GetNumberOfPieces() override;
  const char* GetPieceName(int piece) override;
  void ShowPieces(const std::vector<vtkPolyData*>& pieces) override;

  vtkMapper* GetMapper() override;
  vtkActor* GetActor() override { return this->Actor; }
  vtkLight* GetLight() override;
  void GetBackgroundColor(double color[3]) override;
  /// Stipples; lines stay ink.
  int GetColoredPiece() override;
  void SetColorByScalars(bool byScalars) override;
  bool GetColorByScalars() override;

  ///@{
  /// The styles that it is made of; their properties that are parameters are set as such.
  vtkInkSplattingLinesStyle* GetLinesStyle();
  vtkInkStippleStyle* GetStippleStyle();
  InkIsoSurface* GetIsoSurface();
  InkSilhouettes* GetSilhouettes();
  ///@}

  /// What draws both.
  vtkInkIllustrationMapper* GetIllustrationMapper();

  ///@{
  /// Parameters; see their table.
  void SetPreset(int preset);
  vtkGetMacro(Preset, int);
  void SetInkColor(double red, double green, double blue);
  double* GetInkColor() VTK_SIZEHINT(3);
  void SetPaperColor(double red, double green, double blue);
  double* GetPaperColor() VTK_SIZEHINT(3);
  void SetIsoValues(const std::vector<double>& values);
  const std::vector<double>& GetIsoValues();
  vtkSetMacro(SeeThrough, bool);
  vtkGetMacro(SeeThrough, bool);
  /// One value, or none.
  void SetOuterIsoValue(const std::vector<double>& value);
  const std::vector<double>& GetOuterIsoValue();
  ///@}
  /// The array that stipples have to be colored by, see vtkInkStippleStyle.
  void SetColorArray(const std::string& name, int association);
  /// The value of the outer surface that was made last, given or chosen; none without one.
  const std::vector<double>& GetUsedOuterIsoValue();

  const InkParameterTable& GetParameterTable() override;

protected:
  vtkInkIllustrationStyle();
  ~vtkInkIllustrationStyle() override;

  vtkMTimeType GetRecipeMTime() override;
  std::string MakePieces(const Input& input) override;
  InkIsoSurface* GetSampledSurface() override;
  void UpdatePixels() override;

private:
  vtkInkIllustrationStyle(const vtkInkIllustrationStyle&) = delete;
  void operator=(const vtkInkIllustrationStyle&) = delete;

  /// Finds the values of both surfaces where there are to be two. @return what is wrong
  std::string ChooseSurfaces(const InkLeaves& leaves);
  /// Of what is no image. @return what is wrong
  std::string MakeMesh(const Input& input, const InkLeaves& leaves);
  /// Makes the marks of one surface, as pieces from the given one on.
  std::string MakeSurface(
    vtkInkSplattingLinesStyle* lines, vtkInkStippleStyle* stipples, int firstPiece, const Input& input);
  void UpdateLightInk();

  vtkNew<vtkInkSplattingLinesStyle> Lines;
  vtkNew<vtkInkStippleStyle> Stipples;
  vtkNew<vtkInkSplattingLinesStyle> OuterLines;
  vtkNew<vtkInkStippleStyle> OuterStipples;
  vtkNew<vtkInkIllustrationMapper> Mapper;
  vtkNew<vtkActor> Actor;
  int Preset = 0;
  const std::unique_ptr<InkIsoValues> IsoValues;
  bool SeeThrough = false;
  const std::unique_ptr<InkIsoValues> OuterIsoValue;
};

#endif
