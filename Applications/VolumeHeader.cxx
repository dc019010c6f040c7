#include "VolumeHeader.h"

#include "FinishVolume.h"
#include "Progress.h"
#include "ReadFile.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>

namespace ink::cli
{
namespace
{

void readInto(vtkImageData* image, const PlainVoxels& voxels, Progress& progress)
{
  // Some slices at a time, to say how far it is.
  constexpr std::uint64_t bytesOfAStep = 1 << 24;
  const std::uint64_t sliceBytes = voxels.sliceValues() * voxels.valueSize();
  const int atOnce = static_cast<int>(std::clamp<std::uint64_t>(bytesOfAStep / sliceBytes, 1, 1 << 16));
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  PlainVoxelReader reader(voxels);
  for (int first = 0; first < voxels.dimensions[2]; first += atOnce)
  {
    progress.part(static_cast<double>(first) / voxels.dimensions[2], 1.0);
    const int count = std::min(atOnce, voxels.dimensions[2] - first);
    reader.read(first, { values + static_cast<std::uint64_t>(first) * sliceBytes, count * sliceBytes });
  }
}

} // namespace

Input readVoxels(const std::filesystem::path& file, const VolumeHeader& header, const std::string& format,
  const Memory& memory, Progress& progress)
{
  const PlainVoxels& voxels = header.voxels;
  voxels.check(file);
  progress.step("reading " + file.filename().string());
  vtkNew<vtkImageData> image;
  image->SetDimensions(voxels.dimensions);
  image->SetSpacing(header.spacing);
  image->SetOrigin(header.origin);
  std::vector<std::string> notes = header.notes;
  if (header.orientation && !header.orientation->apply(image))
  {
    notes.emplace_back("its axes are not at right angles; they are taken as the world's");
  }

  Input input;
  const bool asStored = header.slope == 0.0 || (header.slope == 1.0 && header.intercept == 0.0);
  const std::uint64_t bytes = voxels.fileBytes() / static_cast<std::uint64_t>(voxels.components);
  if (voxels.encoding == VoxelEncoding::Plain && asStored && bytes > memory.forWholeVolume())
  {
    input = makeVolumeInput(image, voxels, format, memory);
  }
  else
  {
    requireMemory(file, bytes, memory);
    image->AllocateScalars(voxels.type, 1);
    readInto(image, voxels, progress);
    input = makeVolumeInput(image, file, format);
  }
  setComponents(input, header.components);
  input.notes.insert(input.notes.end(), notes.begin(), notes.end());
  if (!asStored)
  {
    rescale(input, header.slope, header.intercept);
  }
  return input;
}

double spacingOf(double given)
{
  return std::isfinite(given) && given != 0.0 ? std::abs(given) : 1.0;
}

} // namespace ink::cli
