#pragma once

#include "Color.h"
#include "Input.h"
#include "SampleMesh.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkLight;
class vtkMapper;
class vtkPolyData;

namespace ink::cli
{

struct RenderOptions;

/// What is drawn, before it has a camera.
struct Subject
{
  vtkSmartPointer<vtkPolyData> points;
  vtkSmartPointer<vtkMapper> mapper;
  vtkSmartPointer<vtkLight> light; ///< null: the mapper needs none
  Color background;
  std::vector<std::string> notes;
};

/// Makes subjects, one or the frames of an animation, with the one mapper of the options.
class SubjectMaker
{
public:
  /// \param options kept as a reference
  /// \param follow whether the samples of a mesh are those of the one before, moved
  explicit SubjectMaker(const RenderOptions& options, bool follow = false);

  /// \throw Failure, UsageError
  Subject make(const Input& input, Progress& progress);

  /// The iso-value that the first volume was given, where there was none, is the following ones', too.
  void keepIsoValue(const Input& input, std::vector<std::string>& notes, Progress& progress);

private:
  Subject makeLines(const Input& input, Progress& progress);
  Subject makeStippling(const Input& input, Progress& progress) const;

  const RenderOptions& Options;
  std::vector<double> IsoValues;
  MeshSampler Meshes;
};

} // namespace ink::cli
