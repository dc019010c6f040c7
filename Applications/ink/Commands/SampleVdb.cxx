// SPDX-License-Identifier: BSD-3-Clause
#include "SampleVdb.h"

#include "Core/FormatNumber.h"
#include "Errors.h"
#include "Memory.h"
#include "Pattern.h"
#include "Progress.h"
#include "VtkMessages.h"

#include "Fields/Vdb/VdbGrid.h"
#include "Statistics/FiniteRange.h"

#include "vtkInkVDBIsoSurfaceSampler.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <fstream>

namespace ink::cli
{
namespace
{

class VdbSampler
{
public:
  VdbSampler(const std::filesystem::path& file, const VdbGridInfo& grid, const VolumeSampling& sampling,
    const Memory& memory)
    : WithIndex(sampling.surfaceIndex)
  {
    this->Sampler->SetFileName(file.c_str());
    this->Sampler->SetGridName(grid.name.c_str());
    setUp(this->Sampler.Get(), sampling);
    this->Sampler->SetSmallestPart(sampling.parts.smallestShare);
    this->Sampler->SetLargestParts(static_cast<int>(sampling.parts.largest));
    constexpr std::uint64_t mebibyte = 1 << 20;
    this->Sampler->SetMaximumMemory(static_cast<int>(
      std::min<std::uint64_t>(memory.limit / mebibyte, this->Sampler->GetMaximumMemoryMaxValue())));
  }

  vtkAlgorithm* algorithm() { return this->Sampler; }

  /// @param pieces in which the surface is sampled, so that few points are made at a time
  std::uint64_t sample(int surface, double isoValue, int pieces, const PointSink& sink)
  {
    std::uint64_t count = 0;
    this->Sampler->SetValue(0, isoValue);
    for (int piece = 0; piece < pieces; ++piece)
    {
      this->Sampler->UpdatePiece(piece, pieces, 0);
      if (const std::string problem = this->Messages.error(); !problem.empty())
      {
        throw Failure(inTermsOfInk(problem));
      }
      vtkNew<vtkPolyData> points;
      points->ShallowCopy(this->Sampler->GetOutput());
      this->Sampler->GetOutput()->Initialize();
      if (this->WithIndex)
      {
        addSurfaceIndex(points, surface);
      }
      count += static_cast<std::uint64_t>(points->GetNumberOfPoints());
      sink(surface, points);
    }
    return count;
  }

private:
  /// Where the sampler names its own limit, the user has set another.
  static std::string inTermsOfInk(const std::string& problem)
  {
    return io::Pattern("\\(MaximumMemory\\)").replace(problem, "(--memory)");
  }

  bool WithIndex;
  vtkNew<vtkInkVDBIsoSurfaceSampler> Sampler;
  const VtkMessages Messages;
};

/// The values of a grid as vtkInkVDBIsoSurfaceSampler sees them.
FiniteRange valuesOf(const std::filesystem::path& file, const std::string& grid)
{
  std::ifstream in(file, std::ios::binary);
  const VdbFile list = VdbFile::list(in);
  const VdbGridInfo& info = list.find(grid);
  return VdbGrid::read(in, list, info).values(info.gridClass == VdbClass::LevelSet);
}

} // namespace

VolumeSampler makeVdbSampler(const std::filesystem::path& file, const VdbGridInfo& grid, std::uint64_t voxels)
{
  return [=](const VolumeSampling& sampling, const Memory& memory, const PointSink& sink, Progress& progress)
  {
    // Parts are those of the whole, which each piece would look at again.
    const std::uint64_t points = voxels * pointsPerCell(sampling);
    const std::uint64_t pieces =
      sampling.parts.keepsAll() ? points * bytesPerPoint / memory.forNewPoints() + 1 : 1;
    std::uint64_t total = 0;
    bool missing = false;
    {
      VdbSampler sampler(file, grid, sampling, memory);
      progress.step("sampling the surface", sampler.algorithm());
      for (std::size_t n = 0; n < sampling.isoValues.size(); ++n)
      {
        const std::uint64_t count =
          sampler.sample(static_cast<int>(n), sampling.isoValues[n], static_cast<int>(pieces), sink);
        missing = missing || count == 0;
        total += count;
      }
    }
    // Looking at all values takes as long as reading the grid again: only where there is reason to ask.
    if (missing)
    {
      checkIsoValues(sampling.isoValues, valuesOf(file, grid.name));
    }
    if (total == 0)
    {
      throw Failure("no surface at iso-value " + formatNumber(sampling.isoValues.front()));
    }
    return std::vector<std::string>();
  };
}

} // namespace ink::cli
