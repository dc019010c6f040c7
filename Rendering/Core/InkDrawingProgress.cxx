// SPDX-License-Identifier: BSD-3-Clause
#include "InkDrawingProgress.h"

#include "InkOpenGLCompat.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"

InkDrawingProgress::InkDrawingProgress(vtkAlgorithm* mapper, double end)
  : Mapper(mapper)
  , WholeEnd(end)
  , Watched(mapper->HasObserver(vtkCommand::ProgressEvent) != 0)
{
}

void InkDrawingProgress::Until(double part)
{
  this->Begin = this->End;
  this->End = this->WholeEnd * part;
}

void InkDrawingProgress::Report(double share)
{
  if (this->Watched)
  {
    glFinish();
    this->Mapper->UpdateProgress(this->Begin + share * (this->End - this->Begin));
  }
}

InkProgressPart::InkProgressPart(vtkAlgorithm* whole, vtkAlgorithm* part, double begin, double end)
  : Whole(whole)
  , Part(part)
  , Begin(begin)
  , End(end)
{
  if (!whole->HasObserver(vtkCommand::ProgressEvent))
  {
    return;
  }
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*)
    {
      auto* self = static_cast<InkProgressPart*>(client);
      self->Whole->UpdateProgress(self->Begin + self->Part->GetProgress() * (self->End - self->Begin));
    });
  this->Observer = part->AddObserver(vtkCommand::ProgressEvent, command);
}

InkProgressPart::~InkProgressPart()
{
  if (this->Observer != 0)
  {
    this->Part->RemoveObserver(this->Observer);
  }
}
