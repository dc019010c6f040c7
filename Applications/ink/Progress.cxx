// SPDX-License-Identifier: BSD-3-Clause
#include "Progress.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <cstdio>
#include <unistd.h>

namespace ink::cli
{

Progress::Progress(bool quiet)
  : Visible(!quiet && isatty(STDERR_FILENO) == 1)
{
}

Progress::~Progress()
{
  this->finish();
}

void Progress::step(const std::string& name)
{
  if (this->Visible)
  {
    this->Name = name;
    this->Percent = -1;
    this->Begin = 0.0;
    this->End = 1.0;
    std::fprintf(stderr, "\r\x1b[K%s", name.c_str());
    std::fflush(stderr);
  }
}

void Progress::step(const std::string& name, vtkAlgorithm* algorithm)
{
  this->step(name);
  if (this->Visible)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject* caller, unsigned long, void* self, void*)
      { static_cast<Progress*>(self)->show(static_cast<vtkAlgorithm*>(caller)->GetProgress()); });
    algorithm->AddObserver(vtkCommand::ProgressEvent, command);
  }
}

void Progress::finish()
{
  if (this->Visible && !this->Name.empty())
  {
    this->Name.clear();
    std::fputs("\r\x1b[K", stderr);
    std::fflush(stderr);
  }
}

void Progress::part(double begin, double end)
{
  this->Begin = begin;
  this->End = end;
  this->show(0.0);
}

void Progress::at(double done)
{
  this->show(done);
}

std::function<void(double)> Progress::watcher()
{
  return this->Visible ? [this](double done) { this->show(done); } : std::function<void(double)>();
}

void Progress::show(double done)
{
  const int percent = static_cast<int>(100 * (this->Begin + done * (this->End - this->Begin)));
  if (this->Visible && percent != this->Percent)
  {
    this->Percent = percent;
    std::fprintf(stderr, "\r\x1b[K%s %d %%", this->Name.c_str(), percent);
    std::fflush(stderr);
  }
}

} // namespace ink::cli
