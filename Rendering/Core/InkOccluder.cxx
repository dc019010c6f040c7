// SPDX-License-Identifier: BSD-3-Clause
#include "InkOccluder.h"

#include "InkGhostPoint.h"
#include "InkHasPolygons.h"
#include "InkPointNormals.h"
#include "InkPointSize.h"
#include "InkScopedState.h"
#include "InkShader.h"
#include "InkShiftScale.h"
#include "InkVertexLimit.h"

#include "InkOccluderDiscFS.h"
#include "InkOccluderDiscVS.h"
#include "InkOccluderFS.h"
#include "InkOccluderVS.h"

#include "InkOpenGLCompat.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShaderProgram.h"
#include "vtkTimeStamp.h"
#include "vtkTriangleFilter.h"

#include "Core/ParallelChunks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace
{

/// How far the surface is pushed behind marks on it: twice as far as its depth changes within a pixel, and a
/// few of the smallest steps of depth.
constexpr float OffsetFactor = 2.0f;
constexpr float OffsetUnits = 4.0f;

/// By how many pixels the viewport is wider than the image of discs, so that points can be left out there.
constexpr int Margin = 4;

int FindLargestImage(vtkOpenGLRenderWindow* window)
{
  int largest = 0;
  window->GetState()->vtkglGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  return largest;
}

/// How wide an image's margin is for dots that reach so far: in steps, as most images are made anew when it
/// changes, and no wider than seems worth it.
int FindMargin(int largest, const std::array<int, 2>& size, float reach)
{
  constexpr int step = 16;
  constexpr int most = 256;
  const int room = std::max((largest - std::max(size[0], size[1])) / 2, 0);
  const int wanted = step * static_cast<int>(std::ceil(std::min(reach, static_cast<float>(most)) / step));
  return std::min(wanted, room);
}

/// A polygon offset, which vtkOpenGLState does not know; the caller's again at its end.
class PolygonOffset
{
public:
  PolygonOffset(float factor, float units)
    : Enabled(glIsEnabled(GL_POLYGON_OFFSET_FILL) == GL_TRUE)
  {
    glGetFloatv(GL_POLYGON_OFFSET_FACTOR, &this->Factor);
    glGetFloatv(GL_POLYGON_OFFSET_UNITS, &this->Units);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(factor, units);
  }
  ~PolygonOffset()
  {
    glPolygonOffset(this->Factor, this->Units);
    if (!this->Enabled)
    {
      glDisable(GL_POLYGON_OFFSET_FILL);
    }
  }
  PolygonOffset(const PolygonOffset&) = delete;
  void operator=(const PolygonOffset&) = delete;

private:
  bool Enabled;
  float Factor = 0.0f;
  float Units = 0.0f;
};

} // namespace

void InkOccluderDepth::SetUniforms(vtkShaderProgram* program, const InkViewUniforms& view) const
{
  const InkViewUniforms& shown = *this->View;
  program->SetUniformf(
    "occluderScale", static_cast<float>(shown.Size[0] - 2 * shown.Margin) / static_cast<float>(view.Size[0]));
  program->SetUniformf("occluderMargin", static_cast<float>(shown.Margin));
}

InkOccluder::InkOccluder(vtkOpenGLRenderWindow* window, bool offset)
  : Window(window)
  , Offset(offset)
{
}

InkOccluder::~InkOccluder()
{
  this->Buffer->ReleaseGraphicsResources();
}

std::string InkOccluder::Update(vtkPolyData* surface, const InkShiftScale& frame)
{
  const std::array<double, 4> transform{ frame.Center[0], frame.Center[1], frame.Center[2], frame.Unit };
  if (this->UploadTime > 0 && this->SurfaceTime == surface->GetMTime() && this->Frame == transform)
  {
    return {};
  }
  this->SurfaceTime = surface->GetMTime();
  this->Frame = transform;
  this->LargestRadius = 0.0f;
  this->NumberOfVertices = 0;
  std::string problem =
    InkHasPolygons(surface) ? this->UploadTriangles(surface, frame) : this->UploadDiscs(surface, frame);
  vtkTimeStamp now;
  now.Modified();
  this->UploadTime = now.GetMTime();
  return problem;
}

