// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkVDBIsoSurfaceSampler
 * @brief points on the iso-surfaces of an OpenVDB grid, without converting it to an image
 *
 * Combines vtkInkVDBReader and vtkInkIsoSurfaceSampler, with bitwise equal points and normals (for an image
 * with Padding 2 or more, 3 with ProjectionSteps), but works on the tree itself: only leaves and the borders
 * of tiles are read, so that time and memory scale with the surface, not with its bounding box. A class of
 * its own, since the output type of a VTK source is fixed before execution.
 *
 * Points are sorted by iso-value, then by block of 8 x 8 x 8 cells, by z, then y, then x of the block's first
 * cell; within a block by cell in the same order. They are the same for any number of threads. Each piece has
 * a share of the blocks; all pieces together have exactly the points of the whole.
 *
 * With Smoothing, Subdivision, a Cut or parts left out, tiles of 32 x 32 x 32 voxels take the place of
 * blocks: each is copied with what its values depend on. Points and normals then are those of
 * vtkInkIsoSurfaceSampler on an image with as large a Padding as the Gaussian reaches.
 *
 * Readable grids, their names, the sign of level sets and errors are as in vtkInkVDBReader; point arrays and
 * iso-values as in vtkInkIsoSurfaceSampler. The grid is cached for the next iso-value.
 *
 * @sa vtkInkVDBReader vtkInkIsoSurfaceSampler
 */
#ifndef vtkInkVDBIsoSurfaceSampler_h
#define vtkInkVDBIsoSurfaceSampler_h

#include "vtkInkIOVDBModule.h" // for the export macro
#include "vtkInkIsoSurfaceAlgorithm.h"
#include "vtkNew.h" // for the names

#include <cstdint> // for memory
#include <memory>  // for the file

class vtkStringArray;
class InkVDBSource;
struct InkVDBSampleRequest;
struct InkVDBSamples;

// VTK's wrapper generator does not know what is in it.
#ifndef __VTK_WRAP__
namespace ink
{
class VdbGrid;
}
#endif

class VTKINKIOVDB_EXPORT vtkInkVDBIsoSurfaceSampler : public vtkInkIsoSurfaceAlgorithm
{
public:
  static vtkInkVDBIsoSurfaceSampler* New();
  vtkTypeMacro(vtkInkVDBIsoSurfaceSampler, vtkInkIsoSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. Default: none, which is an error.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * The name of the grid to sample. Default: none, which selects the first readable grid.
   */
  vtkSetStringMacro(GridName);
  vtkGetStringMacro(GridName);
  ///@}

  /**
   * The names of the grids that can be sampled, after UpdateInformation().
   */
  vtkStringArray* GetGridNames();

  vtkIdType CountActiveCells(double isoValue) override;

  ///@{
  /**
   * Multiply the values of level sets by -1, so that their inside is the denser side and normals point
   * outwards. Iso-values refer to the result. Default: on.
   */
  vtkSetMacro(InvertLevelSets, bool);
  vtkGetMacro(InvertLevelSets, bool);
  vtkBooleanMacro(InvertLevelSets, bool);
  ///@}

#ifndef __VTK_WRAP__
  ink::SuggestedSmoothing SuggestSmoothings(double isoValue) override;
  std::vector<double> FindIsoValues() override;
  vtkSmartPointer<vtkImageData> MakeFrame() override;
  bool SampleParts(const PartSink& sink) override;
  ink::FiniteRange FindRange() override;
#endif

protected:
  vtkInkVDBIsoSurfaceSampler();
  ~vtkInkVDBIsoSurfaceSampler() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkVDBIsoSurfaceSampler(const vtkInkVDBIsoSurfaceSampler&) = delete;
  void operator=(const vtkInkVDBIsoSurfaceSampler&) = delete;

  /// @throws ink::VdbError
  const ink::VdbGrid& ReadGrid();
  /// What the properties say.
  InkVDBSampleRequest MakeRequest(
    const ink::VdbGrid& grid, std::vector<double> isoValues, int piece, int pieces) const;
  /// Whether values are multiplied by -1, see InvertLevelSets.
  bool Negates(const ink::VdbGrid& grid) const;
  /// What MaximumMemory leaves beside the grid, in bytes.
  std::uint64_t MemoryBeside(const ink::VdbGrid& grid) const;
  /// In how many pieces a surface is sampled so that memory has room for each.
  int CountPieces(const ink::VdbGrid& grid) const;
  /// Reports what a function throws. @param output emptied then, may be null @return whether it threw nothing
  bool TrySampling(vtkPolyData* output, const std::function<void()>& sample);
  void FillOutput(const InkVDBSamples& samples, vtkPolyData* output);

  char* FileName = nullptr;
  char* GridName = nullptr;
  bool InvertLevelSets = true;
  /// Whether reading the list of grids failed, which has been reported.
  bool Failed = false;
  std::unique_ptr<InkVDBSource> Source;
  vtkNew<vtkStringArray> Names;
};

#endif
