// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkProcesses.h"

#include "vtkInkGatherImages.h"
#include "vtkInkGatherMesh.h"

#include "Stippling/StippledVoxels.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkPolyData.h"

#include <array>
#include <cstdint>
#include <numeric>

namespace
{

vtkMultiProcessController* All()
{
  return vtkMultiProcessController::GetGlobalController();
}

} // namespace

int vtkInkProcesses::GetNumber()
{
  return All()->GetNumberOfProcesses();
}

void vtkInkProcesses::TakeGreatest(std::span<double> numbers)
{
  const std::vector<double> own(numbers.begin(), numbers.end());
  All()->AllReduce(own.data(), numbers.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::MAX_OP);
}

void vtkInkProcesses::TakeOfFirst(std::vector<double>& numbers)
{
  auto count = static_cast<vtkIdType>(numbers.size());
  All()->Broadcast(&count, 1, 0);
  numbers.resize(static_cast<std::size_t>(count));
  if (count > 0)
  {
    All()->Broadcast(numbers.data(), count, 0);
  }
}

std::vector<std::int64_t> vtkInkProcesses::GatherAll(std::span<const std::int64_t> own, std::size_t& begin)
{
  const auto count = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> counts(static_cast<std::size_t>(this->GetNumber()));
  All()->AllGather(&count, counts.data(), 1);
  std::vector<vtkIdType> offsets(counts.size());
  std::exclusive_scan(counts.begin(), counts.end(), offsets.begin(), vtkIdType{ 0 });
  begin = static_cast<std::size_t>(offsets[static_cast<std::size_t>(All()->GetLocalProcessId())]);
  std::vector<std::int64_t> all(static_cast<std::size_t>(offsets.back() + counts.back()));
  const std::vector<std::int64_t> sent(own.begin(), own.end());
  All()->AllGatherV(sent.data(), all.data(), count, counts.data(), offsets.data());
  return all;
}

void vtkInkProcesses::AddUp(ink::stipple::VolumeStatistics& statistics)
{
  const auto bins = statistics.magnitudes.bins();
  const std::vector<std::uint64_t> own(bins.begin(), bins.end());
  std::vector<std::uint64_t> all(own.size());
  All()->AllReduce(own.data(), all.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::SUM_OP);
  statistics.magnitudes.setBins(all);
  const std::array ownLimits{ -statistics.lowest, statistics.highest };
  std::array<double, 2> limits;
  All()->AllReduce(ownLimits.data(), limits.data(), 2, vtkCommunicator::MAX_OP);
  statistics.lowest = -limits[0];
  statistics.highest = limits[1];
}

vtkSmartPointer<vtkPolyData> vtkInkProcesses::Gather(const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
{
  return vtkInkGatherMesh(parts, vtkInkCommonPoints::All, All());
}

InkWholeImages vtkInkProcesses::GatherImages(std::span<vtkImageData* const> images)
{
  const InkWholeImages own = this->InkStyleProcesses::GatherImages(images);
  return this->GetNumber() > 1 ? vtkInkGatherImages(own, All()) : own;
}

void vtkInkProcesses::AgreeOnArray(std::string& name, int& association)
{
  const int none = All()->GetNumberOfProcesses();
  const int own = name.empty() ? none : All()->GetLocalProcessId();
  int first = none;
  All()->AllReduce(&own, &first, 1, vtkCommunicator::MIN_OP);
  if (first < none)
  {
    vtkMultiProcessStream stream;
    stream << name << association;
    All()->Broadcast(stream, first);
    stream >> name >> association;
  }
}
