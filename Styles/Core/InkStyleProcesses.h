// SPDX-License-Identifier: BSD-3-Clause
/**
 * What processes that each hold a part of the data find out together while a style makes its marks. As it
 * stands, for one process that holds all; with several, a subclass talks to the others, and all processes
 * call the same functions in the same order.
 */
#ifndef InkStyleProcesses_h
#define InkStyleProcesses_h

#include "vtkInkStylesModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <span>
#include <string>
#include <vector>

class vtkPolyData;

namespace ink::stipple
{
struct VolumeStatistics;
} // namespace ink::stipple

class VTKINKSTYLES_EXPORT InkStyleProcesses
{
public:
  InkStyleProcesses() = default;
  virtual ~InkStyleProcesses();
  InkStyleProcesses(const InkStyleProcesses&) = delete;
  InkStyleProcesses& operator=(const InkStyleProcesses&) = delete;

  /// The greatest of all processes' numbers, in place of each.
  virtual void TakeGreatest(std::span<double> numbers);

  /// All processes' statistics added up, in place of this one's.
  virtual void AddUp(ink::stipple::VolumeStatistics& statistics);

  /// All processes' parts of a mesh as one, on the first process; an empty one on the others.
  virtual vtkSmartPointer<vtkPolyData> Gather(const std::vector<vtkSmartPointer<vtkPolyData>>& parts);

  /// An array's name and association as the first process has them that has a name.
  virtual void AgreeOnArray(std::string& name, int& association);
};

/// Parts put together, with the field data of the first.
VTKINKSTYLES_EXPORT vtkSmartPointer<vtkPolyData> InkAppend(
  const std::vector<vtkSmartPointer<vtkPolyData>>& parts);

#endif
