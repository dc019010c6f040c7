// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkProcesses.h"

#include "vtkInkGatherMesh.h"

#include "Stippling/StippledVoxels.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkPolyData.h"

#include <array>
#include <cstdint>

namespace
{

vtkMultiProcessController* All()
{
  return vtkMultiProcessController::GetGlobalController();
}

} // namespace

void vtkInkProcesses::TakeGreatest(std::span<double> numbers)
{
  const std::vector<double> own(numbers.begin(), numbers.end());
  All()->AllReduce(own.data(), numbers.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::MAX_OP);
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
