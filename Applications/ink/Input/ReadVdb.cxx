// SPDX-License-Identifier: BSD-3-Clause
#include "ReadFile.h"

#include "Core/FormatNumber.h"
#include "Errors.h"
#include "Progress.h"
#include "SampleVdb.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInkVDBReader.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include "Fields/Vdb/VdbGrid.h"

#include <algorithm>
#include <cstdint>
#include <fstream>

namespace ink::cli
{
namespace
{

void requireMemory(
  const std::filesystem::path& file, const std::string& what, std::uint64_t bytes, const Memory& memory)
{
  if (bytes > memory.forWholeVolume())
  {
    failToRead(file,
      what + " takes " + memoryText(bytes) + ": expected --memory " + memoryText(Memory::limitFor(bytes, 2)) +
        " or more, found " + memoryText(memory.limit));
  }
}

/// Of the image, from its extent.
std::uint64_t announcedBytes(vtkInkVDBReader* reader, const VdbGridInfo& grid)
{
  const int* extent = reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  double bytes = grid.isDouble ? sizeof(double) : sizeof(float);
  for (int i = 0; i < 3; ++i)
  {
    bytes *= std::max(static_cast<double>(extent[2 * i + 1]) - extent[2 * i] + 1.0, 0.0);
  }
  // A sparse grid's box may have more voxels than there are numbers of 64 bits.
  constexpr double moreThanAnyMachine = 1LL << 60;
  return static_cast<std::uint64_t>(std::min(bytes, moreThanAnyMachine));
}

vtkSmartPointer<vtkImageData> readImage(const std::filesystem::path& file, const VdbGridInfo& grid,
  std::uint64_t treeBytes, const Memory& memory, Progress& progress)
{
  vtkNew<vtkInkVDBReader> reader;
  reader->SetFileName(file.c_str());
  reader->SetGridName(grid.name.c_str());
  reader->SetMaximumMemory(0);
  readHeader(reader, file, progress);
  requireMemory(
    file, "grid '" + grid.name + "' as an image", announcedBytes(reader, grid) + treeBytes, memory);
  runReader(reader, file, progress);
  return reader->GetOutput();
}

} // namespace

Input readVdb(const std::filesystem::path& file, const std::string& grid, Wanted wanted, const Memory& memory,
  Progress& progress)
{
  progress.step("reading " + file.filename().string());
  ink::VdbFile list;
  ink::VdbGridInfo chosen;
  std::uint64_t treeBytes = 0;
  try
  {
    std::ifstream in(file, std::ios::binary);
    list = ink::VdbFile::list(in);
    chosen = list.find(grid);
    treeBytes = ink::VdbGrid::memoryOf(in, chosen);
  }
  catch (const ink::VdbError& error)
  {
    failToRead(file, error.what());
  }
  requireMemory(file, "grid '" + chosen.name + "'", treeBytes, memory);

  Input input;
  input.format = "OpenVDB grid '" + chosen.name + "'";
  if (wanted == Wanted::GivenSurfaces || (wanted == Wanted::Surface && chosen.surface))
  {
    const std::uint64_t voxels = treeBytes / (chosen.isDouble ? sizeof(double) : sizeof(float));
    input.volumeSampler = makeVdbSampler(file, chosen, voxels);
  }
  else
  {
    const vtkSmartPointer<vtkImageData> image = readImage(file, chosen, treeBytes, memory, progress);
    if (image->GetNumberOfPoints() == 0)
    {
      failToRead(file, "it holds no voxels");
    }
    input.data = image;
  }
  input.surfaceValue = chosen.surface;
  if (list.grids.size() > 1)
  {
    std::string others;
    for (const ink::VdbGridInfo& other : list.grids)
    {
      if (&other - list.grids.data() != &list.find(chosen.name) - list.grids.data())
      {
        others += (others.empty() ? "'" : ", '") + other.name + "' (" + other.type + ")";
      }
    }
    input.notes.push_back("grid '" + chosen.name + "' is used; the file also holds " + others);
  }
  if (chosen.gridClass == ink::VdbClass::LevelSet)
  {
    input.notes.emplace_back(
      "it is a level set; its values are multiplied by -1, so that its inside is denser");
  }
  return input;
}

} // namespace ink::cli
