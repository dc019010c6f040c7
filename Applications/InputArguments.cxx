#include "InputArguments.h"

#include <algorithm>
#include <sstream>

namespace ink::cli
{

CLI::Validator within(double least, double greatest)
{
  std::ostringstream range;
  range << least << " to " << greatest;
  return { [range = range.str(), least, greatest](std::string& text)
    {
      double value = 0;
      const bool valid = CLI::detail::lexical_cast(text, value) && value >= least && value <= greatest;
      return valid ? std::string() : "'" + text + "': expected a number from " + range;
    },
    range.str(), "within" };
}

void InputArguments::addFile(CLI::App* command, const std::string& mesh)
{
  command
    ->add_option("FILE", this->file,
      "volume: .nii .nii.gz .nrrd .nhdr .mha .mhd .vti .vtk, a folder of DICOM files, or any file with "
      "--raw;\n" +
        mesh + ": .ply .obj .stl .vtp")
    ->required();
}

void InputArguments::addReading(CLI::App* command)
{
  command
    ->add_option("--raw", this->raw,
      "FILE is nothing but voxels, x fastest. Types: uint8, int8, uint16, ... int64, float32, float64")
    ->type_name("WxHxD:type")
    ->group("Raw files");
  command->add_option("--spacing", this->spacing, "distances between voxels of a --raw file (1,1,1)")
    ->delimiter(',')
    ->expected(3)
    ->type_name("x,y,z")
    ->group("Raw files")
    ->needs("--raw")
    ->check(within(1e-12, 1e12));
  command->add_flag("--big-endian", this->bigEndian, "byte order of a --raw file (little endian)")
    ->group("Raw files")
    ->needs("--raw");
}

InputOptions InputArguments::options() const
{
  InputOptions options;
  options.file = this->file;
  if (this->raw)
  {
    options.raw = RawLayout::parse(*this->raw);
    std::copy(this->spacing.begin(), this->spacing.end(), options.raw->spacing);
    options.raw->bigEndian = this->bigEndian;
  }
  return options;
}

} // namespace ink::cli
