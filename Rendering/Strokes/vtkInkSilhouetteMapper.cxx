// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkSilhouetteMapper.h"

#include "vtkInkSilhouetteMapperInternals.h"

#include "InkDrawingProgress.h"
#include "InkFrame.h"
#include "InkHasPolygons.h"
#include "InkNotFiniteFaces.h"
#include "InkPointNormals.h"
#include "InkRenderPasses.h"
#include "InkStrokeMarks.h"
#include "InkStrokeStyle.h"
#include "InkUploadEvent.h"
#include "InkViewUniforms.h"

#include "vtkActor.h"
#include "vtkContourValues.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"

#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <exception>
#include <sstream>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkInkSilhouetteMapper);

namespace
{

/// How high the sphere around a box is in the picture, as a share of the picture's height: 1 at most (Lu et
/// al. 2003, section 5.6).
float FindPictureShare(const std::array<double, 6>& box, const InkViewUniforms& view)
{
  const glm::dvec3 low(box[0], box[2], box[4]);
  const glm::dvec3 high(box[1], box[3], box[5]);
  const double radius = 0.5 * glm::distance(low, high) * view.Unit;
  const glm::dvec4 center(0.5 * (low + high), 1.0);
  const double depth = -(glm::dmat4(glm::make_mat4(view.MCVC.data())) * center).z;
  const bool parallel = view.Eye[3] == 0.0f;
  if (!parallel && depth <= radius)
  {
    return 1.0f;
  }
  const double pixels = radius / (view.Pixel * (parallel ? 1.0 : depth));
  return static_cast<float>(std::min(2.0 * pixels / view.PictureHeight, 1.0));
}

/// Of a picture's time, about, when its contours are found.
constexpr double ContoursEnd = 0.5;

} // namespace

vtkInkSilhouetteMapper::vtkInkSilhouetteMapper()
  : Internals(std::make_unique<vtkInternals>())
{
  // vtkContourValues initially holds one value.
  this->ContourValues->SetNumberOfContours(0);
  this->SetInputArrayToProcess(
    1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkInkSilhouetteMapper::~vtkInkSilhouetteMapper() = default;

int vtkInkSilhouetteMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  const int filled = this->Superclass::FillInputPortInformation(port, info);
  if (port == 0)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  }
  return filled;
}

bool vtkInkSilhouetteMapper::CheckPolygons()
{
  std::ostringstream message;
  vtkPolyData* surface = this->GetInput();
  if (!surface)
  {
    message
      << "Lines in image space and toon shading need a surface of polygons or strips; found an image, of "
         "which there are contours by the Method CHAINS.";
  }
  else if (!InkHasPolygons(surface))
  {
    message << "Contours need a surface of polygons or strips; found none among "
            << surface->GetNumberOfPoints() << " points and " << surface->GetNumberOfCells() << " cells.";
  }
  if (!message.str().empty())
  {
    this->ReportOnce(message.str());
    return false;
  }
  if (std::exchange(this->Internals->CheckedTime, surface->GetMTime()) != surface->GetMTime())
  {
    InkWarnOfNotFiniteFaces(this, surface);
  }
  return true;
}

bool vtkInkSilhouetteMapper::CheckVoxels()
{
  if (this->FindImage())
  {
    this->ReportOnce("Segments through voxels need points, as vtkInkEdgeVoxels finds them; found an image.");
    return false;
  }
  return true;
}

void vtkInkSilhouetteMapper::WarnOfNormals()
{
  if (!InkPointNormals(this->GetInput()))
  {
    vtkWarningMacro("The surface has no point normals with 3 components: contours are those of computed "
                    "ones, which join all polygons at a point.");
  }
}

bool vtkInkSilhouetteMapper::UpdateMarks(InkMarks& own)
{
  auto& marks = static_cast<InkStrokeMarks&>(own);
  try
  {
    switch (this->Method)
    {
      case VOXEL_SEGMENTS:
        return this->Silhouettes && this->CheckVoxels() && this->UpdateVoxels(own, this->GetInput());
      case IMAGE_SPACE:
        return this->Silhouettes && this->CheckPolygons() && this->UpdateEdges(own, this->GetInput());
      case TOON:
        return this->Silhouettes && this->CheckPolygons() && this->UpdateToon(marks);
      default:
        return this->UpdateFinder();
    }
  }
  catch (const std::exception& error)
  {
    this->ReportOnce(std::string("The contours of the surface cannot be found: ") + error.what());
    return false;
  }
}

