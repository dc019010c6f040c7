// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkLineArtStyle
 * @brief   hatching along lines of curvature, with contours
 *
 * Surfaces are hatched like an engraving: strokes follow the lines of maximum curvature, are wider where it
 * is darker, are crossed by a second family of strokes in the shade, and leave the paper white in the light;
 * contours are drawn over them. Meshes are taken as they are, and of images the iso-surfaces at IsoValues, or
 * that at the iso-value that suits the image, as vtkInkContoursStyle makes them.
 *
 * An image's surface has the curvature of the smoothed image, which is more exact than that of the mesh, or
 * on request the mesh's.
 *
 * Lines of curvature are found once; which of them are drawn and how wide follows the camera and the light in
 * each picture. Pieces: the surface's mesh, the strokes, and edge voxels where contours are segments through
 * these.
 *
 * @sa vtkInkLinesOfCurvature vtkInkHatching vtkInkStrokeMapper vtkInkContoursStyle
 */
#ifndef vtkInkLineArtStyle_h
#define vtkInkLineArtStyle_h

#include "vtkInkStyle.h"
#include "vtkNew.h" // for what the style owns
#include "vtkSmartPointer.h"

class InkIsoSurface;
class vtkInkContoursStyle;
class vtkInkHatching;
class vtkInkLineArtMapper;
class vtkInkLinesOfCurvature;
class vtkInkStrokeMapper;

class VTKINKSTYLES_EXPORT vtkInkLineArtStyle : public vtkInkStyle
{
public:
  static vtkInkLineArtStyle* New();
  vtkTypeMacro(vtkInkLineArtStyle, vtkInkStyle);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Where the curvature of an image's surface comes from, see SetCurvature.
  enum CurvatureType
  {
    OF_IMAGE = 0,
    OF_MESH = 1
  };

  const char* GetName() override { return "line-art"; }
  const char* GetLabel() override { return "Line Art"; }
  const char* GetDescription() override;
  std::string GetReasonAgainst(vtkDataObject* data) override;

  int GetNumberOfPieces() override { return 3; }
  const char* GetPieceName(int piece) override;
  void ShowPieces(const std::vector<vtkPolyData*>& pieces) override;

  vtkMapper* GetMapper() override;
  vtkActor* GetActor() override { return this->Actor; }
  vtkLight* GetLight() override { return this->Light; }
  void GetBackgroundColor(double color[3]) override;

  ///@{
  /// Never: strokes have no scalars.
  void SetColorByScalars(bool) override {}
  bool GetColorByScalars() override { return false; }
  ///@}

  ///@{
  /// What the style draws with; properties that are parameters are set as such. Families of the lines of
  /// curvature follow Crosshatching.
  InkIsoSurface* GetIsoSurface();
  vtkInkContoursStyle* GetContoursStyle();
  vtkInkLinesOfCurvature* GetLinesOfCurvature();
  vtkInkStrokeMapper* GetStrokeMapper();
  ///@}

  ///@{
  /// Parameters; see their table.
  void SetPreset(int preset);
  vtkGetMacro(Preset, int);
  void SetInkColor(double red, double green, double blue);
  double* GetInkColor() VTK_SIZEHINT(3);
  void SetLightDirection(double azimuth, double elevation);
  vtkGetVector2Macro(LightDirection, double);
  void SetDensity(double density);
  vtkGetMacro(Density, double);
  void SetWidth(double width);
  vtkGetMacro(Width, double);
  vtkSetMacro(Length, double);
  vtkGetMacro(Length, double);
  vtkSetMacro(LineSpacing, double);
  vtkGetMacro(LineSpacing, double);
  void SetCurvature(int source);
  int GetCurvature();
  void SetCullingCosine(double cosine);
  vtkGetMacro(CullingCosine, double);
  void SetSeed(int seed);
  int GetSeed();
  ///@}

  const InkParameterTable& GetParameterTable() override;

protected:
  vtkInkLineArtStyle();
  ~vtkInkLineArtStyle() override;

  vtkMTimeType GetRecipeMTime() override;
  std::string MakePieces(const Input& input) override;
  void UpdatePixels() override;

private:
  vtkInkLineArtStyle(const vtkInkLineArtStyle&) = delete;
  void operator=(const vtkInkLineArtStyle&) = delete;

  /// A thousandth of the picture's height in world units.
  double FindThousandth();
  void UpdateWidths();
  void UpdateFamilies();
  void UpdateCulling();

  vtkNew<vtkInkContoursStyle> Contours;
  vtkNew<vtkInkLinesOfCurvature> Lines;
  vtkNew<vtkInkHatching> Hatching;
  vtkNew<vtkInkStrokeMapper> Strokes;
  vtkNew<vtkInkLineArtMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkLight> Light;
  int Preset = 0;
  double LightDirection[2] = { -30.0, 30.0 };
  double Density = 0.6;
  double Width = 1.0;
  double Length = 0.0;
  double LineSpacing = 0.0;
  double CullingCosine = 0.2;
  vtkSmartPointer<vtkPolyData> Shown; ///< the surface
  vtkMTimeType TimeShown = 0;
  bool HasOutside = false; ///< of the surface that is shown: its inner side is not to be seen
};

#endif
