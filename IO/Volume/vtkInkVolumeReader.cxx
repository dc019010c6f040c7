// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkVolumeReader.h"

#include "Core/FormatNumber.h"
#include "DicomFile.h"
#include "FileFormats.h"
#include "GridVolume.h"
#include "InkKeepRange.h"
#include "InkReportReadError.h"
#include "InkVTKCompat.h"
#include "RawVolume.h"
#include "ReadError.h"
#include "VolumeHeader.h"
#include "XmlVolume.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;
namespace io = ink::io;

vtkStandardNewMacro(vtkInkVolumeReader);

namespace
{

struct Format
{
  const char* suffix;
  io::VolumeHeader (*readHeader)(const fs::path& file); ///< null: it is XML
  bool isGrid = false;                                  ///< whether that is none of an image
};
constexpr Format formats[] = { { ".nii", io::readNiftiHeader }, { ".nii.gz", io::readNiftiHeader },
  { ".hdr", io::readNiftiHeader }, { ".hdr.gz", io::readNiftiHeader }, { ".img", io::readNiftiHeader },
  { ".img.gz", io::readNiftiHeader }, { ".nrrd", io::readNrrdHeader }, { ".nhdr", io::readNrrdHeader },
  { ".mha", io::readMetaImageHeader }, { ".mhd", io::readMetaImageHeader }, { ".mrc", io::readMrcHeader },
  { ".mrc.gz", io::readMrcHeader }, { ".map", io::readMrcHeader }, { ".map.gz", io::readMrcHeader },
  { ".ccp4", io::readMrcHeader }, { ".ccp4.gz", io::readMrcHeader }, { ".vti", nullptr },
  { ".vtr", nullptr, true }, { ".vts", nullptr, true }, { ".vtk", io::readLegacyHeader },
  { ".mgh", io::readMghHeader }, { ".mgz", io::readMghHeader }, { ".npy", io::readNpyHeader },
  { ".raw", io::readNamedRawHeader }, { ".raw.gz", io::readNamedRawHeader }, { ".slc", io::readSlcHeader },
  { ".cube", io::readCubeHeader }, { ".tif", io::readTiffHeader }, { ".tiff", io::readTiffHeader },
  { ".dcm", io::readDicomHeaders } };
constexpr Format dicom{ "", io::readDicomHeaders };

std::string Text(const char* characters)
{
  return characters ? characters : "";
}

/// @throws ink::io::ReadError if it is none
const Format& FormatOf(const fs::path& file)
{
  const Format* format = io::findFormat(formats, file);
  // Some of DICOM's files end as one of a pair.
  const bool isAlone = io::suffixOf(file) == ".img" && !io::findOtherOfPair(file);
  if ((!format || isAlone) && vtkInkVolumeReader::IsDicomFile(file.c_str()))
  {
    return dicom;
  }
  if (format)
  {
    return *format;
  }
  io::failToRead(file,
    "unknown type '" + io::suffixOf(file) + "'; expected one of " + vtkInkVolumeReader::GetFileExtensions() +
      ", a folder of DICOM or TIFF files, or any file with Raw");
}

/// As a term of the stored value v.
std::string FormatScale(const io::ValueScale& scale)
{
  const std::string scaled = scale.slope == 1.0 ? "v" : ink::formatNumber(scale.slope) + " v";
  return scale.intercept == 0.0
    ? scaled
    : scaled + (scale.intercept < 0.0 ? " - " : " + ") + ink::formatNumber(std::abs(scale.intercept));
}

} // namespace

/// What there is to read: voxels after a header, XML, or a grid that is made an image.
struct vtkInkVolumeReader::Source
{
  io::VolumeHeader Header;
  std::optional<io::XmlVolume> Xml;
  std::optional<io::GridVolume> Grid;
  vtkNew<vtkImageData> Frame; ///< where the voxels after a header lie; of a grid, with their values
  std::vector<std::string> Notes;

  explicit Source(io::VolumeHeader&& header, const fs::path& file)
    : Header(std::move(header))
  {
    if (!this->Header.coordinates.empty())
    {
      this->Grid.emplace(this->Header);
      return;
    }
    this->Header.voxels.check(file);
    this->Frame->SetDimensions(this->Header.voxels.dimensions);
    this->Frame->SetSpacing(this->Header.spacing);
    this->Frame->SetOrigin(this->Header.origin);
    using Axes = io::Orientation::Axes;
    const Axes axes =
      this->Header.orientation ? this->Header.orientation->apply(this->Frame) : Axes::AtRightAngles;
    if (axes != Axes::AtRightAngles)
    {
      this->Header.notes.emplace_back(axes == Axes::Sheared
          ? "its axes are not at right angles; they are taken as the nearest that are"
          : "its axes lie in a plane; they are taken as the world's");
    }
    this->NoteComponents();
    this->Notes.insert(this->Notes.end(), this->Header.notes.begin(), this->Header.notes.end());
    if (!this->Header.sliceScales.empty())
    {
      this->Notes.emplace_back("its stored values are rescaled, those of each slice by its own scale");
    }
    else if (this->Header.isScaled())
    {
      this->Notes.push_back("its stored values are rescaled: " + FormatScale(this->Header.scale));
    }
  }
  /// Of XML.
  Source(const fs::path& file, bool isGrid)
  {
    if (isGrid)
    {
      this->Grid.emplace(file);
      this->Header.format = this->Grid->format();
    }
    else
    {
      this->Xml.emplace(file);
      this->Header.format = io::XmlVolume::format;
    }
  }

