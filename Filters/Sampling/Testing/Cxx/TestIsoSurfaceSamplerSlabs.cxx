// SPDX-License-Identifier: BSD-3-Clause
// With MaximumMemory, an image is asked for a few slices at a time, and its points are those of the whole.

#include "InkImageSlabs.h"
#include "InkMemoryBudget.h"
#include "InkTestMessages.h"
#include "InkVolumeValues.h"
#include "SamplerTestImages.h"

#include "Statistics/FiniteRange.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <unistd.h>

namespace
{

const std::array<int, 6> Whole{ 3, 66, -5, 58, 10, 137 };
constexpr int Slices = 128;
/// Beside the program: 256 KiB for slices of 16 KiB and as many quarters, and for the points of a part.
constexpr int Little = 97;
constexpr int AtOnce = 12;

/// Two balls, and a speck: at 100 their surfaces.
double Density(double x, double y, double z)
{
  const double ball =
    std::max(BallDensity(x - 30, y - 20, z - 50, 22.0), BallDensity(x - 40, y - 30, z - 110, 15.0));
  return std::max(ball, BallDensity(x - 60, y - 50, z - 20, 1.2));
}

/// Makes what it is asked for, in two arrays, and remembers how much that was.
class SlabSource : public PartsSource
{
public:
  static SlabSource* New();
  vtkTypeMacro(SlabSource, PartsSource);

  int MostSlices = 0;
  int AllSlices = 0;
  int FailsFrom = Slices; ///< slices

protected:
  SlabSource()
    : PartsSource(Whole)
  {
  }

  void ExecuteDataWithInformation(vtkDataObject* output, vtkInformation* info) override
  {
    std::array<int, 6> extent;
    info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data());
    const int slices = extent[5] - extent[4] + 1;
    this->MostSlices = std::max(this->MostSlices, slices);
    this->AllSlices += slices;
    if (extent[5] - Whole[4] >= this->FailsFrom)
    {
      output->Initialize();
      return;
    }
    if (slices > 0)
    {
      const auto image = MakeImage(VTK_FLOAT, extent, Density);
      vtkSmartPointer<vtkDataArray> other = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(VTK_FLOAT));
      other->SetName("Twice");
      other->SetNumberOfTuples(image->GetNumberOfPoints());
      for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
      {
        other->SetComponent(i, 0, 2.0 * image->GetPointData()->GetScalars()->GetComponent(i, 0));
      }
      image->GetPointData()->AddArray(other);
      output->ShallowCopy(image);
    }
  }
};
vtkStandardNewMacro(SlabSource);

vtkSmartPointer<vtkInkIsoSurfaceSampler> MakeSampler(vtkAlgorithm* source, int memory)
{
  auto sampler = vtkSmartPointer<vtkInkIsoSurfaceSampler>::New();
  sampler->SetInputConnection(source->GetOutputPort());
  sampler->SetValue(0, 100.0);
  sampler->SetMaximumMemory(memory);
  return sampler;
}

/// The outputs with little memory and with any are equal to the bit, after `set`.
template <class Set>
void ExpectSame(const Set& set, bool inOrder = true)
{
  vtkNew<SlabSource> source;
  vtkNew<SlabSource> allSource;
  const auto little = MakeSampler(source, Little);
  const auto all = MakeSampler(allSource, 0);
  for (vtkInkIsoSurfaceSampler* sampler : { little.Get(), all.Get() })
  {
    set(sampler);
    sampler->Update();
  }
  EXPECT_LE(source->MostSlices, AtOnce) << "slices at a time";
  EXPECT_EQ(allSource->AllSlices, Slices);
  std::vector<Sample> found = SamplesOf(little->GetOutput());
  std::vector<Sample> expected = SamplesOf(all->GetOutput());
  if (!inOrder)
  {
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
  }
  EXPECT_GT(expected.size(), 1000u);
  EXPECT_TRUE(found == expected) << found.size() << " points, expected " << expected.size();
  vtkPointData* data = little->GetOutput()->GetPointData();
  vtkPointData* wanted = all->GetOutput()->GetPointData();
  ASSERT_EQ(data->GetNumberOfArrays(), wanted->GetNumberOfArrays());
  for (int i = 0; i < wanted->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(wanted->GetArrayName(i));
    ASSERT_NE(array, nullptr) << wanted->GetArrayName(i);
    EXPECT_EQ(array->GetDataType(), wanted->GetArray(i)->GetDataType());
    for (vtkIdType n = 0; inOrder && n < array->GetNumberOfValues(); ++n)
    {
      const int components = array->GetNumberOfComponents();
      const int component = static_cast<int>(n % components);
      ASSERT_EQ(array->GetComponent(n / components, component),
        wanted->GetArray(i)->GetComponent(n / components, component))
        << wanted->GetArrayName(i) << ' ' << n;
    }
  }
  EXPECT_EQ(little->GetOutput()->GetNumberOfVerts(), all->GetOutput()->GetNumberOfVerts());
  EXPECT_NE(little->GetOutput()->GetFieldData()->GetArray("SampleCell"), nullptr);
}

} // namespace

