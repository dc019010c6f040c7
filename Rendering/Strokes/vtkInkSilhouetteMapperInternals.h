// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkInkSilhouetteMapperInternals_h
#define vtkInkSilhouetteMapperInternals_h

#include "InkActorResources.h"
#include "InkImageContourFinder.h"
#include "InkMeshContourFinder.h"
#include "vtkInkSilhouetteMapper.h"

#include "Curves/Contours/CoherentDashes.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

struct InkFrame;

class vtkInkSilhouetteMapper::vtkInternals
{
public:
  /// The eye in the coordinates of the data of a frame's actor.
  static ink::Eye FindEye(const InkFrame& frame);

  InkMeshContourFinder OfMesh;
  InkImageContourFinder OfImage;
  InkContourFinder* Finder = nullptr; ///< that of the input
  vtkMTimeType CheckedTime = 0;       ///< of the surface whose faces were checked

  struct Drawn
  {
    vtkMTimeType FinderTime = 0; ///< of the finder that the lines are of
    ink::Eye Eye;
    vtkSmartPointer<vtkPolyData> Lines;
    ink::CoherentDashes Dashes;
    double Period = 0.0; ///< that the lines are aligned for, in the surface's unit; 0: they are not aligned

    /// Moves the lines' dashes.
    /// @param contours what the lines are of
    void AlignDashes(ink::Contours& contours, double period);
  };
  InkActorResources<Drawn> Views;
};

#endif
