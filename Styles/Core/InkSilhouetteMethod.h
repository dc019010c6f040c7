// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSilhouetteMethod_h
#define InkSilhouetteMethod_h

#include "vtkInkStylesModule.h" // for the export macro

#include "vtkNew.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"

#include <span>
#include <string>
#include <vector>

class vtkImageData;
class vtkInkEdgeVoxels;
class vtkInkSilhouetteMapper;
class vtkInkStyle;
class vtkPolyData;

/// How a style's silhouettes are found: as exact chains, or in the ways that Lu et al. (2003, section 5.6)
/// publish, see vtkInkSilhouetteMapper::SetMethod. Segments through voxels are of edge voxels, all others of
/// a surface; of a surface that has no voxels, lines in image space stand in for them, as they do in the
/// paper.
class VTKINKSTYLES_EXPORT InkSilhouetteMethod
{
public:
  explicit InkSilhouetteMethod(vtkInkSilhouetteMapper* mapper);
  ~InkSilhouetteMethod();
  InkSilhouetteMethod(const InkSilhouetteMethod&) = delete;
  void operator=(const InkSilhouetteMethod&) = delete;

  ///@{
  /// Parameters; see their table.
  void SetMethod(int method);
  int GetMethod() const { return this->Method; }
  void SetEdgeScale(double scale);
  double GetEdgeScale() const;
  void SetLeastGradient(double share);
  double GetLeastGradient() const { return this->LeastGradient; }
  void SetValueRange(const std::vector<double>& range);
  const std::vector<double>& GetValueRange() const { return this->ValueRange; }
  ///@}

  /// Whether silhouettes of images need edge voxels, not a surface.
  bool NeedsVoxels() const;

  /**
   * Edge voxels of the images of all processes, on the first one; all processes call it at once. A note says
   * if there are none.
   * @param voxels becomes them
   * @return what is wrong; empty if nothing is
   */
  std::string MakeVoxels(vtkInkStyle* style, std::span<vtkImageData* const> images, vtkPolyData* voxels);

  /// Whether a piece, wherever it was delivered to, is edge voxels.
  static bool IsOfVoxels(vtkPolyData* piece);

  /// Makes the mapper draw its input as what it is: edge voxels or a surface.
  void Follow();

  /// When it changed last which pieces are needed, or of which voxels.
  vtkMTimeType GetMTime() const { return this->Changed.GetMTime(); }

private:
  vtkInkSilhouetteMapper* const Mapper;
  vtkNew<vtkInkEdgeVoxels> EdgeVoxels;
  int Method = 0;
  double LeastGradient = 0.2;     ///< of the greatest
  std::vector<double> ValueRange; ///< of voxels; empty: all
  vtkTimeStamp Changed;
};

#endif
