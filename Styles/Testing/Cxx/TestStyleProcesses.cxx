// SPDX-License-Identifier: BSD-3-Clause
// What several processes make of parts of an image is what one makes of the whole: also what is automatic.
#include "InkIsoSurface.h"
#include "InkProbeColors.h"
#include "InkStyleProcesses.h"
#include "vtkInkSplattingLinesStyle.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <barrier>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace
{

constexpr std::array<int, 3> Size = { 40, 36, 48 };
/// As many as smoothing and division into smaller cells need.
constexpr int Ghosts = 14;

/// Two materials in balls around the given middle slices, with noise.
vtkSmartPointer<vtkImageData> MakeWhole()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Size.data());
  vtkNew<vtkFloatArray> values;
  values->SetName("density");
  unsigned int random = 1;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    const double large = std::hypot(p[0] - 14, p[1] - 17, p[2] - 14) - 10;
    const double small = std::hypot(p[0] - 31, p[1] - 17, p[2] - 24) - 5;
    const double core = std::hypot(p[0] - 14, p[1] - 17, p[2] - 14) - 5;
    random = 1664525U * random + 1013904223U;
    const double noise = static_cast<double>(random >> 8) / 0x1p24 - 0.5;
    const auto step = [](double distance) { return 1.0 / (1.0 + std::exp(2.0 * distance)); };
    values->InsertNextValue(
      static_cast<float>(100 * step(std::min(large, small)) + 150 * step(core) + 12 * noise));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// Two labels in balls, that were made on a grid of a third of the size, and values beside them.
vtkSmartPointer<vtkImageData> MakeEnlarged()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(60, 57, 78);
  vtkNew<vtkFloatArray> labels;
  labels->SetName("label");
  vtkNew<vtkFloatArray> depths;
  depths->SetName("depth");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> p;
    image->GetPoint(i, p.data());
    const double depth = p[2];
    std::transform(p.begin(), p.end(), p.begin(), [](double x) { return 3 * std::floor(x / 3) + 1; });
    const bool isInOne = std::hypot(p[0] - 28, p[1] - 27, p[2] - 28) < 24;
    const bool isInTwo = std::hypot(p[0] - 34, p[1] - 31, p[2] - 55) < 19;
    labels->InsertNextValue(isInOne ? 1 : isInTwo ? 2 : 0);
    depths->InsertNextValue(static_cast<float>(depth));
  }
  image->GetPointData()->SetScalars(labels);
  image->GetPointData()->AddArray(depths);
  return image;
}

/// Layers of cells along z, with ghost cells around them.
vtkSmartPointer<vtkImageData> MakePart(vtkImageData* whole, int begin, int end)
{
  const int* size = whole->GetDimensions();
  const int first = std::max(begin - Ghosts, 0);
  const int last = std::min(end + Ghosts, size[2] - 1);
  auto part = vtkSmartPointer<vtkImageData>::New();
  part->SetExtent(0, size[0] - 1, 0, size[1] - 1, first, last);
  const vtkIdType slice = static_cast<vtkIdType>(size[0]) * size[1];
  vtkPointData* arrays = whole->GetPointData();
  for (int n = 0; n < arrays->GetNumberOfArrays(); ++n)
  {
    vtkNew<vtkFloatArray> values;
    values->SetName(arrays->GetArrayName(n));
    values->InsertTuples(0, (last + 1 - first) * slice, first * slice, arrays->GetArray(n));
    part->GetPointData()->AddArray(values);
  }
  part->GetPointData()->SetActiveScalars(arrays->GetScalars()->GetName());
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  const int layer = (size[0] - 1) * (size[1] - 1);
  for (vtkIdType cell = 0; cell < part->GetNumberOfCells(); ++cell)
  {
    const auto z = first + static_cast<int>(cell / layer);
    ghosts->InsertNextValue(z >= begin && z < end ? 0 : vtkDataSetAttributes::DUPLICATECELL);
  }
  part->GetCellData()->AddArray(ghosts);
  return part;
}

/// Threads that wait for each other, in place of processes.
struct Team
{
  explicit Team(int count)
    : Barrier(count)
    , Numbers(static_cast<std::size_t>(count))
    , Ids(static_cast<std::size_t>(count))
    , Images(static_cast<std::size_t>(count))
    , Names(static_cast<std::size_t>(count))
  {
  }
  std::barrier<> Barrier;
  std::vector<std::vector<double>> Numbers;
  std::vector<std::vector<std::int64_t>> Ids;
  std::vector<std::vector<vtkImageData*>> Images;
  std::vector<std::string> Names;
};