  static std::unique_ptr<Source> Open(const fs::path& file)
  {
    if (fs::is_directory(file))
    {
      return std::make_unique<Source>(
        io::isFolderOfTiffs(file) ? io::readTiffHeader(file) : io::readDicomHeaders(file), file);
    }
    const Format& format = FormatOf(file);
    return format.readHeader ? std::make_unique<Source>(format.readHeader(file), file)
                             : std::make_unique<Source>(file, format.isGrid);
  }

  /// Reads a grid, of which only then is known what image it becomes.
  void Announce(vtkInformation* info, const ink::Progress& progress);
  void Read(const int extent[6], vtkImageData* image, const ink::Progress& progress);

private:
  void NoteComponents();
};

void vtkInkVolumeReader::Source::Announce(vtkInformation* info, const ink::Progress& progress)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  if (this->Grid)
  {
    this->Notes = this->Header.notes;
    this->Header.components = this->Grid->read(this->Frame, this->Notes, progress);
    this->NoteComponents();
  }
  if (!this->Xml)
  {
    info->Set(SDDP::WHOLE_EXTENT(), this->Frame->GetExtent(), 6);
    info->Set(vtkDataObject::ORIGIN(), this->Frame->GetOrigin(), 3);
    info->Set(vtkDataObject::SPACING(), this->Frame->GetSpacing(), 3);
    info->Set(vtkDataObject::DIRECTION(), this->Frame->GetDirectionMatrix()->GetData(), 9);
    vtkDataObject::SetPointDataActiveScalarInfo(
      info, this->Grid ? this->Frame->GetScalarType() : this->Header.valueType(), 1);
    return;
  }
  vtkInformation* from = this->Xml->information();
  info->CopyEntry(from, SDDP::WHOLE_EXTENT());
  info->CopyEntry(from, vtkDataObject::ORIGIN());
  info->CopyEntry(from, vtkDataObject::SPACING());
  info->CopyEntry(from, vtkDataObject::DIRECTION());
  vtkInformation* scalars = vtkDataObject::GetActiveFieldInformation(
    from, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  if (scalars && scalars->Has(vtkDataObject::FIELD_ARRAY_TYPE()))
  {
    vtkDataObject::SetPointDataActiveScalarInfo(info, scalars->Get(vtkDataObject::FIELD_ARRAY_TYPE()), 1);
  }
}

void vtkInkVolumeReader::Source::NoteComponents()
{
  if (this->Header.components > 1)
  {
    this->Notes.push_back(
      "its voxels have " + std::to_string(this->Header.components) + " components; the first is used");
  }
}

void vtkInkVolumeReader::Source::Read(const int extent[6], vtkImageData* image, const ink::Progress& progress)
{
  if (this->Xml)
  {
    this->Notes.clear();
    this->Header.components = this->Xml->read(extent, image, this->Notes, progress);
    this->NoteComponents();
    return;
  }
  if (this->Grid)
  {
    image->ShallowCopy(this->Frame);
    image->Crop(extent);
    return;
  }
  // Not CopyStructure, which drops the last part's memory: it is used again.
  image->SetOrigin(this->Frame->GetOrigin());
  image->SetSpacing(this->Frame->GetSpacing());
  image->SetDirectionMatrix(this->Frame->GetDirectionMatrix());
  image->SetExtent(extent[0], extent[1], extent[2], extent[3], extent[4], extent[5]);
  image->AllocateScalars(this->Header.voxels.type, 1);
  const std::size_t bytes =
    static_cast<std::size_t>(image->GetNumberOfPoints()) * this->Header.voxels.valueSize();
  io::RawVolumeReader(this->Header.voxels)
    .read(extent, { static_cast<unsigned char*>(image->GetScalarPointer()), bytes }, progress);
  this->Header.scaleValues(image);
}

void vtkInkVolumeReader::Respace(double spacing[3]) const
{
  std::transform(spacing, spacing + 3, this->Spacing, spacing,
    [](double given, double wanted) { return wanted != 0.0 ? std::abs(wanted) : given; });
}

