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

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

namespace ink::stipple
{
struct VolumeStatistics;
} // namespace ink::stipple

using InkWholeImages = std::vector<vtkSmartPointer<vtkImageData>>;

class VTKINKSTYLES_EXPORT InkStyleProcesses
{
public:
  InkStyleProcesses() = default;
  virtual ~InkStyleProcesses();
  InkStyleProcesses(const InkStyleProcesses&) = delete;
  InkStyleProcesses& operator=(const InkStyleProcesses&) = delete;

  virtual int GetNumber() { return 1; }

  /// The greatest of all processes' numbers, in place of each.
  virtual void TakeGreatest(std::span<double> numbers);

  /// The first process's numbers, however many, in place of each process's.
  virtual void TakeOfFirst(std::vector<double>& numbers);

  /// All processes' numbers, one process after the other.
  /// @param begin output: where this one's begin
  virtual std::vector<std::int64_t> GatherAll(std::span<const std::int64_t> own, std::size_t& begin);

  /// All processes' statistics added up, in place of this one's.
  virtual void AddUp(ink::stipple::VolumeStatistics& statistics);

  /// All processes' parts of a mesh as one, on the first process; an empty one on the others.
  virtual vtkSmartPointer<vtkPolyData> Gather(const std::vector<vtkSmartPointer<vtkPolyData>>& parts);

  /**
   * All processes' images, with their active scalars, on the first process, which needs memory for them; none
   * on the others. Parts of one image, of which every process has one at most, are put together. Images
   * without scalars are left out.
   */
  virtual InkWholeImages GatherImages(std::span<vtkImageData* const> images);

  /// An array's name and association as the first process has them that has a name.
  virtual void AgreeOnArray(std::string& name, int& association);
};

/// Parts put together, with the field data of the first that is not empty; of samples (InkSampleCell.h) with
/// the cell that all of them have.
VTKINKSTYLES_EXPORT vtkSmartPointer<vtkPolyData> InkAppend(
  const std::vector<vtkSmartPointer<vtkPolyData>>& parts);

#endif