class Member : public InkStyleProcesses
{
public:
  Member(Team& team, int rank)
    : All(team)
    , Rank(static_cast<std::size_t>(rank))
  {
  }
  int GetNumber() override { return static_cast<int>(this->All.Numbers.size()); }
  void TakeGreatest(std::span<double> numbers) override
  {
    this->All.Numbers[this->Rank].assign(numbers.begin(), numbers.end());
    this->All.Barrier.arrive_and_wait();
    for (const auto& one : this->All.Numbers)
    {
      for (std::size_t i = 0; i < numbers.size(); ++i)
      {
        numbers[i] = std::max(numbers[i], one[i]);
      }
    }
    this->All.Barrier.arrive_and_wait();
  }
  void TakeOfFirst(std::vector<double>& numbers) override
  {
    this->All.Numbers[this->Rank] = numbers;
    this->All.Barrier.arrive_and_wait();
    numbers = this->All.Numbers[0];
    this->All.Barrier.arrive_and_wait();
  }
  std::vector<std::int64_t> GatherAll(std::span<const std::int64_t> own, std::size_t& begin) override
  {
    this->All.Ids[this->Rank].assign(own.begin(), own.end());
    this->All.Barrier.arrive_and_wait();
    std::vector<std::int64_t> all;
    for (std::size_t rank = 0; rank < this->All.Ids.size(); ++rank)
    {
      begin = rank == this->Rank ? all.size() : begin;
      all.insert(all.end(), this->All.Ids[rank].begin(), this->All.Ids[rank].end());
    }
    this->All.Barrier.arrive_and_wait();
    return all;
  }
  InkWholeImages GatherImages(std::span<vtkImageData* const> images) override
  {
    this->All.Images[this->Rank].assign(images.begin(), images.end());
    this->All.Barrier.arrive_and_wait();
    InkWholeImages result;
    if (this->Rank == 0)
    {
      // The first process has the first part.
      auto whole = vtkSmartPointer<vtkImageData>::New();
      whole->CopyStructure(images[0]);
      std::array<int, 6> extent;
      whole->GetExtent(extent.data());
      for (const auto& parts : this->All.Images)
      {
        for (vtkImageData* part : parts)
        {
          extent[5] = std::max(extent[5], part->GetExtent()[5]);
        }
      }
      whole->SetExtent(extent.data());
      whole->AllocateScalars(VTK_FLOAT, 1);
      vtkDataArray* values = whole->GetPointData()->GetScalars();
      for (const auto& parts : this->All.Images)
      {
        for (vtkImageData* part : parts)
        {
          if (vtkDataArray* own = part->GetPointData()->GetScalars())
          {
            values->SetName(own->GetName());
            const int* ends = part->GetExtent();
            int begin[3] = { ends[0], ends[2], ends[4] };
            values->InsertTuples(whole->ComputePointId(begin), part->GetNumberOfPoints(), 0, own);
          }
        }
      }
      result.push_back(whole);
    }
    this->All.Barrier.arrive_and_wait();
    return result;
  }
  void AgreeOnArray(std::string& name, int&) override
  {
    this->All.Names[this->Rank] = name;
    this->All.Barrier.arrive_and_wait();
    const auto& names = this->All.Names;
    const auto named = std::find_if(names.begin(), names.end(), [](const auto& one) { return !one.empty(); });
    name = named == names.end() ? "" : *named;
    this->All.Barrier.arrive_and_wait();
  }

private:
  Team& All;
  const std::size_t Rank;
};

using Point = std::array<double, 3>;

void AddPoints(vtkPolyData* data, std::vector<Point>& points)
{
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    Point point;
    data->GetPoint(i, point.data());
    points.push_back(point);
  }
}

struct Result
{
  std::vector<Point> Points;  ///< of all, in order
  std::vector<double> Values; ///< of the array that points are colored by, in order
  std::vector<std::string> Notes;
  std::vector<std::string> Problems;
};

