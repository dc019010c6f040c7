// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkContoursStyle
 * @brief   line drawings of the contours of surfaces: silhouettes, creases and borders
 *
 * A mesh is drawn as it is; where it has no normals they are computed from its polygons, also split at edges
 * of more than 30 degrees, which a note says. Of an image the iso-surfaces at IsoValues are drawn, or that at
 * the iso-value that suits the image, which is noted: as a mesh, with normals of the smoothed image; what
 * creases it has are the voxels', and are not drawn. Points without polygons have no contours.
 *
 * Silhouettes can be found in the ways that Lu et al. (2003, section 5.6) publish, too, see the parameter
 * Method. Segments through voxels are those of images: edge voxels are their marks, no surface hides them
 * unless OnSurface is set, and neither iso-values nor smoothing count.
 *
 * The surfaces of all leaves of composite data are one, and so are those of all processes: on the first one,
 * so that no contour ends where a process's part does. Of grids the outer surface is drawn.
 *
 * Contours follow the camera: the mapper finds them. Pieces: the surface's mesh or edge voxels, and the
 * surface that hides these.
 *
 * @sa vtkInkSilhouetteMapper
 */
#ifndef vtkInkContoursStyle_h
#define vtkInkContoursStyle_h

#include "vtkInkStyle.h"
#include "vtkNew.h" // for what the style owns

#include <memory> // for what the style owns
#include <string> // for the texture's file

class InkIsoSurface;
class InkSilhouetteMethod;
class vtkInkSilhouetteMapper;
struct InkLeaves;

class VTKINKSTYLES_EXPORT vtkInkContoursStyle : public vtkInkStyle
{
public:
  static vtkInkContoursStyle* New();
  vtkTypeMacro(vtkInkContoursStyle, vtkInkStyle);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  const char* GetName() override { return "contours"; }
  const char* GetLabel() override { return "Contours"; }
  const char* GetDescription() override;
  std::string GetReasonAgainst(vtkDataObject* data) override;

  enum PieceType
  {
    CONTOURED = 0, ///< the surface, or edge voxels
    SURFACE = 1    ///< what hides segments through voxels; empty otherwise
  };
  int GetNumberOfPieces() override { return SURFACE + 1; }
  const char* GetPieceName(int piece) override;
  void ShowPieces(const std::vector<vtkPolyData*>& pieces) override;

  vtkMapper* GetMapper() override;
  vtkActor* GetActor() override { return this->Actor; }
  void GetBackgroundColor(double color[3]) override;

  ///@{
  /// Never: contours have no scalars.
  void SetColorByScalars(bool) override {}
  bool GetColorByScalars() override { return false; }
  ///@}

  ///@{
  /// What the style draws with; properties that are parameters are set as such.
  InkIsoSurface* GetIsoSurface();
  vtkInkSilhouetteMapper* GetSilhouetteMapper();
  InkSilhouetteMethod* GetSilhouetteMethod();
  ///@}

  /// Whether something else is drawn on the surface, which then is made in any case, and also hides segments
  /// through voxels. Default: off.
  vtkSetMacro(OnSurface, bool);
  vtkGetMacro(OnSurface, bool);
  vtkBooleanMacro(OnSurface, bool);

  ///@{
  /// Parameters; see their table.
  void SetPreset(int preset);
  vtkGetMacro(Preset, int);
  void SetCreases(bool creases);
  vtkGetMacro(Creases, bool);
  void SetTexture(const std::string& file);
  const std::string& GetTexture() { return this->Texture; }
  void SetPaperColor(double red, double green, double blue);
  vtkGetVector3Macro(PaperColor, double);
  void SetShortestPart(double pixels);
  vtkGetMacro(ShortestPart, double);
  ///@}

  const InkParameterTable& GetParameterTable() override;

protected:
  vtkInkContoursStyle();
  ~vtkInkContoursStyle() override;

  vtkMTimeType GetRecipeMTime() override;
  std::string MakePieces(const Input& input) override;
  void UpdatePixels() override;

private:
  vtkInkContoursStyle(const vtkInkContoursStyle&) = delete;
  void operator=(const vtkInkContoursStyle&) = delete;

  /// Of what is no image.
  /// @param reason against this process's data; empty if there is none
  /// @return what is wrong
  std::string TakeMesh(const Input& input, const InkLeaves& leaves, const std::string& reason);

  /// Of images. @return what is wrong
  std::string MakeSurface(const Input& input, const InkLeaves& leaves, vtkPolyData* surface);

  std::unique_ptr<InkIsoSurface> IsoSurface;
  vtkNew<vtkInkSilhouetteMapper> Mapper;
  std::unique_ptr<InkSilhouetteMethod> Method;
  vtkNew<vtkActor> Actor;
  int Preset = 0;
  bool OnSurface = false;
  bool Creases = true;
  std::string Texture; ///< the file's name
  double PaperColor[3] = { 1.0, 1.0, 1.0 };
  double ShortestPart = 4.0; ///< in the picture's pixels
};

#endif
