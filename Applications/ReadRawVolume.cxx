#include "ReadFile.h"

#include "Errors.h"
#include "FinishVolume.h"
#include "PlainVoxels.h"
#include "Progress.h"
#include "Text.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <regex>

namespace ink::cli
{
namespace
{

const std::map<std::string, int>& rawTypes()
{
  static const std::map<std::string, int> types{ { "int8", VTK_SIGNED_CHAR }, { "uint8", VTK_UNSIGNED_CHAR },
    { "int16", VTK_SHORT }, { "uint16", VTK_UNSIGNED_SHORT }, { "int32", VTK_INT },
    { "uint32", VTK_UNSIGNED_INT }, { "int64", VTK_LONG_LONG }, { "uint64", VTK_UNSIGNED_LONG_LONG },
    { "float32", VTK_FLOAT }, { "float64", VTK_DOUBLE } };
  return types;
}

} // namespace

RawLayout RawLayout::parse(const std::string& layout)
{
  static const std::regex pattern(R"((\d{1,6})x(\d{1,6})x(\d{1,6}):(\w+))");
  std::smatch match;
  if (!std::regex_match(layout, match, pattern))
  {
    throw UsageError("--raw '" + layout + "': expected WxHxD:type, as 256x256x128:uint8");
  }
  const auto type = rawTypes().find(match[4]);
  if (type == rawTypes().end())
  {
    std::string names;
    for (const auto& [name, id] : rawTypes())
    {
      names += " " + name;
    }
    throw UsageError(
      "--raw '" + layout + "': unknown type '" + match[4].str() + "'; expected one of" + names);
  }
  RawLayout result;
  result.type = type->second;
  for (int i = 0; i < 3; ++i)
  {
    result.dimensions[i] = std::stoi(match[i + 1]);
    if (result.dimensions[i] == 0)
    {
      throw UsageError("--raw '" + layout + "': dimensions have to be 1 or more");
    }
  }
  return result;
}

Input readRawVolume(
  const std::filesystem::path& file, const RawLayout& layout, const Memory& memory, Progress& progress)
{
  std::uint64_t expected = vtkDataArray::GetDataTypeSize(layout.type);
  for (const int dimension : layout.dimensions)
  {
    expected *= static_cast<std::uint64_t>(dimension);
  }
  const std::uint64_t found = std::filesystem::file_size(file);
  if (found != expected)
  {
    failToRead(file,
      "it has " + std::to_string(found) + " bytes, but " + dimensionsText(layout.dimensions) + " " +
        vtkImageScalarTypeNameMacro(layout.type) + " needs " + std::to_string(expected));
  }

  PlainVoxels voxels;
  voxels.files = { file };
  std::copy(layout.dimensions, layout.dimensions + 3, voxels.dimensions);
  voxels.type = layout.type;
  voxels.setBigEndian(layout.bigEndian);
  vtkNew<vtkImageData> image;
  image->SetDimensions(layout.dimensions);
  image->SetSpacing(layout.spacing);
  constexpr const char* format = "raw volume";
  if (expected > memory.forWholeVolume())
  {
    return makeVolumeInput(image, voxels, format, memory);
  }
  progress.step("reading " + file.filename().string());
  image->AllocateScalars(layout.type, 1);
  PlainVoxelReader(voxels).read(
    0, { static_cast<unsigned char*>(image->GetScalarPointer()), static_cast<std::size_t>(expected) });
  return makeVolumeInput(image, file, format);
}

} // namespace ink::cli