ink::Progress vtkInkVolumeReader::MakeProgress()
{
  return [this](double done)
  {
    this->UpdateProgress(done);
    return !InkCheckAbort(this);
  };
}

vtkInkVolumeReader::vtkInkVolumeReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkInkVolumeReader::~vtkInkVolumeReader()
{
  this->SetFileName(nullptr);
}

int vtkInkVolumeReader::CanReadFile(const char* fileName)
{
  try
  {
    io::checkExists(Text(fileName));
    Source::Open(Text(fileName));
    return 1;
  }
  catch (const std::exception&)
  {
    return 0;
  }
}

bool vtkInkVolumeReader::IsDicomFile(const char* fileName)
{
  std::error_code error;
  try
  {
    return fs::is_regular_file(Text(fileName), error) && io::DicomFile::read(Text(fileName));
  }
  catch (const io::ReadError&)
  {
    return false;
  }
}

const char* vtkInkVolumeReader::GetFileExtensions()
{
  static const std::string all = io::listSuffixes(formats);
  return all.c_str();
}

const char* vtkInkVolumeReader::GetFormat()
{
  return this->Found ? this->Found->Header.format.c_str() : "";
}

int vtkInkVolumeReader::GetNumberOfFileComponents()
{
  return this->Found ? this->Found->Header.components : 0;
}

vtkTypeInt64 vtkInkVolumeReader::GetMemorySize()
{
  if (!this->Found)
  {
    return 0;
  }
  const io::RawVolume& voxels = this->Found->Header.voxels;
  if (this->Found->Grid)
  {
    vtkImageData* image = this->Found->Frame;
    return image->GetNumberOfPoints() * image->GetScalarSize();
  }
  return static_cast<vtkTypeInt64>(this->Found->Xml
      ? this->Found->Xml->memorySize()
      : voxels.sliceValues() * static_cast<std::uint64_t>(voxels.dimensions[2]) * voxels.valueSize());
}

int vtkInkVolumeReader::GetNumberOfNotes()
{
  return this->Found ? static_cast<int>(this->Found->Notes.size()) : 0;
}

const char* vtkInkVolumeReader::GetNote(int index)
{
  return index >= 0 && index < this->GetNumberOfNotes()
    ? this->Found->Notes[static_cast<std::size_t>(index)].c_str()
    : nullptr;
}

bool vtkInkVolumeReader::HasPlainVoxels()
{
  return this->Found && !this->Found->Xml && !this->Found->Grid && !this->Found->Header.isScaled() &&
    this->Found->Header.voxels.encoding == io::VoxelEncoding::Plain;
}

int vtkInkVolumeReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  const int nothing[6] = { 0, -1, 0, -1, 0, -1 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), nothing, 6);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  this->Found.reset();
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->FileName || !*this->FileName)
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("FileName is empty; expected a file, or a folder of DICOM or TIFF files.");
    return 1;
  }
  const fs::path file = this->FileName;
  try
  {
    io::checkExists(file);
    std::unique_ptr<Source> source = this->Raw
      ? std::make_unique<Source>(
          io::rawHeader(file, this->RawDimensions, this->RawScalarType, this->RawBigEndian), file)
      : Source::Open(file);
    source->Announce(info, this->MakeProgress());
    double spacing[3];
    info->Get(vtkDataObject::SPACING(), spacing);
    this->Respace(spacing);
    info->Set(vtkDataObject::SPACING(), spacing, 3);
    this->Found = std::move(source);
  }
  catch (...)
  {
    this->SetErrorCode(InkReportReadError(this, nullptr, file));
  }
  return 1;
}

int vtkInkVolumeReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  int extent[6];
  info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  if (!this->Found || extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5])
  {
    return 1;
  }
  try
  {
    this->Found->Read(extent, image, this->MakeProgress());
    double spacing[3];
    image->GetSpacing(spacing);
    this->Respace(spacing);
    image->SetSpacing(spacing);
    vtkDataArray* values = image->GetPointData()->GetScalars();
    if (this->FindRange && values)
    {
      InkKeepRange(values);
    }
  }
  catch (...)
  {
    this->SetErrorCode(InkReportReadError(this, image, this->FileName));
  }
  return 1;
}

void vtkInkVolumeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << Text(this->FileName) << "\n"
     << indent << "Spacing: " << ink::formatTriple(this->Spacing) << "\n"
     << indent << "Raw: " << this->Raw << "\n"
     << indent << "RawDimensions: " << ink::formatDimensions(this->RawDimensions) << "\n"
     << indent << "RawScalarType: " << vtkImageScalarTypeNameMacro(this->RawScalarType) << "\n"
     << indent << "RawBigEndian: " << this->RawBigEndian << "\n"
     << indent << "FindRange: " << this->FindRange << "\n"
     << indent << "Format: " << this->GetFormat() << "\n";
}
