// SPDX-License-Identifier: BSD-3-Clause
#include "InkShaderPass.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkShaderProgram.h"

#include <utility>

InkShaderPass::InkShaderPass(std::string vertexShader, std::string geometryShader, std::string fragmentShader)
  : VertexShader(std::move(vertexShader))
  , GeometryShader(std::move(geometryShader))
  , FragmentShader(std::move(fragmentShader))
{
}

InkShaderPass::~InkShaderPass()
{
  this->VertexArray->ReleaseGraphicsResources();
}

vtkShaderProgram* InkShaderPass::Begin(
  vtkOpenGLRenderWindow* window, vtkMTimeType uploadTime, const BindAttributes& bindAttributes)
{
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    this->VertexShader.c_str(), this->FragmentShader.c_str(), this->GeometryShader.c_str());
  if (!program)
  {
    return nullptr;
  }
  const bool bound = this->ProgramHandle == program->GetHandle() && this->UploadTime == uploadTime;
  if (!bound)
  {
    // This deletes the binding: it goes before Bind.
    this->VertexArray->ShaderProgramChanged();
  }
  this->VertexArray->Bind();
  if (!bound)
  {
    bindAttributes(program, this->VertexArray);
    this->ProgramHandle = program->GetHandle();
    this->UploadTime = uploadTime;
  }
  return program;
}

void InkShaderPass::End()
{
  this->VertexArray->Release();
}

InkShaderPass& InkShaderPasses::Find(
  const std::string& vertexShader, const std::string& geometryShader, const std::string& fragmentShader)
{
  std::unique_ptr<InkShaderPass>& pass = this->Passes[vertexShader + geometryShader + fragmentShader];
  if (!pass)
  {
    pass = std::make_unique<InkShaderPass>(vertexShader, geometryShader, fragmentShader);
  }
  return *pass;
}
