// SPDX-License-Identifier: BSD-3-Clause
#include "InkFullScreenPasses.h"

#include "InkRenderPasses.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

InkFullScreenPasses::InkFullScreenPasses(vtkOpenGLRenderWindow* window)
  : Window(window)
{
}

InkFullScreenPasses::~InkFullScreenPasses() = default;

vtkShaderProgram* InkFullScreenPasses::Begin(std::string fragmentShader, const InkRenderPasses* renderPasses)
{
  std::string vertexShader = vtkOpenGLRenderUtilities::GetFullScreenQuadVertexShader();
  std::string geometryShader;
  if (renderPasses)
  {
    renderPasses->ReplaceShaderValues(vertexShader, geometryShader, fragmentShader);
  }
  std::unique_ptr<vtkOpenGLQuadHelper>& quad = this->Quads[vertexShader + geometryShader + fragmentShader];
  if (!quad)
  {
    quad = std::make_unique<vtkOpenGLQuadHelper>(
      this->Window, vertexShader.c_str(), fragmentShader.c_str(), geometryShader.c_str());
  }
  this->Current = quad.get();
  vtkShaderProgram* program = this->Window->GetShaderCache()->ReadyShaderProgram(quad->Program);
  if (program && renderPasses)
  {
    renderPasses->SetShaderParameters(program, quad->VAO);
  }
  return program;
}

void InkFullScreenPasses::Draw()
{
  this->Current->Render();
}