std::string InkOccluder::Upload(const std::vector<float>& numbers, std::size_t numbersPerVertex)
{
  const std::size_t count = numbers.size() / numbersPerVertex;
  std::string problem = InkFindVertexProblem(count);
  if (count > 0 && problem.empty())
  {
    this->Buffer->Upload(numbers, vtkOpenGLBufferObject::ArrayBuffer);
    this->NumberOfVertices = static_cast<int>(count);
  }
  return problem;
}

std::string InkOccluder::UploadDiscs(vtkPolyData* points, const InkShiftScale& frame)
{
  vtkPointData* data = points->GetPointData();
  vtkDataArray* normals = InkPointNormals(points);
  vtkDataArray* radii = data->GetArray("Radius");
  const vtkIdType count = points->GetNumberOfPoints();
  if (!normals || !radii || radii->GetNumberOfComponents() != 1)
  {
    return {};
  }
  vtkUnsignedCharArray* ghosts = points->GetPointGhostArray();
  const auto add = [&](std::size_t index, std::vector<float>& vertices)
  {
    const auto i = static_cast<vtkIdType>(index);
    double p[3];
    double normal[3];
    float local[3];
    points->GetPoint(i, p);
    frame.ToLocal(p, local);
    normals->GetTuple(i, normal);
    const double radius = radii->GetComponent(i, 0) / frame.Unit;
    const double scale = radius / vtkMath::Norm(normal);
    const bool usable = radius > 0.0 && scale > 0.0 && std::isfinite(scale) && std::isfinite(local[0]) &&
      std::isfinite(local[1]) && std::isfinite(local[2]) && !InkIsGhostPoint(ghosts, i);
    if (usable)
    {
      vertices.insert(vertices.end(), local, local + 3);
      for (const double component : normal)
      {
        vertices.push_back(static_cast<float>(scale * component));
      }
    }
  };
  const std::vector<float> vertices = ink::parallelGather<float>(static_cast<std::size_t>(count), add);
  this->LargestRadius = ink::parallelReduce(
    vertices.size() / 6, 0.0f, [&](std::size_t i) { return vtkMath::Norm(vertices.data() + 6 * i + 3); },
    [](float a, float b) { return std::max(a, b); });
  return this->Upload(vertices, 6);
}

std::string InkOccluder::UploadTriangles(vtkPolyData* surface, const InkShiftScale& frame)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(surface);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  vtkPolyData* output = triangles->GetOutput();
  vtkCellArray* cells = output->GetPolys();
  std::vector<float> vertices;
  vertices.reserve(9 * static_cast<std::size_t>(cells->GetNumberOfCells()));
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    cells->GetCellAtId(cell, size, ids);
    float corners[9];
    for (int corner = 0; corner < 3; ++corner)
    {
      double p[3];
      output->GetPoint(ids[corner], p);
      frame.ToLocal(p, corners + 3 * corner);
    }
    if (std::all_of(corners, corners + 9, [](float c) { return std::isfinite(c); }))
    {
      vertices.insert(vertices.end(), corners, corners + 9);
    }
  }
  return this->Upload(vertices, 3);
}

