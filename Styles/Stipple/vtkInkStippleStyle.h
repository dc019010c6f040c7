// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkStippleStyle
 * @brief   stipple drawings (Lu et al. 2003) of images and meshes
 *
 * The iso-surfaces of an image, or of each image of a composite dataset, are stippled, as are the outer
 * surfaces of other data, and the surface that discs around points cover; all of them hide what lies behind
 * them, and get as many stipples as the picture has room for. By StippleSource, the voxels of an image with
 * large gradients are stippled instead, which are see-through. Data that is stipples already, of
 * vtkInkStippleGenerator, is drawn as it is.
 *
 * A preset sets the sliders, the ink, the paper and what else goes with it; a slider sets those of the
 * mapper's parameters that it stands for. What is set one by one after that stays.
 *
 * Pieces: the stipples, the surface that hides them, and numbers that go with them: on several processes each
 * has its part, of an image's gradients, or all are on the first one, of surfaces; and the surface whose
 * silhouettes are drawn over them, empty without Silhouettes.
 *
 * @sa vtkInkStippleGenerator vtkInkStippleControls vtkInkStippleMapper
 */
#ifndef vtkInkStippleStyle_h
#define vtkInkStippleStyle_h

#include "vtkInkStyle.h"
#include "vtkNew.h" // for what the style owns

#include <memory> // for what the style owns

class InkIsoSurface;
class InkSilhouettes;
class vtkInkStippleActor;
class vtkInkStippleControls;
class vtkInkStippleGenerator;
class vtkInkStippleMapper;
class vtkInkSurfaceSampler;

class VTKINKSTYLES_EXPORT vtkInkStippleStyle : public vtkInkStyle
{
public:
  static vtkInkStippleStyle* New();
  vtkTypeMacro(vtkInkStippleStyle, vtkInkStyle);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  const char* GetName() override { return "stipple"; }
  const char* GetLabel() override { return "Stipple"; }
  const char* GetDescription() override;
  std::string GetReasonAgainst(vtkDataObject* data) override;

  /// What of an image is stippled.
  enum StippleSourceType
  {
    AUTOMATIC = 0,   ///< its iso-surfaces where there are iso-values or one can be chosen, else its voxels
    ISO_SURFACE = 1, ///< its iso-surfaces
    VOXELS = 2       ///< its voxels with large gradients
  };

  enum PieceType
  {
    STIPPLES = 0,
    SURFACE = 1,
    NUMBERS = 2,    ///< one point of each process that has stipples, with what their field data says
    SILHOUETTES = 3 ///< the surface that has them
  };
  int GetNumberOfPieces() override { return SILHOUETTES + 1; }
  const char* GetPieceName(int piece) override;
  void ShowPieces(const std::vector<vtkPolyData*>& pieces) override;

  vtkMapper* GetMapper() override;
  vtkActor* GetActor() override;
  vtkLight* GetLight() override { return this->Light; }
  bool IsSeenThrough() override { return this->OfVoxels; }
  void GetBackgroundColor(double color[3]) override;
  void SetColorByScalars(bool byScalars) override;
  bool GetColorByScalars() override;

  ///@{
  /// What the style draws with; properties that are parameters are set as such.
  vtkInkStippleGenerator* GetGenerator();
  vtkInkStippleMapper* GetStippleMapper();
  vtkInkStippleControls* GetControls();
  InkIsoSurface* GetIsoSurface();
  InkSilhouettes* GetSilhouettes();
  ///@}

  ///@{
  /// Whether point i of the last stipples is point i of the data, and whether they are those of an image.
  vtkGetMacro(IdsAreInputs, bool);
  vtkGetMacro(OfImage, bool);
  ///@}

  ///@{
  /**
   * The array of the data that stipples carry to be colored by, as ColorBy names it; association as in
   * vtkDataObject::FieldAssociations, or -1 (default) for points or else cells. The Made ones are what the
   * last stipples have; empty: none.
   */
  void SetColorArray(const std::string& name, int association);
  const std::string& GetMadeColorArray() { return this->MadeColorArray; }
  vtkGetMacro(MadeColorAssociation, int);
  ///@}

