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
 * Method. Segments through voxels are those of images: edge voxels are their marks, no surface hides them,
 * and neither iso-values nor smoothing count.
 *
 * The surfaces of all leaves of composite data are one, and so are those of all processes: on the first one,
 * so that no contour ends where a process's part does. Of grids the outer surface is drawn.
 *
 * Contours follow the camera: the mapper finds them. One piece: the surface's mesh, or edge
 * voxels.
 *
 * @sa vtkInkSilhouetteMapper
 */
#ifndef vtkInkContoursStyle_h
#define vtkInkContoursStyle_h

#include "vtkInkStyle.h"
#include "vtkNew.h"       // for what the style owns
#include "vtkTimeStamp.h" // for when it changed

#include <memory> // for what the style owns
#include <vector> // for the values of voxels

class InkIsoSurface;
class vtkInkEdgeVoxels;
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

  int GetNumberOfPieces() override { return 1; }
  const char* GetPieceName(int piece) override { return piece == 0 ? "Surface" : nullptr; }
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
  ///@}

  ///@{
  /// Parameters; see their table.
  void SetPreset(int preset);
  vtkGetMacro(Preset, int);
  void SetMethod(int method);
  vtkGetMacro(Method, int);
  void SetEdgeScale(double scale);
  double GetEdgeScale();
  void SetLeastGradient(double share);
  vtkGetMacro(LeastGradient, double);
  void SetValueRange(const std::vector<double>& range);
  const std::vector<double>& GetValueRange() { return this->ValueRange; }
  void SetCreases(bool creases);
  vtkGetMacro(Creases, bool);
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

  /// Edge voxels of images, those of all processes.
  std::string MakeVoxels(const InkLeaves& leaves);
  /// How the mapper draws the piece that it has.
  void UpdateMethod();

  std::unique_ptr<InkIsoSurface> IsoSurface;
  vtkNew<vtkInkEdgeVoxels> EdgeVoxels;
  vtkTimeStamp VoxelsChanged; ///< how they are found, or whether they are wanted
  vtkNew<vtkInkSilhouetteMapper> Mapper;
  vtkNew<vtkActor> Actor;
  int Preset = 0;
  int Method = 0;
  double LeastGradient = 0.2;     ///< of the greatest
  std::vector<double> ValueRange; ///< of voxels; empty: all
  bool Creases = true;
  double PaperColor[3] = { 1.0, 1.0, 1.0 };
  double ShortestPart = 4.0; ///< in the picture's pixels
};

#endif