/// What lines of the image are made of by so many processes, the last of which has no part where there are
/// three or more.
template <class SetUp>
Result MakeWith(int processes, const SetUp& setUp, vtkSmartPointer<vtkImageData> (*make)() = MakeWhole)
{
  const auto whole = make();
  Team team(processes);
  const int* size = whole->GetDimensions();
  std::vector<vtkSmartPointer<vtkInkSplattingLinesStyle>> styles;
  std::vector<vtkSmartPointer<vtkTrivialProducer>> producers;
  const int parts = processes > 2 ? processes - 1 : processes;
  for (int rank = 0; rank < processes; ++rank)
  {
    styles.push_back(vtkSmartPointer<vtkInkSplattingLinesStyle>::New());
    setUp(styles.back().Get());
    styles.back()->SetProcesses(std::make_shared<Member>(team, rank));
    producers.push_back(vtkSmartPointer<vtkTrivialProducer>::New());
    if (rank < parts)
    {
      producers.back()->SetOutput(
        MakePart(whole, rank * (size[2] - 1) / parts, (rank + 1) * (size[2] - 1) / parts));
      producers.back()->SetWholeExtent(0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1);
    }
  }
  Result result;
  result.Problems.resize(static_cast<std::size_t>(processes));
  std::vector<std::thread> threads;
  for (int rank = 0; rank < processes; ++rank)
  {
    threads.emplace_back(
      [&, n = static_cast<std::size_t>(rank)]
      {
        vtkTrivialProducer* producer = producers[n];
        vtkDataObject* data = producer->GetOutputDataObject(0);
        result.Problems[n] = styles[n]->MakeMarks({ data, producer->GetOutputPort(), nullptr });
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const auto& style : styles)
  {
    AddPoints(style->GetPiece(0), result.Points);
    vtkDataArray* depths = style->GetPiece(0)->GetPointData()->GetArray(InkColorsName);
    for (vtkIdType i = 0; depths && i < depths->GetNumberOfTuples(); ++i)
    {
      result.Values.push_back(depths->GetTuple1(i));
    }
  }
  std::sort(result.Values.begin(), result.Values.end());
  for (int note = 0; note < styles[0]->GetNumberOfNotes(); ++note)
  {
    result.Notes.emplace_back(styles[0]->GetNote(note));
  }
  std::sort(result.Points.begin(), result.Points.end());
  return result;
}

template <class SetUp>
void ExpectSame(const SetUp& setUp, vtkSmartPointer<vtkImageData> (*make)() = MakeWhole)
{
  const Result one = MakeWith(1, setUp, make);
  EXPECT_GT(one.Points.size(), 1000u);
  for (const int processes : { 2, 4 })
  {
    const Result several = MakeWith(processes, setUp, make);
    EXPECT_EQ(several.Points, one.Points) << processes;
    EXPECT_EQ(several.Notes, one.Notes) << processes;
    for (const std::string& problem : several.Problems)
    {
      EXPECT_EQ(problem, "");
    }
  }
}

TEST(StyleProcesses, AutomaticIsoValueAndSmoothingAreThoseOfTheWhole)
{
  ExpectSame([](vtkInkStyle*) {});
  // There is something to choose, and to smooth.
  EXPECT_EQ(MakeWith(1, [](vtkInkStyle*) {}).Notes.size(), 1u);
  EXPECT_NE(MakeWith(1, [](vtkInkStyle* style) { style->SetParameter("Smoothing", 0); }).Points,
    MakeWith(1, [](vtkInkStyle*) {}).Points);
}

TEST(StyleProcesses, PartsAreJudgedAsAWhole)
{
  // The small ball, which the border between two processes divides, is kept or left out by its whole size.
  const auto count = [](int processes, double share)
  {
    return MakeWith(processes,
      [&](vtkInkStyle* style)
      {
        style->SetParameterAsString("IsoValues", "50");
        style->SetParameter("SmallestPart", share);
      })
      .Points.size();
  };
  const std::size_t both = count(1, 0.15);
  const std::size_t large = count(1, 0.5);
  EXPECT_GT(both, large + large / 8);
  for (const int processes : { 2, 4 })
  {
    EXPECT_EQ(count(processes, 0.15), both);
    EXPECT_EQ(count(processes, 0.5), large);
  }
  ExpectSame(
    [](vtkInkStyle* style)
    {
      // Of each of two surfaces.
      style->SetParameterAsString("IsoValues", "50,175");
      style->SetParameter("LargestParts", 1);
    });
}

TEST(StyleProcesses, EnlargedVolumesAreWhatTheWholeWasMadeOf)
{
  const auto byDepth = [](vtkInkSplattingLinesStyle* style)
  {
    style->SetParameterAsString("IsoValues", ".5");
    style->SetColorArray({ "depth", false });
  };
  ExpectSame(byDepth, MakeEnlarged);
  const Result one = MakeWith(1, byDepth, MakeEnlarged);
  ASSERT_EQ(one.Notes.size(), 1u);
  EXPECT_NE(one.Notes[0].find("enlarged by repeating voxels"), std::string::npos) << one.Notes[0];
  EXPECT_NE(one.Notes[0].find("20 x 19 x 26"), std::string::npos) << one.Notes[0];
  EXPECT_GT(one.Values.size(), 1000u);
  EXPECT_EQ(MakeWith(3, byDepth, MakeEnlarged).Values, one.Values);
  // Asked for as it is, in blocks.
  ExpectSame(
    [](vtkInkStyle* style)
    {
      style->SetParameterAsString("IsoValues", ".5");
      style->SetParameterAsString("LabelMap", "off");
    },
    MakeEnlarged);
}

TEST(StyleProcesses, TheirPointsCarryNothingMore)
{
  Team team(2);
  std::vector<std::thread> threads;
  const auto whole = MakeWhole();
  vtkNew<vtkInkSplattingLinesStyle> styles[2];
  for (int rank = 0; rank < 2; ++rank)
  {
    styles[rank]->SetProcesses(std::make_shared<Member>(team, rank));
    threads.emplace_back(
      [&, rank]
      {
        vtkNew<vtkTrivialProducer> producer;
        producer->SetOutput(MakePart(whole, rank * 20, rank == 0 ? 20 : Size[2] - 1));
        producer->SetWholeExtent(0, Size[0] - 1, 0, Size[1] - 1, 0, Size[2] - 1);
        styles[rank]->MakeMarks({ producer->GetOutputDataObject(0), producer->GetOutputPort(), nullptr });
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (const auto& one : styles)
  {
    vtkPointData* data = one->GetPiece(0)->GetPointData();
    EXPECT_EQ(data->GetNumberOfArrays(), 2);
    EXPECT_NE(data->GetNormals(), nullptr);
    EXPECT_NE(data->GetArray("Radius"), nullptr);
    EXPECT_NE(one->GetPiece(0)->GetFieldData()->GetArray("SampleCell"), nullptr);
    EXPECT_EQ(one->GetFramePoints(), one->GetPiece(0)->GetPoints());
  }
}

/// Whatever empty parts there are, and in whatever order.
TEST(StyleProcesses, AppendedSamplesHaveTheCellThatAllHave)
{
  const auto makePart = [](int points, double depth)
  {
    auto part = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> positions;
    positions->SetNumberOfPoints(points);
    part->SetPoints(positions);
    vtkNew<vtkDoubleArray> cell;
    cell->SetName("SampleCell");
    cell->SetNumberOfComponents(3);
    for (const std::array<double, 3>& edge :
      { std::array{ 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, depth } })
    {
      cell->InsertNextTuple(edge.data());
    }
    if (depth > 0.0)
    {
      part->GetFieldData()->AddArray(cell);
    }
    return part;
  };
  const auto cellDepth = [](const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
  {
    vtkDataArray* cell = InkAppend(parts)->GetFieldData()->GetArray("SampleCell");
    return cell ? cell->GetComponent(2, 2) : 0.0;
  };
  const auto empty = makePart(0, 0.0);
  const auto flat = makePart(2, 1.0);
  const auto deep = makePart(3, 3.0);
  EXPECT_EQ(cellDepth({ empty, deep, makePart(4, 3.0) }), 3.0);
  EXPECT_EQ(cellDepth({ deep, empty }), 3.0);
  EXPECT_EQ(cellDepth({ flat, deep }), 0.0);
  EXPECT_EQ(cellDepth({ deep, flat }), 0.0);
  EXPECT_EQ(cellDepth({ deep, makePart(1, 0.0) }), 0.0);
  EXPECT_EQ(cellDepth({ empty, empty }), 0.0);
}

} // namespace
