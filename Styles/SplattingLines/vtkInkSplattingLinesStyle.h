// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkSplattingLinesStyle
 * @brief   line drawings by splatting (Zhang et al. 2014) of images, meshes and points
 *
 * Of an image the iso-surfaces at IsoValues are drawn, or that at the iso-value that suits the image, which
 * is noted. A mesh is sampled, with NumberOfSamples points, or its vertices are drawn as they are. Points
 * without polygons are taken as they are, with normals estimated where they have none. Meshes and points of
 * all leaves and processes are put together on the first process.
 *
 * Pieces: the points, with the arrays Normals and, as far as they were made here, Radius, and, if
 * Interactive, what InkSampledMesh.h has; and the surface whose silhouettes are drawn over them, empty
 * without Silhouettes.
 *
 * @sa vtkInkIsoSurfaceSampler vtkInkSurfaceSampler vtkInkSplattingLinesMapper
 */
#ifndef vtkInkSplattingLinesStyle_h
#define vtkInkSplattingLinesStyle_h

#include "InkSampledMesh.h" // for the array to color by
#include "vtkInkStyle.h"
#include "vtkNew.h" // for what the style owns

#include <memory> // for what the style owns

class InkIsoSurface;
class InkSilhouettes;
class vtkInkSplattingLinesMapper;
class vtkInkSurfaceSampler;
struct InkLeaves;

class VTKINKSTYLES_EXPORT vtkInkSplattingLinesStyle : public vtkInkStyle
{
public:
  static vtkInkSplattingLinesStyle* New();
  vtkTypeMacro(vtkInkSplattingLinesStyle, vtkInkStyle);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  const char* GetName() override { return "splatting-lines"; }
  const char* GetLabel() override { return "Splatting Lines"; }
  const char* GetDescription() override;
  std::string GetReasonAgainst(vtkDataObject* data) override;

  enum PieceType
  {
    POINTS = 0,
    SILHOUETTES = 1 ///< the surface that has them
  };
  int GetNumberOfPieces() override { return SILHOUETTES + 1; }
  const char* GetPieceName(int piece) override;
  void ShowPieces(const std::vector<vtkPolyData*>& pieces) override;

  vtkMapper* GetMapper() override;
  vtkActor* GetActor() override { return this->Actor; }
  void GetBackgroundColor(double color[3]) override;
  void SetColorByScalars(bool byScalars) override;
  bool GetColorByScalars() override { return this->ByScalars; }

  ///@{
  /// What the style draws with; properties that are parameters are set as such.
  InkIsoSurface* GetIsoSurface();
  InkSilhouettes* GetSilhouettes();
  vtkInkSurfaceSampler* GetSurfaceSampler();
  vtkInkSplattingLinesMapper* GetLinesMapper();
  ///@}

  /// Twice as many as the mesh has points, or as many as discs of little more than a thousandth of its
  /// diagonal have room on it if these are more, but from 200000 to 1000000.
  static vtkIdType CountForMesh(vtkPolyData* mesh);

  /// The array that the points have to be colored by: of points of an image or, if Interactive, of a mesh or
  /// of points.
  void SetColorArray(const InkColorArray& colors);

  ///@{
  /// Parameters; see their table.
  void SetInkColor(double red, double green, double blue);
  double* GetInkColor() VTK_SIZEHINT(3);
  void SetBackground(double red, double green, double blue);
  vtkGetVector3Macro(Background, double);
  void SetLineWidth(double width);
  double GetLineWidth();
  void SetSpeckleLength(double pixels);
  vtkGetMacro(SpeckleLength, double);
  void SetColorByTone(bool byTone);
  vtkGetMacro(ColorByTone, bool);
  void SetHiddenStrength(double strength);
  double GetHiddenStrength();
  void SetUseHiddenColor(bool use);
  vtkGetMacro(UseHiddenColor, bool);
  void SetHiddenColor(const std::vector<double>& colors);
  const std::vector<double>& GetHiddenColor() { return this->HiddenColor; }
  void SetHiddenLineWidth(double width);
  double GetHiddenLineWidth();
  void SetHiddenDashLength(double length);
  double GetHiddenDashLength();
  void SetCullBackFaces(bool cull);
  bool GetCullBackFaces();
  vtkSetMacro(NumberOfSamples, vtkIdType);
  vtkGetMacro(NumberOfSamples, vtkIdType);
  void SetViewpoint(const std::vector<double>& viewpoint);
  std::vector<double> GetViewpoint();
  ///@}

  const InkParameterTable& GetParameterTable() override;

protected:
  vtkInkSplattingLinesStyle();
  ~vtkInkSplattingLinesStyle() override;

  vtkMTimeType GetRecipeMTime() override;
  std::string MakePieces(const Input& input) override;
  InkIsoSurface* GetSampledSurface() override { return this->IsoSurface.get(); }
  void UpdatePixels() override;

private:
  vtkInkSplattingLinesStyle(const vtkInkSplattingLinesStyle&) = delete;
  void operator=(const vtkInkSplattingLinesStyle&) = delete;

  /// Of what is no image, all processes at once.
  /// @param reason against the data of this one
  /// @return what is wrong
  std::string MakeOfMeshes(const Input& input, const InkLeaves& leaves, const std::string& reason);
  std::string TakeCloud(vtkPolyData* points);
  std::string SampleMesh(vtkPolyData* mesh);
  /// The points of all images' surfaces.
  /// @param reason against the data; empty if there is none
  /// @return what is wrong
  std::string SampleImages(const Input& input, const InkLeaves& leaves, const std::string& reason);
  void UpdateColors();

  std::unique_ptr<InkIsoSurface> IsoSurface;
  vtkNew<vtkInkSurfaceSampler> SurfaceSampler;
  vtkNew<vtkInkSplattingLinesMapper> Mapper;
  std::unique_ptr<InkSilhouettes> Silhouettes;
  vtkNew<vtkActor> Actor;
  double Background[3] = { 1.0, 1.0, 1.0 };
  double SpeckleLength = 0.0; ///< in the picture's pixels
  bool ByScalars = false;
  bool ColorByTone = false;
  bool UseHiddenColor = false;
  std::vector<double> HiddenColor{ 0.2, 0.4, 0.7 };
  vtkIdType NumberOfSamples = -1;
  vtkIdType AutomaticSamples = 0; ///< of the mesh that SurfaceSampler follows; 0: of none yet
  InkColorArray Colors;
};

#endif
