// SPDX-License-Identifier: BSD-3-Clause
#include "InkToonPass.h"

#include "InkDrawHidingDepths.h"
#include "InkFrame.h"
#include "InkMeshTriangles.h"
#include "InkOccluder.h"
#include "InkRenderPasses.h"
#include "InkShader.h"
#include "InkSourcePoints.h"
#include "InkStrokeStyle.h"
#include "InkVertexLimit.h"
#include "InkViewUniforms.h"

#include "InkToonFS.h"
#include "InkToonVS.h"

#include "InkOpenGLCompat.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPolyData.h"
#include "vtkTextureObject.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

InkToonPass::InkToonPass(vtkOpenGLRenderWindow* window)
  : Window(window)
  , Ids(window)
{
}

InkToonPass::~InkToonPass()
{
  this->Corners->ReleaseGraphicsResources();
}

std::string InkToonPass::Update(vtkPolyData* surface)
{
  if (this->UploadTime > 0 && this->SurfaceTime == surface->GetMTime())
  {
    return {};
  }
  this->SurfaceTime = surface->GetMTime();
  double bounds[6];
  InkShiftScale::FindFiniteBounds(surface->GetPoints(), bounds);
  this->Frame = InkShiftScale::FromBounds(bounds);
  const InkMeshTriangles mesh(surface, true, InkMeshTriangles::Order::OfMesh);
  vtkIdTypeArray* sources = InkGetSourcePoints(surface);
  std::vector<float> corners;
  std::vector<std::uint32_t> ids;
  corners.reserve(18 * mesh.Triangles.size());
  for (const ink::Triangle& triangle : mesh.Triangles)
  {
    float values[18];
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const auto point = static_cast<std::size_t>(triangle[corner]);
      this->Frame.ToLocal(&mesh.Points[point].x, values + 6 * corner);
      std::copy_n(&mesh.Normals[point].x, 3, values + 6 * corner + 3);
    }
    if (std::all_of(values, values + 18, [](float value) { return std::isfinite(value); }))
    {
      corners.insert(corners.end(), values, values + 18);
      ids.push_back(static_cast<std::uint32_t>(InkSourcePoint(sources, triangle[0])));
    }
  }
  vtkTimeStamp now;
  now.Modified();
  this->UploadTime = now.GetMTime();
  this->NumberOfCorners = 0;
  std::string problem = InkFindVertexProblem(3 * ids.size());
  if (!problem.empty())
  {
    return problem;
  }
  this->NumberOfCorners = static_cast<int>(3 * ids.size());
  if (this->NumberOfCorners > 0)
  {
    this->Corners->Upload(corners, vtkOpenGLBufferObject::ArrayBuffer);
  }
  // Without ids there is a picture still.
  const int most = InkTextureBuffer::FindMostTexels(this->Window);
  if (ids.size() > static_cast<std::size_t>(most))
  {
    problem = "This OpenGL can select among " + std::to_string(most) + " triangles; the surface has " +
      std::to_string(ids.size()) + ".";
    ids.clear();
  }
  this->Ids.Fill(ids, 1, VTK_UNSIGNED_INT, GL_R32UI);
  return problem;
}

void InkToonPass::SetUniforms(vtkShaderProgram* program, const Scene& scene, const InkFrame& frame)
{
  scene.View.SetUniforms(program);
  frame.SetOrigin(program);
  program->SetUniformf("largestCosine", scene.LargestCosine);
  program->SetUniformf("lift", scene.Lift);
  program->SetUniformf("actorOpacity", scene.Opacity);
  InkSetColorUniform(program, "inkColor", scene.Color);
  scene.Occluder.SetUniforms(program, scene.View);
}

void InkToonPass::Draw(const Scene& scene, const InkFrame& frame, const InkRenderPasses& renderPasses)
{
  if (this->NumberOfCorners == 0 || (frame.Ids && !this->Ids.IsFilled()))
  {
    return;
  }
  std::string vertexShader = InkToonVS;
  std::string geometryShader;
  std::string fragmentShader =
    InkWithFeatures(InkToonFS, scene.View.FindFeatures() + (frame.Ids ? InkDefine("INK_IDS") : ""));
  if (!frame.Ids)
  {
    renderPasses.ReplaceShaderValues(vertexShader, geometryShader, fragmentShader);
  }
  InkShaderPass& pass = this->Passes.Find(vertexShader, geometryShader, fragmentShader);
  vtkShaderProgram* program = pass.Begin(this->Window, this->UploadTime,
    [this](vtkShaderProgram* made, vtkOpenGLVertexArrayObject* vertexArray)
    {
      constexpr int stride = 6 * sizeof(float);
      vertexArray->AddAttributeArray(made, this->Corners, "pointMC", 0, stride, VTK_FLOAT, 3, false);
      vertexArray->AddAttributeArray(
        made, this->Corners, "normalMC", 3 * sizeof(float), stride, VTK_FLOAT, 3, false);
    });
  if (!program)
  {
    return;
  }
  this->SetUniforms(program, scene, frame);
  vtkTextureObject* depths = scene.Occluder.Image.GetTexture();
  depths->Activate();
  program->SetUniformi("occluder", depths->GetTextureUnit());
  const auto draw = [&](float leastCoverage)
  {
    program->SetUniformf("leastCoverage", leastCoverage);
    glDrawArrays(GL_TRIANGLES, 0, this->NumberOfCorners);
  };
  if (frame.Ids)
  {
    this->Ids.Activate(program, "pointIds");
    frame.Ids->SetUniforms(program);
    draw(0.0f);
    this->Ids.Deactivate();
  }
  else
  {
    renderPasses.SetShaderParameters(program, pass.GetVertexArray());
    draw(0.0f);
    InkDrawHidingDepths(this->Window->GetState(), frame, renderPasses, program, draw);
  }
  depths->Deactivate();
  pass.End();
}