TEST(IsoSurfaceSamplerSlabs, PointsAreThoseOfTheWhole)
{
  ExpectSame([](vtkInkIsoSurfaceSampler*) {});
}

TEST(IsoSurfaceSamplerSlabs, SeveralSurfacesComeOneAfterTheOther)
{
  ExpectSame(
    [](vtkInkIsoSurfaceSampler* sampler)
    {
      sampler->SetValues({ 130.0, 100.0, 5000.0, 60.0 });
      sampler->ComputeCellIdsOn();
      sampler->GenerateVerticesOff();
      sampler->SetOutputNormalsPrecisionToShort();
    });
}

TEST(IsoSurfaceSamplerSlabs, PartsOfSurfacesAreThoseOfTheWhole)
{
  // The larger ball alone: with either share the speck, with one the smaller ball is left out, too.
  for (const double share : { -1.0, 0.8 })
  {
    ExpectSame(
      [share](vtkInkIsoSurfaceSampler* sampler)
      {
        sampler->SetSmallestPart(share);
        sampler->SetValues({ 100.0, 90.0 });
      });
  }
}

TEST(IsoSurfaceSamplerSlabs, NeighborsAreThereForWhatNeedsMore)
{
  ExpectSame([](vtkInkIsoSurfaceSampler* sampler) { sampler->SetProjectionSteps(3); });
  ExpectSame([](vtkInkIsoSurfaceSampler* sampler) { sampler->SetSmoothing(0.5); }, false);
  ExpectSame([](vtkInkIsoSurfaceSampler* sampler) { sampler->SetCutToRim(); });
}

TEST(IsoSurfaceSamplerSlabs, AnotherArrayIsTakenByItsName)
{
  ExpectSame(
    [](vtkInkIsoSurfaceSampler* sampler)
    {
      sampler->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Twice");
      sampler->SetValue(0, 260.0);
    });
  vtkNew<SlabSource> source;
  const auto sampler = MakeSampler(source, Little);
  sampler->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "None");
  vtkNew<InkTestMessages> messages;
  messages->Observe(sampler);
  sampler->Update();
  ASSERT_EQ(messages->Messages.size(), 1u);
  EXPECT_NE(messages->Messages[0].find("expected a point array 'None' of one component, found none"),
    std::string::npos)
    << messages->Messages[0];
}

TEST(IsoSurfaceSamplerSlabs, AnImageThatFitsIsAskedForOnce)
{
  vtkNew<SlabSource> source;
  const auto sampler = MakeSampler(source, 1024);
  sampler->Update();
  EXPECT_EQ(source->MostSlices, Slices);
  // And a piece of several is one of the image.
  vtkNew<SlabSource> other;
  const auto pieces = MakeSampler(other, Little);
  const std::vector<Sample> found = SamplesOfPieces(pieces, 3);
  std::vector<Sample> expected = SamplesOf(sampler->GetOutput());
  std::sort(expected.begin(), expected.end());
  EXPECT_TRUE(found == expected) << found.size() << " points, expected " << expected.size();
}

