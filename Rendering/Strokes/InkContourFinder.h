// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkContourFinder_h
#define InkContourFinder_h

#include "Curves/Contours/Contours.h"
#include "Curves/Contours/Eye.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"

#include <span>

/// What a silhouette mapper finds contours of, made ready for any eye: a mesh, or an image's iso-surfaces.
class InkContourFinder
{
public:
  virtual ~InkContourFinder() = default;

  /// When it was made ready, on VTK's clock; 0: it is not.
  vtkMTimeType GetTime() const { return this->Ready ? this->Time.GetMTime() : 0; }

  struct Found
  {
    ink::Contours Contours;
    /// The same with all their arrays: their priority by length, and as ids for selection a point of the
    /// input beside each of theirs.
    vtkSmartPointer<vtkPolyData> Lines;
  };
  /// @throws std::invalid_argument for an eye that is not finite, or with a direction of zero
  virtual Found Find(const ink::Eye& eye) const = 0;

protected:
  void SetReady(bool ready);

  /// @param cellIds as InkMakeContourLines has them
  /// @param sources of each point of the contours, the id for selection
  static vtkSmartPointer<vtkPolyData> MakeLines(
    const ink::Contours& contours, std::span<const vtkIdType> cellIds, std::span<const vtkIdType> sources);

private:
  bool Ready = false;
  vtkTimeStamp Time;
};

#endif
