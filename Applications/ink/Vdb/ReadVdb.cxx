// SPDX-License-Identifier: BSD-3-Clause
#include "VdbParts.h"

#include "Core/FormatNumber.h"
#include "Errors.h"
#include "Progress.h"
#include "ReadFile.h"

#include "InkImageSlabs.h"

#include "vtkImageData.h"
#include "vtkInkVDBIsoSurfaceSampler.h"
#include "vtkInkVDBReader.h"
#include "vtkNew.h"

#include "Fields/Vdb/VdbGrid.h"

#include <algorithm>
#include <cstdint>
#include <fstream>

namespace ink::cli
{
namespace
{

void requireMemory(const std::filesystem::path& file, const std::string& what, std::uint64_t bytes,
  const InkMemoryBudget& memory)
{
  if (bytes > memory.ForWholeImage())
  {
    failToRead(file,
      what + " takes " + InkFormatMemory(bytes) + ": expected --memory " +
        InkFormatMemory(InkMemoryBudget::LimitFor(bytes, 2)) + " or more, found " +
        InkFormatMemory(memory.Limit));
  }
}

vtkSmartPointer<vtkImageData> readImage(
  const InputOptions& options, const VdbGridInfo& grid, std::uint64_t treeBytes, Progress& progress)
{
  const std::filesystem::path& file = options.file;
  vtkNew<vtkInkVDBReader> reader;
  reader->SetFileName(file.c_str());
  reader->SetGridName(grid.name.c_str());
  reader->SetMaximumMemory(0);
  readHeader(reader, file, progress);
  const std::uint64_t bytes = InkImageSlabs::GetBytes(reader->GetOutputInformation(0));
  requireMemory(file, "grid '" + grid.name + "' as an image", bytes + treeBytes, options.memory);
  runReader(reader, file, progress);
  return reader->GetOutput();
}

} // namespace

Input readVdb(const InputOptions& options, Wanted wanted, Progress& progress)
{
  const std::filesystem::path& file = options.file;
  progress.step("reading " + file.filename().string());
  ink::VdbFile list;
  ink::VdbGridInfo chosen;
  std::uint64_t treeBytes = 0;
  try
  {
    std::ifstream in(file, std::ios::binary);
    list = ink::VdbFile::list(in);
    chosen = list.find(options.grid);
    treeBytes = ink::VdbGrid::memoryOf(in, chosen);
  }
  catch (const ink::VdbError& error)
  {
    failToRead(file, error.what());
  }
  requireMemory(file, "grid '" + chosen.name + "'", treeBytes, options.memory);

  Input input;
  input.format = "OpenVDB grid '" + chosen.name + "'";
  if (wanted == Wanted::GivenSurfaces || (wanted == Wanted::Surface && chosen.surface))
  {
    vtkNew<vtkInkVDBIsoSurfaceSampler> sampler;
    sampler->SetFileName(file.c_str());
    sampler->SetGridName(chosen.name.c_str());
    sampler->SetMaximumMemory(options.memory.GetMebibytes());
    input.sampler = sampler;
  }
  else
  {
    const vtkSmartPointer<vtkImageData> image = readImage(options, chosen, treeBytes, progress);
    if (image->GetNumberOfPoints() == 0)
    {
      failToRead(file, "it holds no voxels");
    }
    input.data = cropped(image, options);
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