  ///@{
  /// Parameters; see their table.
  void SetPreset(int preset);
  int GetPreset();
  void SetLightDirection(double azimuth, double elevation);
  vtkGetVector2Macro(LightDirection, double);
  void SetInkColor(double red, double green, double blue);
  double* GetInkColor() VTK_SIZEHINT(3);
  void SetPaperColor(double red, double green, double blue);
  vtkGetVector3Macro(PaperColor, double);
  void SetSizeUnit(int unit);
  vtkGetMacro(SizeUnit, int);
  void SetStippleSize(double size);
  vtkGetMacro(StippleSize, double);
  void SetPixelsPerStipple(double pixels);
  vtkGetMacro(PixelsPerStipple, double);
  vtkSetClampMacro(StippleSource, int, AUTOMATIC, VOXELS);
  vtkGetMacro(StippleSource, int);
  vtkSetMacro(SurfaceHides, bool);
  vtkGetMacro(SurfaceHides, bool);
  vtkSetMacro(NumberOfSurfaceStipples, vtkIdType);
  vtkGetMacro(NumberOfSurfaceStipples, vtkIdType);
  void SetColorMap(const std::string& map);
  const std::string& GetColorMap() { return this->ColorMap; }
  void SetColorBy(const std::string& array) { this->SetColorArray(array, -1); }
  const std::string& GetColorBy() { return this->ColorBy; }
  void SetColorRange(const std::vector<double>& range);
  const std::vector<double>& GetColorRange() { return this->ColorRange; }
  ///@}
  /// Whether labels are colored by their order, so that each has a color of its own wherever ids lie: where
  /// colors are the style's own, without a range.
  bool TakesLabelsInOrder() { return !this->GetInteractive() && this->ColorRange.empty(); }

  const InkParameterTable& GetParameterTable() override;

protected:
  vtkInkStippleStyle();
  ~vtkInkStippleStyle() override;

  vtkMTimeType GetRecipeMTime() override;
  std::string MakePieces(const Input& input) override;
  bool DrawsSurfaces(const Input& input) const override;
  void UpdatePixels() override;
  void FollowParameters(const Settings& given) override;

private:
  vtkInkStippleStyle(const vtkInkStippleStyle&) = delete;
  void operator=(const vtkInkStippleStyle&) = delete;

  friend class InkStippleRecipe;
  void UpdateColors();

  vtkNew<vtkInkStippleControls> Controls;
  vtkNew<vtkInkStippleGenerator> Generator;
  vtkNew<vtkInkStippleMapper> Mapper;
  vtkNew<vtkInkSurfaceSampler> SurfaceSampler; ///< of points that have no normals or radii
  std::unique_ptr<InkSilhouettes> Silhouettes;
  vtkNew<vtkInkStippleActor> Actor;
  vtkNew<vtkLight> Light;
  double LightDirection[2] = { -30.0, 30.0 };
  double PaperColor[3] = { 1.0, 1.0, 1.0 };
  int SizeUnit = 0;              ///< as the mapper's
  double StippleSize = 0.0;      ///< of a unit; pixels are the picture's
  double PixelsPerStipple = 0.0; ///< of its square
  int StippleSource = AUTOMATIC;
  std::unique_ptr<InkIsoSurface> IsoSurface;
  bool SurfaceHides = true;
  vtkIdType NumberOfSurfaceStipples = 0;
  std::string ColorMap;
  std::string ColorBy;
  int ColorAssociation = -1;
  std::vector<double> ColorRange;
  bool IdsAreInputs = false;
  bool OfImage = false;
  bool OfVoxels = false;
  std::string MadeColorArray;
  int MadeColorAssociation = 0;

  /// What is drawn: stipples with the numbers that belong to them.
  vtkNew<vtkPolyData> Drawn;
  vtkMTimeType DrawnTime = 0; ///< when what it was put together from was last changed
};

#endif
