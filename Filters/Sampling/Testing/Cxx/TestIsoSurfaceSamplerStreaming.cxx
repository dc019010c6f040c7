// SPDX-License-Identifier: BSD-3-Clause
// In a pipeline that asks for pieces, the sampler asks its source for no more than it needs of each, and the
// pieces are the whole, from whatever VTK reads images with.

#include "InkTestChecks.h"
#include "SamplerTestImages.h"

#include "vtkDataArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkMetaImageReader.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace
{

const std::array<int, 6> Whole{ 3, 42, -5, 30, 0, 59 };
const double IsoValue = 100.0;

double Density(double x, double y, double z)
{
  return BallDensity(x - 22, y - 12, z - 30, 14.0);
}

/// Makes what it is asked for, and remembers how much that was.
class CountingSource : public vtkImageAlgorithm
{
public:
  static CountingSource* New();
  vtkTypeMacro(CountingSource, vtkImageAlgorithm);

  vtkIdType Largest = 0;
  vtkIdType All = 0;
  int Runs = 0;

protected:
  CountingSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    vtkInformation* info = output->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), Whole.data(), 6);
    info->Set(CAN_PRODUCE_SUB_EXTENT(), 1);
    vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
    return 1;
  }

  void ExecuteDataWithInformation(vtkDataObject* output, vtkInformation* info) override
  {
    std::array<int, 6> extent;
    info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data());
    const auto image = MakeImage(VTK_FLOAT, extent, Density);
    output->ShallowCopy(image);
    this->Largest = std::max(this->Largest, image->GetNumberOfPoints());
    this->All += image->GetNumberOfPoints();
    ++this->Runs;
  }
};
vtkStandardNewMacro(CountingSource);

std::vector<Sample> Sorted(vtkPolyData* data)
{
  auto samples = SamplesOf(data);
  std::sort(samples.begin(), samples.end());
  return samples;
}

vtkSmartPointer<vtkInkIsoSurfaceSampler> MakeSampler(vtkAlgorithm* source)
{
  auto sampler = vtkSmartPointer<vtkInkIsoSurfaceSampler>::New();
  sampler->SetInputConnection(source->GetOutputPort());
  sampler->SetValue(0, IsoValue);
  return sampler;
}

/// Pieces of what a source gives are the whole, no point twice.
void CheckPieces(
  InkTestChecks& check, const char* name, vtkAlgorithm* source, const std::vector<Sample>& whole)
{
  const auto sampler = MakeSampler(source);
  for (const int pieces : { 1, 2, 5 })
  {
    std::vector<Sample> all;
    for (int piece = 0; piece < pieces; ++piece)
    {
      sampler->UpdatePiece(piece, pieces, 0);
      const auto samples = SamplesOf(sampler->GetOutput());
      all.insert(all.end(), samples.begin(), samples.end());
    }
    std::sort(all.begin(), all.end());
    check(
      all == whole, name, ": ", pieces, " pieces with ", whole.size(), " points in all, found ", all.size());
  }
}

} // namespace

int TestIsoSurfaceSamplerStreaming(int, char*[])
{
  InkTestChecks check;
  vtkNew<CountingSource> all;
  const auto ofAll = MakeSampler(all);
  ofAll->Update();
  const auto whole = Sorted(ofAll->GetOutput());
  const vtkIdType samples = 40 * 36 * 60;
  check(whole.size() > 1000, "many points, found ", whole.size());
  check(all->Runs == 1 && all->All == samples, "one run over ", samples, " samples, found ", all->Runs,
    " over ", all->All);

  // A consumer that asks for pieces, one after the other.
  const int pieces = 12;
  vtkNew<CountingSource> source;
  CheckPieces(check, "a source", source, whole);
  source->Largest = source->All = source->Runs = 0;
  const auto sampler = MakeSampler(source);
  for (int piece = 0; piece < pieces; ++piece)
  {
    sampler->UpdatePiece(piece, pieces, 0);
  }
  check(source->Runs == pieces, pieces, " runs of the source, found ", source->Runs);
  check(source->Largest < 2 * samples / pieces, "pieces of at most ", 2 * samples / pieces,
    " samples asked for, found ", source->Largest);
  check(
    source->All < 2 * samples, "less than ", 2 * samples, " samples asked for in all, found ", source->All);

  const std::filesystem::path folder =
    std::filesystem::temp_directory_path() / ("ink-streaming-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const auto path = [&folder](const char* name) { return (folder / name).string(); };

  // A writer that streams pieces.
  vtkNew<CountingSource> written;
  const auto ofWritten = MakeSampler(written);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(ofWritten->GetOutputPort());
  writer->SetFileName(path("points.vtp").c_str());
  writer->SetNumberOfPieces(pieces);
  writer->Write();
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path("points.vtp").c_str());
  reader->Update();
  check(Sorted(reader->GetOutput()) == whole, "the whole through vtkXMLPolyDataWriter, found ",
    reader->GetOutput()->GetNumberOfPoints(), " points");
  check(
    written->Largest < samples / pieces * 2, "the writer asked for pieces, of at most ", written->Largest);

  // VTK's own readers: some read parts, some only the whole.
  auto image = MakeImage(VTK_FLOAT, Whole, Density);
  {
    vtkNew<vtkXMLImageDataWriter> xml;
    xml->SetInputData(image);
    xml->SetFileName(path("v.vti").c_str());
    xml->Write();
  }
  vtkNew<vtkXMLImageDataReader> xml;
  xml->SetFileName(path("v.vti").c_str());
  CheckPieces(check, "vtkXMLImageDataReader", xml, whole);

  const std::array<int, 6> fromZero{ 0, 39, 0, 35, 0, 59 };
  image =
    MakeImage(VTK_FLOAT, fromZero, [](double x, double y, double z) { return Density(x + 3, y - 5, z); });
  vtkNew<vtkInkIsoSurfaceSampler> ofImage;
  ofImage->SetInputData(image);
  ofImage->SetValue(0, IsoValue);
  ofImage->Update();
  const auto wholeFromZero = Sorted(ofImage->GetOutput());
  const auto* bytes = static_cast<const char*>(image->GetScalarPointer());
  const auto size = static_cast<std::streamsize>(image->GetNumberOfPoints() * sizeof(float));
  std::ofstream(path("v.raw"), std::ios::binary).write(bytes, size);
  {
    std::ofstream header(path("v.mhd"));
    header << "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 40 36 60\n"
              "ElementType = MET_FLOAT\nElementDataFile = v.raw\n";
    std::ofstream nrrd(path("v.nhdr"));
    nrrd << "NRRD0004\ntype: float\ndimension: 3\nsizes: 40 36 60\nendian: little\nencoding: raw\n"
            "data file: v.raw\n\n";
  }
  vtkNew<vtkImageReader2> raw;
  raw->SetFileName(path("v.raw").c_str());
  raw->SetFileDimensionality(3);
  raw->SetDataExtent(const_cast<int*>(fromZero.data()));
  raw->SetDataScalarTypeToFloat();
  raw->FileLowerLeftOn();
  CheckPieces(check, "vtkImageReader2", raw, wholeFromZero);
  vtkNew<vtkMetaImageReader> meta;
  meta->SetFileName(path("v.mhd").c_str());
  CheckPieces(check, "vtkMetaImageReader", meta, wholeFromZero);
  vtkNew<vtkNrrdReader> nrrd;
  nrrd->SetFileName(path("v.nhdr").c_str());
  CheckPieces(check, "vtkNrrdReader", nrrd, wholeFromZero);

  std::filesystem::remove_all(folder);
  return check.Result();
}
