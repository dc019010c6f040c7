// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkSilhouetteMapper.h"

#include "InkActorResources.h"
#include "InkContourLines.h"
#include "InkFrame.h"
#include "InkHasPolygons.h"
#include "InkMeshTriangles.h"
#include "InkPointNormals.h"
#include "InkRenderPasses.h"
#include "InkStrokeMarks.h"
#include "InkStrokeStyle.h"
#include "InkUploadEvent.h"
#include "InkViewUniforms.h"

#include "Curves/Contours/CoherentDashes.h"
#include "Curves/Contours/LengthPriority.h"
#include "Curves/Contours/MeshContours.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTimerLog.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkInkSilhouetteMapper);

namespace
{

/// The eye in the coordinates of an actor's data.
ink::Eye FindEye(vtkCamera* camera, vtkActor* actor)
{
  vtkNew<vtkMatrix4x4> toView;
  actor->GetModelToWorldMatrix(toView);
  vtkMatrix4x4::Multiply4x4(camera->GetModelViewTransformMatrix(), toView, toView);
  vtkNew<vtkMatrix4x4> fromView;
  vtkMatrix4x4::Invert(toView, fromView);
  const bool parallel = camera->GetParallelProjection();
  const double inView[4] = { 0.0, 0.0, parallel ? -1.0 : 0.0, parallel ? 0.0 : 1.0 };
  double eye[4];
  fromView->MultiplyPoint(inView, eye);
  const glm::dvec3 found(eye[0], eye[1], eye[2]);
  return parallel ? ink::Eye::along(found) : ink::Eye::at(found);
}

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

/// Lines with all their arrays, their priority, and as ids for selection a point of the surface beside each.
vtkSmartPointer<vtkPolyData> MakeLines(const ink::Contours& contours, const InkMeshTriangles& surface)
{
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  InkMakeContourLines(contours, VTK_DOUBLE, surface.FaceIds, lines);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("vtkOriginalPointIds");
  ids->SetNumberOfTuples(static_cast<vtkIdType>(contours.elements.size()));
  for (std::size_t i = 0; i < contours.elements.size(); ++i)
  {
    ids->SetValue(
      static_cast<vtkIdType>(i), surface.Triangles[static_cast<std::size_t>(contours.elements[i])][0]);
  }
  lines->GetPointData()->AddArray(ids);
  const std::vector<float> shares = ink::lengthPriorities(contours);
  vtkNew<vtkFloatArray> priorities;
  priorities->SetName("Priority");
  priorities->SetNumberOfTuples(static_cast<vtkIdType>(shares.size()));
  std::copy(shares.begin(), shares.end(), priorities->GetPointer(0));
  lines->GetCellData()->AddArray(priorities);
  return lines;
}

} // namespace

class vtkInkSilhouetteMapper::vtkInternals
{
public:
  /// What the contours depend on beside the eye.
  struct Key
  {
    vtkMTimeType Surface;
    ink::MeshContourOptions Options;
    bool operator==(const Key&) const = default;
  };
  std::optional<Key> Source;
  std::optional<InkMeshTriangles> Mesh;
  std::optional<ink::MeshContours> Finder;

  struct Drawn
  {
    std::optional<Key> Source;
    ink::Eye Eye;
    vtkSmartPointer<vtkPolyData> Lines;
    ink::CoherentDashes Dashes;
    double Period = 0.0; ///< that the lines are aligned for, in the surface's unit; 0: they are not aligned

    /// Shifts the lines' arc length.
    /// @param contours what the lines are of
    void AlignDashes(ink::Contours& contours)
    {
      constexpr double periodsOfReach = 2.0; // farther away are other lines
      this->Dashes.align(contours, this->Period, periodsOfReach * this->Period);
      vtkDataArray* arcLengths = this->Lines->GetPointData()->GetArray("ArcLength");
      for (std::size_t i = 0; i < contours.arcLength.size(); ++i)
      {
        arcLengths->SetComponent(static_cast<vtkIdType>(i), 0, contours.arcLength[i]);
      }
      arcLengths->Modified();
    }
  };
  InkActorResources<Drawn> Views;
};

