// SPDX-License-Identifier: BSD-3-Clause
/// ParaView's processes, which each hold a part of the data that a style makes marks of.
#ifndef vtkInkProcesses_h
#define vtkInkProcesses_h

#include "InkStyleProcesses.h"

class vtkInkProcesses : public InkStyleProcesses
{
public:
  int GetNumber() override;
  void TakeGreatest(std::span<double> numbers) override;
  void TakeOfFirst(std::vector<double>& numbers) override;
  std::vector<std::int64_t> GatherAll(std::span<const std::int64_t> own, std::size_t& begin) override;
  void AddUp(ink::stipple::VolumeStatistics& statistics) override;
  /// See vtkInkGatherMesh.
  vtkSmartPointer<vtkPolyData> Gather(const std::vector<vtkSmartPointer<vtkPolyData>>& parts) override;
  InkWholeImages GatherImages(std::span<vtkImageData* const> images) override;
  void AgreeOnArray(std::string& name, int& association) override;
};

#endif
