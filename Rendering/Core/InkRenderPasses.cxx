// SPDX-License-Identifier: BSD-3-Clause
#include "InkRenderPasses.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOrderIndependentTranslucentPass.h"

InkRenderPasses::InkRenderPasses(vtkAbstractMapper* mapper, vtkActor* actor)
  : Mapper(mapper)
  , Actor(actor)
{
  vtkInformation* keys = actor->GetPropertyKeys();
  if (keys && keys->Has(vtkOpenGLRenderPass::RenderPasses()))
  {
    for (int i = 0; i < keys->Length(vtkOpenGLRenderPass::RenderPasses()); ++i)
    {
      this->Passes.push_back(
        static_cast<vtkOpenGLRenderPass*>(keys->Get(vtkOpenGLRenderPass::RenderPasses(), i)));
    }
  }
}

bool InkRenderPasses::IsOrderIndependent() const
{
  return this->Passes.size() == 1 && vtkOrderIndependentTranslucentPass::SafeDownCast(this->Passes.front());
}

void InkRenderPasses::ReplaceShaderValues(
  std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader) const
{
  for (vtkOpenGLRenderPass* pass : this->Passes)
  {
    pass->PreReplaceShaderValues(vertexShader, geometryShader, fragmentShader, this->Mapper, this->Actor);
  }
  for (vtkOpenGLRenderPass* pass : this->Passes)
  {
    pass->PostReplaceShaderValues(vertexShader, geometryShader, fragmentShader, this->Mapper, this->Actor);
  }
}

void InkRenderPasses::SetShaderParameters(
  vtkShaderProgram* program, vtkOpenGLVertexArrayObject* vertexArray) const
{
  for (vtkOpenGLRenderPass* pass : this->Passes)
  {
    pass->SetShaderParameters(program, this->Mapper, this->Actor, vertexArray);
  }
}
