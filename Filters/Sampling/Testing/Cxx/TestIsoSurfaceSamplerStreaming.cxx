// SPDX-License-Identifier: BSD-3-Clause
// In a pipeline that asks for pieces, the sampler asks its source for no more than it needs of each, and the
// pieces are the whole, from whatever VTK reads images with.

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

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace
{

const std::array<int, 6> Whole{ 3, 42, -5, 30, 0, 59 };
const double IsoValue = 100.0;
const vtkIdType NumberOfValues = 40 * 36 * 60;
const int Pieces = 12;

double Density(double x, double y, double z)
{
  return BallDensity(x - 22, y - 12, z - 30, 14.0);
}

/// Makes what it is asked for, and remembers how much that was.
class CountingSource : public PartsSource
{
public:
  static CountingSource* New();
  vtkTypeMacro(CountingSource, PartsSource);

  vtkIdType Largest = 0;
  vtkIdType All = 0;
  int Runs = 0;

protected:
  CountingSource()
    : PartsSource(Whole)
  {
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

vtkSmartPointer<vtkInkIsoSurfaceSampler> MakeSampler(vtkAlgorithm* source)
{
  auto sampler = vtkSmartPointer<vtkInkIsoSurfaceSampler>::New();
  sampler->SetInputConnection(source->GetOutputPort());
  sampler->SetValue(0, IsoValue);
  return sampler;
}

/// Pieces of what a source gives are the whole, no point twice.
void CheckPieces(const char* name, vtkAlgorithm* source, const std::vector<Sample>& whole)
{
  const auto sampler = MakeSampler(source);
  for (const int pieces : { 1, 2, 5 })
  {
    const std::vector<Sample> all = SamplesOfPieces(sampler, pieces);
    EXPECT_EQ(all, whole) << name << ": " << pieces << " pieces with " << whole.size()
                          << " points in all, found " << all.size();
  }
}

/// All samples of the source, sorted.
std::vector<Sample> SampleWhole()
{
  vtkNew<CountingSource> source;
  const auto sampler = MakeSampler(source);
  sampler->Update();
  return SortedSamplesOf(sampler->GetOutput());
}

/// A folder for files, which goes with the test.
class IsoSurfaceSamplerStreaming : public testing::Test
{
protected:
  IsoSurfaceSamplerStreaming() { std::filesystem::create_directories(this->Folder); }
  ~IsoSurfaceSamplerStreaming() override { std::filesystem::remove_all(this->Folder); }

  std::string Path(const char* name) const { return (this->Folder / name).string(); }

private:
  const std::filesystem::path Folder =
    std::filesystem::temp_directory_path() / ("ink-streaming-" + std::to_string(getpid()));
};

} // namespace

TEST_F(IsoSurfaceSamplerStreaming, TakesTheWholeInOneRun)
{
  vtkNew<CountingSource> all;
  const auto ofAll = MakeSampler(all);
  ofAll->Update();
  const auto whole = SortedSamplesOf(ofAll->GetOutput());
  EXPECT_GT(whole.size(), 1000u) << "many points";
  EXPECT_TRUE(all->Runs == 1 && all->All == NumberOfValues)
    << "one run over " << NumberOfValues << " samples, found " << all->Runs << " over " << all->All;
}

TEST_F(IsoSurfaceSamplerStreaming, AsksForNoMoreThanEachPieceNeeds)
{
  const auto whole = SampleWhole();
  vtkNew<CountingSource> source;
  CheckPieces("a source", source, whole);
  source->Largest = source->All = source->Runs = 0;
  const auto sampler = MakeSampler(source);
  for (int piece = 0; piece < Pieces; ++piece)
  {
    sampler->UpdatePiece(piece, Pieces, 0);
  }
  EXPECT_EQ(source->Runs, Pieces) << Pieces << " runs of the source";
  EXPECT_LT(source->Largest, 2 * NumberOfValues / Pieces)
    << "pieces of at most " << 2 * NumberOfValues / Pieces << " samples asked for";
  EXPECT_LT(source->All, 2 * NumberOfValues)
    << "less than " << 2 * NumberOfValues << " samples asked for in all";
}

TEST_F(IsoSurfaceSamplerStreaming, WritersStreamPieces)
{
  const auto whole = SampleWhole();
  vtkNew<CountingSource> written;
  const auto ofWritten = MakeSampler(written);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(ofWritten->GetOutputPort());
  writer->SetFileName(Path("points.vtp").c_str());
  writer->SetNumberOfPieces(Pieces);
  writer->Write();
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(Path("points.vtp").c_str());
  reader->Update();
  EXPECT_EQ(SortedSamplesOf(reader->GetOutput()), whole)
    << "the whole through vtkXMLPolyDataWriter, found " << reader->GetOutput()->GetNumberOfPoints()
    << " points";
  EXPECT_LT(written->Largest, NumberOfValues / Pieces * 2)
    << "the writer asked for pieces, of at most " << written->Largest;
}

TEST_F(IsoSurfaceSamplerStreaming, PiecesOfXMLFilesAreTheWhole)
{
  const auto whole = SampleWhole();
  const auto image = MakeImage(VTK_FLOAT, Whole, Density);
  {
    vtkNew<vtkXMLImageDataWriter> xml;
    xml->SetInputData(image);
    xml->SetFileName(Path("v.vti").c_str());
    xml->Write();
  }
  vtkNew<vtkXMLImageDataReader> xml;
  xml->SetFileName(Path("v.vti").c_str());
  CheckPieces("vtkXMLImageDataReader", xml, whole);
}

TEST_F(IsoSurfaceSamplerStreaming, PiecesOfRawFilesAreTheWhole)
{
  const std::array<int, 6> fromZero{ 0, 39, 0, 35, 0, 59 };
  const auto image =
    MakeImage(VTK_FLOAT, fromZero, [](double x, double y, double z) { return Density(x + 3, y - 5, z); });
  vtkNew<vtkInkIsoSurfaceSampler> ofImage;
  ofImage->SetInputData(image);
  ofImage->SetValue(0, IsoValue);
  ofImage->Update();
  const auto wholeFromZero = SortedSamplesOf(ofImage->GetOutput());
  const auto* bytes = static_cast<const char*>(image->GetScalarPointer());
  const auto size = static_cast<std::streamsize>(image->GetNumberOfPoints() * sizeof(float));
  std::ofstream(Path("v.raw"), std::ios::binary).write(bytes, size);
  {
    std::ofstream header(Path("v.mhd"));
    header << "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 40 36 60\n"
              "ElementType = MET_FLOAT\nElementDataFile = v.raw\n";
    std::ofstream nrrd(Path("v.nhdr"));
    nrrd << "NRRD0004\ntype: float\ndimension: 3\nsizes: 40 36 60\nendian: little\nencoding: raw\n"
            "data file: v.raw\n\n";
  }
  vtkNew<vtkImageReader2> raw;
  raw->SetFileName(Path("v.raw").c_str());
  raw->SetFileDimensionality(3);
  raw->SetDataExtent(const_cast<int*>(fromZero.data()));
  raw->SetDataScalarTypeToFloat();
  raw->FileLowerLeftOn();
  CheckPieces("vtkImageReader2", raw, wholeFromZero);
  vtkNew<vtkMetaImageReader> meta;
  meta->SetFileName(Path("v.mhd").c_str());
  CheckPieces("vtkMetaImageReader", meta, wholeFromZero);
  vtkNew<vtkNrrdReader> nrrd;
  nrrd->SetFileName(Path("v.nhdr").c_str());
  CheckPieces("vtkNrrdReader", nrrd, wholeFromZero);
}