void InkOccluder::Draw(
  const InkViewUniforms& shown, float reach, std::unique_ptr<InkOccluderDepth>& depth, int finer)
{
  InkViewUniforms view = shown;
  const int largest = FindLargestImage(this->Window);
  const int factor = std::clamp(largest / std::max({ view.Size[0], view.Size[1], 1 }), 1, finer);
  view.Refine(factor);
  view.Widen(FindMargin(largest, view.Size, reach * static_cast<float>(factor)));
  if (depth && depth->View == view && depth->UploadTime == this->UploadTime)
  {
    return;
  }
  if (!depth || !depth->View || depth->View->Size != view.Size)
  {
    depth = std::make_unique<InkOccluderDepth>(this->Window, view.Size);
  }
  depth->View = view;
  depth->UploadTime = this->UploadTime;
  if (!depth->Image.IsComplete())
  {
    return;
  }

  vtkOpenGLState* state = this->Window->GetState();
  const InkScopedState scoped(state);
  depth->Image.Bind();
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_DEPTH_BUFFER_BIT);
  if (this->LargestRadius > 0.0f)
  {
    this->DrawDiscs(view, *depth);
  }
  else
  {
    this->DrawTriangles(view);
  }
}

void InkOccluder::DrawDiscs(const InkViewUniforms& view, InkOccluderDepth& depth)
{
  this->DrawDiscs(view, nullptr);
  // Most of what faces away is hidden.
  if (!depth.Facing)
  {
    depth.Facing = std::make_unique<InkRenderTarget>(
      this->Window, InkRenderTarget::Format::Depth, view.Size[0], view.Size[1]);
  }
  if (depth.Facing->IsComplete())
  {
    depth.Image.CopyTo(*depth.Facing);
    depth.Image.Bind();
    this->DrawDiscs(view, depth.Facing.get());
  }
}

void InkOccluder::DrawDiscs(const InkViewUniforms& view, const InkRenderTarget* facing)
{
  std::string features = view.FindFeatures() + InkDefine("INK_MARGIN " + std::to_string(Margin) + ".0");
  if (facing)
  {
    features += InkDefine("INK_BACK");
  }
  InkShaderPass& pass =
    this->Passes.Find(InkWithFeatures(InkOccluderDiscVS, features), "", InkOccluderDiscFS);
  vtkShaderProgram* program = pass.Begin(this->Window, this->UploadTime,
    [this](vtkShaderProgram* made, vtkOpenGLVertexArrayObject* vertexArray)
    {
      constexpr int stride = 6 * sizeof(float);
      vertexArray->AddAttributeArray(made, this->Buffer, "pointMC", 0, stride, VTK_FLOAT, 3, false);
      vertexArray->AddAttributeArray(
        made, this->Buffer, "normalMC", 3 * sizeof(float), stride, VTK_FLOAT, 3, false);
    });
  if (!program)
  {
    return;
  }
  view.SetUniforms(program);
  const int width = view.Size[0] + Margin;
  const int height = view.Size[1];
  const float size[2] = { static_cast<float>(width), static_cast<float>(height) };
  program->SetUniform2f("targetSize", size);
  this->Window->GetState()->vtkglViewport(0, 0, width, height);
  std::optional<InkRenderTarget::Reading> reading;
  if (facing)
  {
    program->SetUniformi("facing", reading.emplace(*facing->GetTexture()).GetUnit());
  }
  const InkPointSizeByShader pointSize;
  glDrawArrays(GL_POINTS, 0, this->NumberOfVertices);
  pass.End();
}

void InkOccluder::DrawTriangles(const InkViewUniforms& view)
{
  const std::string features = view.FindFeatures();
  InkShaderPass& pass =
    this->Passes.Find(InkWithFeatures(InkOccluderVS, features), "", InkWithFeatures(InkOccluderFS, features));
  vtkShaderProgram* program = pass.Begin(this->Window, this->UploadTime,
    [this](vtkShaderProgram* made, vtkOpenGLVertexArrayObject* vertexArray)
    {
      vertexArray->AddAttributeArray(
        made, this->Buffer, "pointMC", 0, 3 * sizeof(float), VTK_FLOAT, 3, false);
    });
  if (!program)
  {
    return;
  }
  view.SetUniforms(program);
  const PolygonOffset offset(this->Offset ? OffsetFactor : 0.0f, this->Offset ? OffsetUnits : 0.0f);
  glDrawArrays(GL_TRIANGLES, 0, this->NumberOfVertices);
  pass.End();
}
