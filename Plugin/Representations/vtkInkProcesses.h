// SPDX-License-Identifier: BSD-3-Clause
/// ParaView's processes, which each hold a part of the data that a style makes marks of.
#ifndef vtkInkProcesses_h
#define vtkInkProcesses_h

#include "InkStyleProcesses.h"

class vtkInkProcesses : public InkStyleProcesses
{
public:
  void TakeGreatest(std::span<double> numbers) override;
  void AddUp(ink::stipple::VolumeStatistics& statistics) override;
  /// See vtkInkGatherMesh.
  vtkSmartPointer<vtkPolyData> Gather(const std::vector<vtkSmartPointer<vtkPolyData>>& parts) override;
  void AgreeOnArray(std::string& name, int& association) override;
};

#endif