TEST(IsoSurfaceSamplerSlabs, ReadersOfVTKAreAskedForSlices)
{
  const std::filesystem::path folder =
    std::filesystem::temp_directory_path() / ("ink-slabs-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const auto image = MakeImage(VTK_FLOAT, { 0, 63, 0, 63, 0, 127 }, Density);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName((folder / "v.vti").c_str());
  writer->SetCompressorTypeToNone();
  writer->Write();
  std::ofstream(folder / "v.raw", std::ios::binary)
    .write(static_cast<const char*>(image->GetScalarPointer()), 64 * 64 * 128 * sizeof(float));
  vtkNew<vtkXMLImageDataReader> xml;
  xml->SetFileName((folder / "v.vti").c_str());
  vtkNew<vtkImageReader2> raw;
  raw->SetFileName((folder / "v.raw").c_str());
  raw->SetFileDimensionality(3);
  raw->SetDataExtent(0, 63, 0, 63, 0, 127);
  raw->SetDataScalarTypeToFloat();
  raw->FileLowerLeftOn();
  vtkNew<vtkInkIsoSurfaceSampler> whole;
  whole->SetInputData(image);
  whole->SetValue(0, 100.0);
  whole->Update();
  const std::vector<Sample> expected = SamplesOf(whole->GetOutput());
  for (vtkAlgorithm* reader : { static_cast<vtkAlgorithm*>(raw), static_cast<vtkAlgorithm*>(xml) })
  {
    const auto sampler = MakeSampler(reader, Little);
    sampler->Update();
    EXPECT_TRUE(SamplesOf(sampler->GetOutput()) == expected) << reader->GetClassName();
    auto* last = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
    EXPECT_LE(last->GetDimensions()[2], AtOnce) << reader->GetClassName();
  }
  std::filesystem::remove_all(folder);
}

TEST(IsoSurfaceSamplerSlabs, AChangeIsSampledAgain)
{
  vtkNew<SlabSource> source;
  const auto sampler = MakeSampler(source, Little);
  sampler->Update();
  const int once = source->AllSlices;
  sampler->Update();
  EXPECT_EQ(source->AllSlices, once) << "nothing is new";
  const vtkIdType before = sampler->GetOutput()->GetNumberOfPoints();
  sampler->SetValue(0, 50.0);
  sampler->Update();
  EXPECT_GT(sampler->GetOutput()->GetNumberOfPoints(), before);
  EXPECT_LT(source->AllSlices, 3 * Slices);
}

TEST(IsoSurfaceSamplerSlabs, PartsHaveRoomAndCoverTheImage)
{
  for (const bool inMemory : { false, true })
  {
    vtkNew<SlabSource> source;
    const auto sampler = MakeSampler(source, Little);
    if (inMemory)
    {
      sampler->SetInputData(MakeImage(VTK_FLOAT, Whole, Density));
    }
    sampler->SetValues({ 100.0, 20.0 });
    std::vector<std::vector<Sample>> parts(2);
    ASSERT_TRUE(sampler->SampleParts(
      [&](int surface, vtkPolyData* part)
      {
        EXPECT_LE(part->GetNumberOfPoints(), static_cast<vtkIdType>((1 << 18) / InkBytesPerPoint));
        const auto samples = SamplesOf(part);
        auto& all = parts[static_cast<std::size_t>(surface)];
        all.insert(all.end(), samples.begin(), samples.end());
      }));
    vtkNew<SlabSource> allSource;
    const auto all = MakeSampler(allSource, 0);
    for (int surface = 0; surface < 2; ++surface)
    {
      all->SetValue(0, surface == 0 ? 100.0 : 20.0);
      all->Update();
      EXPECT_TRUE(parts[static_cast<std::size_t>(surface)] == SamplesOf(all->GetOutput())) << surface;
    }
    double range[2];
    MakeImage(VTK_FLOAT, Whole, Density)->GetScalarRange(range);
    EXPECT_EQ(sampler->FindRange().least, range[0]);
    EXPECT_EQ(sampler->FindRange().greatest, range[1]);
  }
}

TEST(IsoSurfaceSamplerSlabs, ErrorsNameTheMemoryThatIsNeeded)
{
  const auto messageOf = [](int memory, int failsFrom, const auto& set)
  {
    vtkNew<SlabSource> source;
    source->FailsFrom = failsFrom;
    const auto sampler = MakeSampler(source, memory);
    set(sampler.Get());
    vtkNew<InkTestMessages> messages;
    messages->Observe(sampler);
    sampler->Update();
    EXPECT_EQ(sampler->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(messages->Messages.size(), 1u);
    return messages->Messages.empty() ? std::string() : messages->Messages[0];
  };
  const auto expect = [](const std::string& message, const char* words)
  { EXPECT_NE(message.find(words), std::string::npos) << message; };
  const auto nothing = [](vtkInkIsoSurfaceSampler*) {};
  expect(messageOf(96, Slices, nothing),
    "4 are needed at a time: expected MaximumMemory 97 MiB or more, found 96 MiB");
  expect(messageOf(Little, Slices, [](auto* sampler) { sampler->SetSmoothing(8.0); }),
    "expected more MaximumMemory than 97 MiB, or less Smoothing");
  expect(messageOf(Little, 30, nothing), "its input does not make slices");
  expect(
    messageOf(Little, Slices, [](auto* sampler) { sampler->SetValue(0, 1e6); }), "Expected a value above");
}

TEST(ImageSlabs, ValuesAreThoseOfTheWhole)
{
  vtkNew<SlabSource> source;
  vtkNew<SlabSource> other;
  InkImageSlabs slabs(source->GetOutputPort(), InkMemoryBudget::OfMebibytes(Little));
  InkImageSlabs whole(other->GetOutputPort(), InkMemoryBudget::OfMebibytes(0));
  EXPECT_EQ(slabs.GetAtOnce(), AtOnce);
  EXPECT_FALSE(slabs.IsWhole());
  EXPECT_TRUE(whole.IsWhole());
  EXPECT_EQ(slabs.GetBytes(), std::uint64_t{ 64 } * 64 * Slices * sizeof(float));
  double told = 0.0;
  const auto progress = [&](double done)
  {
    EXPECT_GE(done, told);
    told = done;
    return true;
  };
  const auto found = InkSuggestIsoValues(slabs, progress);
  const auto expected = InkSuggestIsoValues(whole, progress);
  ASSERT_FALSE(expected.empty());
  ASSERT_EQ(found.size(), expected.size());
  EXPECT_EQ(found[0].value, expected[0].value);
  EXPECT_GT(told, 0.5);
  EXPECT_EQ(InkFindFiniteRange(slabs).greatest, InkFindFiniteRange(whole).greatest);
  EXPECT_LE(source->MostSlices, AtOnce);
  EXPECT_THROW(slabs.Get(0, AtOnce + 1), std::invalid_argument);
}

TEST(ImageSlabs, HiddenVoxelsStayHidden)
{
  const auto image = MakeImage(VTK_FLOAT, Whole, Density);
  image->AllocatePointGhostArray();
  image->GetPointGhostArray()->SetValue(64 * 64 * 41 + 7, vtkDataSetAttributes::HIDDENPOINT);
  vtkNew<vtkInkIsoSurfaceSampler> producer;
  producer->SetInputData(image);
  InkImageSlabs slabs(producer->GetInputConnection(0, 0), InkMemoryBudget::OfMebibytes(Little));
  const auto part = slabs.Get(40, 44);
  ASSERT_NE(part->GetPointGhostArray(), nullptr);
  EXPECT_EQ(part->GetPointGhostArray()->GetValue(64 * 64 + 7), vtkDataSetAttributes::HIDDENPOINT);
  EXPECT_EQ(part->GetPointGhostArray()->GetValue(64 * 64 + 8), 0);
}

TEST(MemoryBudget, SizesAreNumbersWithUnits)
{
  const auto parsed = [](const char* size)
  {
    const auto budget = InkMemoryBudget::Parse(size);
    return budget ? budget->Limit : 0;
  };
  constexpr std::uint64_t mebibyte = 1 << 20;
  EXPECT_EQ(parsed("128MiB"), 128 * mebibyte);
  EXPECT_EQ(parsed("1.5 GiB"), 1536 * mebibyte);
  EXPECT_EQ(parsed("131072kib"), 128 * mebibyte);
  EXPECT_EQ(parsed("1g"), 1024 * mebibyte);
  EXPECT_EQ(parsed("1T"), 1048576 * mebibyte);
  for (const char* none : { "", "1", "100", "1e9", "-1GiB", "GiB", "127MiB", "1 lot", "nanGiB", "infGiB",
         "1  GiB", " 1GiB", "1GB", "1Gi" })
  {
    EXPECT_EQ(parsed(none), 0u) << none;
  }
  EXPECT_EQ(InkMemoryBudget::Parse("900000T")->GetMebibytes(), 16777216);
  EXPECT_EQ(InkFormatMemory(mebibyte + 1), "2 MiB");
}

TEST(MemoryBudget, WhatDoesNotFitIsRefused)
{
  const auto problem = [](double count, double bytes, double most)
  {
    try
    {
      InkCheckMemory(count, bytes, "dots", most, ": take fewer");
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto memory = static_cast<double>(InkGetMachineMemory());
  EXPECT_GE(memory, 0x1p24);
  EXPECT_EQ(problem(0.9 * memory / 8.0, 8.0, memory), "");
  EXPECT_NE(problem(1.1 * memory / 8.0, 8.0, memory).find("GiB of memory"), std::string::npos);
  EXPECT_EQ(problem(0x1p17, 8192.0, 1000.0),
    "131072 dots would take 1 GiB of memory; expected no more than 1000 dots on this machine: take fewer");
}

TEST(IsoSurfaceSamplerSlabs, LabelMaps)
{
  for (const double smoothing : { 0.0, 0.5 })
  {
    ExpectSame(
      [=](vtkInkIsoSurfaceSampler* sampler)
      {
        sampler->LabelMapOn();
        sampler->SetSmoothing(smoothing);
      },
      false);
  }
}

TEST(IsoSurfaceSamplerSlabs, SuggestsAndCountsAsOfTheWhole)
{
  const auto whole = MakeImage(VTK_FLOAT, Whole, Density);
  vtkNew<SlabSource> source;
  const auto sampler = MakeSampler(source, Little);
  EXPECT_EQ(sampler->SuggestSmoothing(100.0), InkSuggestSmoothing(whole, 100.0).byValues.ofValues);
  EXPECT_EQ(static_cast<double>(sampler->CountActiveCells(100.0)), InkBoundSurfacePoints(whole, 100.0));
  EXPECT_LE(source->MostSlices, AtOnce);
  sampler->Update();
  EXPECT_GE(sampler->CountActiveCells(100.0), sampler->GetOutput()->GetNumberOfPoints());
}