bool vtkInkSilhouetteMapper::UpdateToon(InkStrokeMarks& marks)
{
  const vtkMTimeType before = marks.Toon.GetUploadTime();
  if (const std::string problem = marks.Toon.Update(this->GetInput()); !problem.empty())
  {
    this->ReportOnce(problem);
  }
  if (marks.Toon.GetUploadTime() != before)
  {
    this->WarnOfNormals();
  }
  return true;
}

void vtkInkSilhouetteMapper::ChooseByEye(
  const InkStrokeMarks& marks, const InkFrame& frame, const InkViewUniforms& view, InkStrokeStyle& style)
{
  const auto number = [](double value) { return static_cast<float>(value); };
  const ink::Eye eye = vtkInternals::FindEye(frame);
  if (eye.parallel)
  {
    const glm::dvec3 towards = -glm::normalize(eye.direction);
    style.Eye = { number(towards.x), number(towards.y), number(towards.z), 0.0f };
  }
  else
  {
    marks.Strokes.GetFrame().ToLocal(&eye.position.x, style.Eye.data());
    style.Eye[3] = 1.0f;
  }
  if (this->Method == IMAGE_SPACE)
  {
    style.BackEdges = true;
    style.Dashed = style.HiddenDashed = false;
    const float share = this->Thinning ? FindPictureShare(marks.Strokes.GetLocalBounds(), view) : 1.0f;
    style.HalfWidth = { share * style.HalfWidth[0], share * style.HalfWidth[1] };
    return;
  }
  InkVoxelSegments& voxels = style.Voxels.emplace();
  voxels.ValueBounds = { number(this->LowestValue), number(this->HighestValue) };
  voxels.LeastGradient = number(this->LeastGradientMagnitude / marks.Strokes.GetGradientUnit());
  voxels.LargestCosine = number(this->LargestCosine);
  voxels.SegmentLength = number(this->SegmentLength);
}

void vtkInkSilhouetteMapper::DrawToon(InkStrokeMarks& marks, const InkFrame& frame)
{
  const InkOccluderDepth* depth = this->UpdateDepth(marks, frame);
  if (!depth)
  {
    return;
  }
  const InkViewUniforms view(frame.Renderer, frame.Actor, this, marks.Toon.GetFrame(), frame.GetSize());
  const InkToonPass::Scene scene{ view, *depth, static_cast<float>(this->LargestCosine),
    static_cast<float>(this->GetLift()), this->GetInkColor(),
    static_cast<float>(frame.Actor->GetProperty()->GetOpacity()) };
  marks.Toon.Draw(scene, frame, InkRenderPasses(this, frame.Actor));
}

void vtkInkSilhouetteMapper::DrawMarks(InkMarks& own, const InkFrame& frame)
{
  auto& marks = static_cast<InkStrokeMarks&>(own);
  switch (this->Method)
  {
    case VOXEL_SEGMENTS:
    case IMAGE_SPACE:
      this->DrawStrokes(marks, frame,
        [&](InkStrokeStyle& style, const InkViewUniforms& view)
        { this->ChooseByEye(marks, frame, view, style); });
      return;
    case TOON:
      this->DrawToon(marks, frame);
      return;
    default:
      InkStrokeMarks& chains = marks.GetOfView(frame.Renderer, frame.Actor);
      vtkTimerLog::MarkStartEvent(InkUploadEvent);
      const bool there = this->UpdateChains(chains, frame);
      vtkTimerLog::MarkEndEvent(InkUploadEvent);
      frame.Progress.Until(ContoursEnd);
      frame.Progress.Report();
      if (there)
      {
        this->Superclass::DrawMarks(chains, frame);
      }
  }
}

bool vtkInkSilhouetteMapper::EvaluateWidths(vtkRenderer*, vtkActor*, vtkFloatArray* widths)
{
  widths->Initialize();
  return false;
}
