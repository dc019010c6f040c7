#include "ReadFile.h"

#include "Errors.h"
#include "FinishVolume.h"
#include "Text.h"

#include "vtkImageData.h"
#include "vtkInkVDBReader.h"
#include "vtkNew.h"

#include "Vdb/VdbFile.h"

#include <algorithm>
#include <cstdint>
#include <fstream>

namespace ink::cli
{

Input readVdb(
  const std::filesystem::path& file, const std::string& grid, const Memory& memory, Progress& progress)
{
  ink::VdbFile list;
  ink::VdbGridInfo chosen;
  try
  {
    std::ifstream in(file, std::ios::binary);
    list = ink::VdbFile::list(in);
    chosen = list.find(grid);
  }
  catch (const ink::VdbError& error)
  {
    failToRead(file, error.what());
  }
  vtkNew<vtkInkVDBReader> reader;
  reader->SetFileName(file.c_str());
  reader->SetGridName(chosen.name.c_str());
  constexpr std::uint64_t mebibyte = 1 << 20;
  reader->SetMaximumMemory(static_cast<int>(
    std::clamp<std::uint64_t>(memory.forWholeVolume() / mebibyte, 1, reader->GetMaximumMemoryMaxValue())));
  runReader(reader, file, progress);

  Input input = makeVolumeInput(reader->GetOutput(), file, "OpenVDB grid '" + chosen.name + "'");
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
