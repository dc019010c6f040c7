// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include "Core/Progress.h"

namespace ink::io
{

/// Lets a reader of VTK's report to a function while this object lives, and stops it where that asks for it.
class ReaderProgress
{
public:
  ReaderProgress(vtkAlgorithm* reader, const Progress& progress)
    : Reader(reader)
    , Report(progress)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject* caller, unsigned long, void* self, void*)
      { static_cast<ReaderProgress*>(self)->report(static_cast<vtkAlgorithm*>(caller)); });
    reader->AddObserver(vtkCommand::ProgressEvent, this->Command);
    reader->SetAbortExecute(0);
  }
  ~ReaderProgress() { this->Reader->RemoveObserver(this->Command); }
  ReaderProgress(const ReaderProgress&) = delete;
  ReaderProgress& operator=(const ReaderProgress&) = delete;

  bool aborted() const { return this->Aborted; }

private:
  void report(vtkAlgorithm* reader)
  {
    if (this->Report && !this->Report(reader->GetProgress()))
    {
      this->Aborted = true;
      reader->SetAbortExecute(1);
    }
  }

  vtkAlgorithm* Reader;
  const Progress& Report;
  bool Aborted = false;
  vtkNew<vtkCallbackCommand> Command;
};

} // namespace ink::io
