// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the representation "Stipple" draws of its input, found by all processes together.
 */
#ifndef vtkInkMakeStipples_h
#define vtkInkMakeStipples_h

#include "vtkSmartPointer.h"

#include <optional>
#include <string>

class vtkAlgorithmOutput;
class vtkDataObject;
class vtkInformation;
class vtkInkStippleGenerator;
class vtkMultiProcessController;
class vtkPolyData;

struct vtkInkStippleRequest
{
  vtkInkStippleGenerator* Generator = nullptr; ///< with its properties, but without input
  vtkMultiProcessController* Controller = nullptr;
  vtkAlgorithmOutput* Port = nullptr; ///< what the input comes from
  vtkInformation* Update = nullptr;   ///< the piece and time of the input
  std::string Scalars;                ///< of images; empty: the active ones
  std::string ColorArray;             ///< empty: the active scalars of points
  int ColorAssociation = 0;
  std::optional<double> IsoValue; ///< of images: the surface that hides what lies behind it
  bool SurfaceHides = true;       ///< of meshes: whether they hide what lies behind them
  double PictureSize = 0.0;       ///< of meshes: pixels of the picture whose room says how many stipples
};

/// Parts of a drawing, which all processes' make whole; those of a mesh are all on the first one.
struct vtkInkMadeStipples
{
  vtkSmartPointer<vtkPolyData> Stipples; ///< never null
  vtkSmartPointer<vtkPolyData> Surface;  ///< that hides stipples; never null, empty: none
  /// Whether point i is point i of the input, which then consists of stipples already.
  bool IdsAreInputs = false;
  bool OfImage = false;
  ///@{
  /// The array that goes with the stipples, on all processes; empty: none.
  std::string ColorArray;
  int ColorAssociation = 0;
  ///@}
  /// What of the input cannot be drawn and what was expected instead; empty if all can.
  std::string Problem;
};

/**
 * Stipples images, with percentiles and ranges of all processes' images together, so that parts of an image
 * with ghost cells give exactly what the whole does. Where no process has an image, data that is stipples
 * already is drawn as it is. Where there is neither, the outer surfaces of all data of all processes are put
 * together (see vtkInkGatherMesh) and stippled by the first process, so that they give what the whole does.
 * To be called by all processes at once, also without data.
 */
vtkInkMadeStipples vtkInkMakeStipples(vtkDataObject* input, const vtkInkStippleRequest& request);

#endif