const char* vtkInkSilhouetteMapper::GetMethodAsString()
{
  static const char* const names[] = { "Chains", "VoxelSegments", "ImageSpace", "Toon" };
  return names[this->Method];
}

vtkInkSilhouetteMapper::vtkInkSilhouetteMapper()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkInkSilhouetteMapper::~vtkInkSilhouetteMapper() = default;

vtkPolyData* vtkInkSilhouetteMapper::FindSurface()
{
  vtkPolyData* other = this->Superclass::FindSurface();
  const bool any = other && other->GetNumberOfPoints() > 0;
  return any || this->Method == VOXEL_SEGMENTS ? other : this->GetInput();
}

bool vtkInkSilhouetteMapper::CheckPolygons()
{
  vtkPolyData* surface = this->GetInput();
  if (!InkHasPolygons(surface))
  {
    std::ostringstream message;
    message << "Contours need a surface of polygons or strips; found none among "
            << surface->GetNumberOfPoints() << " points and " << surface->GetNumberOfCells() << " cells.";
    this->ReportOnce(message.str());
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

bool vtkInkSilhouetteMapper::UpdateSurface()
{
  vtkInternals& internals = *this->Internals;
  vtkPolyData* surface = this->GetInput();
  const vtkInternals::Key source{ surface->GetMTime(),
    { this->Silhouettes, this->Faceted, this->Creases, this->FeatureAngle, this->Borders,
      this->NonManifoldEdges, this->ShortestCrease, this->ShortestBorder, true, this->SharpCreasesOnly } };
  if (internals.Source == source)
  {
    return internals.Finder.has_value();
  }
  const bool newSurface = !internals.Source || internals.Source->Surface != source.Surface;
  internals.Source.reset();
  internals.Finder.reset();
  if (newSurface)
  {
    internals.Mesh.reset();
  }
  if (!this->CheckPolygons())
  {
    return false;
  }
  if (!internals.Mesh)
  {
    internals.Mesh.emplace(surface, true, InkMeshTriangles::Order::OfMesh);
    this->WarnOfNormals();
  }
  internals.Finder.emplace(internals.Mesh->GetMesh(), internals.Mesh->Normals, source.Options);
  internals.Source = source;
  return true;
}

bool vtkInkSilhouetteMapper::UpdateMarks(InkMarks& own)
{
  auto& marks = static_cast<InkStrokeMarks&>(own);
  try
  {
    switch (this->Method)
    {
      case VOXEL_SEGMENTS:
        return this->Silhouettes && this->UpdateVoxels(own, this->GetInput());
      case IMAGE_SPACE:
        return this->Silhouettes && this->CheckPolygons() && this->UpdateEdges(own, this->GetInput());
      case TOON:
        return this->Silhouettes && this->CheckPolygons() && this->UpdateToon(marks);
      default:
        return this->UpdateSurface();
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
  marks.Toon.Update(this->GetInput());
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
  const ink::Eye eye = FindEye(frame.Renderer->GetActiveCamera(), frame.Actor);
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

bool vtkInkSilhouetteMapper::UpdateChains(InkMarks& own, const InkFrame& frame)
{
  vtkInternals& internals = *this->Internals;
  vtkInternals::Drawn& drawn = internals.Views.Get(frame.Renderer, frame.Actor);
  const ink::Eye eye = FindEye(frame.Renderer->GetActiveCamera(), frame.Actor);
  const auto upload = [&]
  { return drawn.Lines->GetNumberOfLines() > 0 && this->UpdateStrokes(own, drawn.Lines); };
  // How long a dash is follows from where the strokes are.
  const auto findPeriod = [&]
  { return this->CoherentDashes && upload() ? this->FindDashPeriod(own, frame) : 0.0; };
  const bool sameContours = drawn.Source == internals.Source && drawn.Eye == eye;
  constexpr double tolerance = 1e-4; // tiles of a picture have other rounding
  if (const double period = sameContours ? findPeriod() : 0.0;
      !sameContours || std::abs(period - drawn.Period) > tolerance * period)
  {
    try
    {
      const ink::ContourArrays arrays{ true, true, true, true };
      ink::Contours contours = internals.Finder->find(eye, arrays);
      drawn.Lines = MakeLines(contours, *internals.Mesh);
      drawn.Period = findPeriod();
      if (drawn.Source != internals.Source || drawn.Period == 0.0)
      {
        drawn.Dashes.reset();
      }
      if (drawn.Period > 0.0)
      {
        drawn.AlignDashes(contours);
      }
    }
    catch (const std::exception& error)
    {
      this->ReportOnce(std::string("The contours of the surface cannot be found: ") + error.what());
      return false;
    }
    drawn.Source = internals.Source;
    drawn.Eye = eye;
  }
  return upload();
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
      vtkTimerLog::MarkStartEvent(InkUploadEvent);
      const bool there = this->UpdateChains(own, frame);
      vtkTimerLog::MarkEndEvent(InkUploadEvent);
      if (there)
      {
        this->Superclass::DrawMarks(own, frame);
      }
  }
}

vtkPolyData* vtkInkSilhouetteMapper::GetContours(vtkRenderer* renderer, vtkActor* actor)
{
  const vtkInternals::Drawn* drawn = this->Internals->Views.Find(renderer, actor);
  return drawn ? drawn->Lines.Get() : nullptr;
}

bool vtkInkSilhouetteMapper::EvaluateWidths(vtkRenderer*, vtkActor*, vtkFloatArray* widths)
{
  widths->Initialize();
  return false;
}

void vtkInkSilhouetteMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  auto* from = vtkInkSilhouetteMapper::SafeDownCast(mapper);
  if (from && from != this)
  {
    this->SetMethod(from->GetMethod());
    this->SetLowestValue(from->GetLowestValue());
    this->SetHighestValue(from->GetHighestValue());
    this->SetLeastGradientMagnitude(from->GetLeastGradientMagnitude());
    this->SetLargestCosine(from->GetLargestCosine());
    this->SetSegmentLength(from->GetSegmentLength());
    this->SetThinning(from->GetThinning());
    this->SetSilhouettes(from->GetSilhouettes());
    this->SetFaceted(from->GetFaceted());
    this->SetCreases(from->GetCreases());
    this->SetFeatureAngle(from->GetFeatureAngle());
    this->SetShortestCrease(from->GetShortestCrease());
    this->SetSharpCreasesOnly(from->GetSharpCreasesOnly());
    this->SetShortestBorder(from->GetShortestBorder());
    this->SetBorders(from->GetBorders());
    this->SetNonManifoldEdges(from->GetNonManifoldEdges());
    this->SetCoherentDashes(from->GetCoherentDashes());
  }
  this->Superclass::ShallowCopy(mapper);
}

void vtkInkSilhouetteMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->GetMethodAsString() << "\n";
  os << indent << "LowestValue: " << this->LowestValue << "\n";
  os << indent << "HighestValue: " << this->HighestValue << "\n";
  os << indent << "LeastGradientMagnitude: " << this->LeastGradientMagnitude << "\n";
  os << indent << "LargestCosine: " << this->LargestCosine << "\n";
  os << indent << "SegmentLength: " << this->SegmentLength << "\n";
  os << indent << "Thinning: " << (this->Thinning ? "On" : "Off") << "\n";
  os << indent << "Silhouettes: " << (this->Silhouettes ? "On" : "Off") << "\n";
  os << indent << "Faceted: " << (this->Faceted ? "On" : "Off") << "\n";
  os << indent << "Creases: " << (this->Creases ? "On" : "Off") << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "ShortestCrease: " << this->ShortestCrease << "\n";
  os << indent << "SharpCreasesOnly: " << (this->SharpCreasesOnly ? "On" : "Off") << "\n";
  os << indent << "ShortestBorder: " << this->ShortestBorder << "\n";
  os << indent << "Borders: " << (this->Borders ? "On" : "Off") << "\n";
  os << indent << "NonManifoldEdges: " << (this->NonManifoldEdges ? "On" : "Off") << "\n";
  os << indent << "CoherentDashes: " << (this->CoherentDashes ? "On" : "Off") << "\n";
}
