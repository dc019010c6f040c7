// SPDX-License-Identifier: BSD-3-Clause
#include "InputArguments.h"

#include "Core/FormatNumber.h"
#include "Errors.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace ink::cli
{
namespace
{

#ifdef INK_WITH_OPENVDB
constexpr const char* vdbSuffix = " .vdb";
#else
constexpr const char* vdbSuffix = "";
#endif

} // namespace

std::string InputArguments::fileHelp(const std::string& mesh)
{
  return "volume: .nii .nii.gz .hdr/.img .nrrd .nhdr .mha .mhd .mrc .map .ccp4 .mgz .npy .slc .cube .vti "
         ".vtr .vts .vtk .tif .dcm .raw" +
    std::string(vdbSuffix) + ", a folder of DICOM or TIFF files, or any file with --raw;\n" + mesh +
    ": .ply .obj .off .stl .vtp .vtu .vtk .gii .xyz .pcd";
}

void InputArguments::addFile(CLI::App* command, const std::string& mesh)
{
  command->add_option("FILE", this->file, fileHelp(mesh))->required();
}

void InputArguments::addReading(CLI::App* command)
{
  command
    ->add_option("--crop", this->crop,
      "keep only what lies in a box, in the file's coordinates as 'ink info' has them, of a volume in whole "
      "voxels")
    ->delimiter(',')
    ->expected(6)
    ->allow_extra_args(false)
    ->type_name("x0,x1,y0,y1,z0,z1")
    ->check(anyNumber());
  command
    ->add_option("--spacing", this->spacing,
      "distances between voxels, in place of those that the file says or, as raw and most TIFF files, does "
      "not say")
    ->delimiter(',')
    ->expected(3)
    ->allow_extra_args(false)
    ->type_name("x,y,z")
    ->check(within(1e-12, 1e12));
  command
    ->add_option("--memory", this->memory,
      "about how much memory to use, as 800MiB or 4GiB (half of the machine's). Volumes in raw files and in\n"
      "uncompressed NIfTI, NRRD, MetaImage, MRC, TIFF and legacy VTK files that are larger are read a few "
      "slices at a time")
    ->type_name("SIZE");
  command
    ->add_option("--raw", this->raw,
      "FILE is nothing but voxels, x fastest. Types: uint8, int8, uint16, ... int64, float32, float64")
    ->type_name("WxHxD:type")
    ->group("Raw files");
  command->add_flag("--big-endian", this->bigEndian, "byte order of a --raw file (little endian)")
    ->group("Raw files")
    ->needs("--raw");
#ifdef INK_WITH_OPENVDB
  command
    ->add_option("--grid", this->grid, "which grid of a .vdb file; without it the first that can be read")
    ->type_name("NAME")
    ->group("OpenVDB files")
    ->excludes("--raw");
#endif
}

InputOptions InputArguments::options() const
{
  InputOptions options;
  options.file = this->file;
  options.grid = this->grid;
  std::copy(this->spacing.begin(), this->spacing.end(), options.spacing.begin());
  if (this->raw)
  {
    options.raw = RawLayout::parse(*this->raw);
    options.raw->bigEndian = this->bigEndian;
  }
  if (!this->crop.empty())
  {
    std::copy_n(this->crop.begin(), 6, options.crop.emplace().begin());
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (this->crop[2 * axis] > this->crop[2 * axis + 1])
      {
        throw UsageError("--crop: expected x0 <= x1, y0 <= y1 and z0 <= z1, found " +
          formatNumber(this->crop[2 * axis]) + " and " + formatNumber(this->crop[2 * axis + 1]));
      }
    }
  }
  if (!this->memory.empty())
  {
    options.memory = parseMemory(this->memory);
  }
  return options;
}

} // namespace ink::cli
