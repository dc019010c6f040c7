// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkKeptSamples_h
#define InkKeptSamples_h

#include "InkAddCuts.h"

#include "IsoSurface/IsoSurfaceSamples.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <optional>
#include <vector>

class vtkDataArray;
class vtkPoints;
class vtkPolyData;

/// The arrays of a sampler's output, kept from one run to the next and written again where nobody else holds
/// them: memory that the system has given once need not be cleared again.
class InkKeptSamples
{
public:
  /// Arrays for the next run, which may have any size.
  /// @param pointType VTK_FLOAT or VTK_DOUBLE
  /// @param normalType VTK_FLOAT, VTK_SHORT or VTK_SIGNED_CHAR; VTK_VOID: none
  InkSampleArrays Renew(int pointType, int normalType, bool cells);
  /// ink::GrowRoom of such arrays.
  static ink::SampleRoom Grow(const InkSampleArrays& arrays, std::size_t count);
  void Release();

  /// What the output is to have besides points.
  struct Contents
  {
    bool Normals;
    bool SurfaceIndex; ///< where there are several surfaces
    bool CellIds;
    bool Vertices;
    std::optional<double> Radius; ///< of all samples, but for those of rims
    bool Rims;                    ///< whether there may be some
  };
  /// Puts as many samples into the output as Counts says.
  void Fill(const Contents& contents, vtkPolyData* output);

  /// The number of samples of each surface in the last run.
  std::vector<std::size_t> Counts;

private:
  vtkSmartPointer<vtkPoints> Points;
  vtkSmartPointer<vtkDataArray> Normals;
  vtkSmartPointer<vtkDataArray> Radii;
  vtkSmartPointer<vtkDataArray> SurfaceIndex;
  vtkSmartPointer<vtkDataArray> CellIds;
  vtkSmartPointer<vtkDataArray> Vertices;
};

#endif
