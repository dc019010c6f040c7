// SPDX-License-Identifier: BSD-3-Clause
#include "DotsMapper.h"

#include "DotsFS.h"
#include "DotsVS.h"

#include "InkFrame.h"
#include "InkMarks.h"
#include "InkPointSize.h"
#include "InkShader.h"
#include "InkShaderPass.h"
#include "InkViewUniforms.h"

#include "InkOpenGLCompat.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPolyData.h"
#include "vtkShaderProgram.h"

#include <vector>

vtkStandardNewMacro(DotsMapper);

int DotsMapper::NumberOfMarks = 0;

namespace
{

/// The points on the GPU, for one window.
class Dots : public InkMarks
{
public:
  explicit Dots(vtkOpenGLRenderWindow* window)
    : Window(window)
  {
    ++DotsMapper::NumberOfMarks;
  }
  ~Dots() override
  {
    this->Buffer->ReleaseGraphicsResources();
    --DotsMapper::NumberOfMarks;
  }
  vtkMTimeType GetUploadTime() const override { return this->Source > 0 ? this->Buffer->GetMTime() : 0; }

  void Upload(vtkPoints* points, const InkShiftScale& frame)
  {
    std::vector<float> positions(3 * static_cast<std::size_t>(points->GetNumberOfPoints()));
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      frame.ToLocal(points->GetPoint(i), &positions[3 * static_cast<std::size_t>(i)]);
    }
    this->Buffer->Upload(positions, vtkOpenGLBufferObject::ArrayBuffer);
    this->Buffer->Modified();
    this->Source = points->GetMTime();
    this->NumberOfPoints = static_cast<int>(points->GetNumberOfPoints());
  }

  void Draw(const InkViewUniforms& view, const InkFrame& frame, const double color[3], double diameter)
  {
    const std::string features = view.FindFeatures() + (frame.Ids ? InkDefine("INK_IDS") : "");
    InkShaderPass& pass =
      this->Passes.Find(InkWithFeatures(DotsVS, features), "", InkWithFeatures(DotsFS, features));
    vtkShaderProgram* program = pass.Begin(this->Window, this->GetUploadTime(),
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
    program->SetUniformf("diameter", static_cast<float>(diameter));
    InkSetColorUniform(program, "inkColor", color);
    if (frame.Ids)
    {
      frame.Ids->SetUniforms(program);
    }
    const InkPointSizeByShader pointSize;
    glDrawArrays(GL_POINTS, 0, this->NumberOfPoints);
    pass.End();
  }

  vtkMTimeType Source = 0; ///< of the points that are on the GPU

private:
  vtkOpenGLRenderWindow* Window;
  vtkNew<vtkOpenGLBufferObject> Buffer;
  InkShaderPasses Passes;
  int NumberOfPoints = 0;
};

} // namespace

std::unique_ptr<InkMarks> DotsMapper::MakeMarks(vtkOpenGLRenderWindow* window)
{
  return std::make_unique<Dots>(window);
}

bool DotsMapper::UpdateMarks(InkMarks& marks)
{
  auto& dots = static_cast<Dots&>(marks);
  vtkPoints* points = this->GetInput()->GetPoints();
  if (!(this->Diameter > 0.0))
  {
    this->ReportOnce("Expected a positive diameter.");
    return false;
  }
  if (dots.Source != points->GetMTime())
  {
    double bounds[6];
    InkShiftScale::FindFiniteBounds(points, bounds);
    this->Frame = InkShiftScale::FromBounds(bounds);
    dots.Upload(points, this->Frame);
  }
  return true;
}

void DotsMapper::DrawMarks(InkMarks& marks, const InkFrame& frame)
{
  const InkViewUniforms view(frame.Renderer, frame.Actor, this, this->Frame, frame.GetSize());
  static_cast<Dots&>(marks).Draw(view, frame, this->InkColor, this->Diameter);
}
