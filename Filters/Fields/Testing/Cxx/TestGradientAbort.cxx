// SPDX-License-Identifier: BSD-3-Clause
// Progress is told on the way, and a run that is aborted leaves an empty output and a filter that works.

#include "GradientTestImages.h"
#include "InkTestChecks.h"

#include "vtkCommand.h"
#include "vtkInkGradient.h"
#include "vtkNew.h"

#include <thread>

namespace
{

class Watcher : public vtkCommand
{
public:
  static Watcher* New() { return new Watcher; }
  void Execute(vtkObject* caller, unsigned long, void* amount) override
  {
    this->Shares.push_back(*static_cast<double*>(amount));
    this->SameThread = this->SameThread && std::this_thread::get_id() == this->Thread;
    if (this->Shares.back() > this->AbortAt)
    {
      vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
    }
  }

  std::vector<double> Shares;
  std::thread::id Thread = std::this_thread::get_id();
  bool SameThread = true;
  double AbortAt = 2.0;
};

} // namespace

int TestGradientAbort(int, char*[])
{
  InkTestChecks check;
  vtkNew<vtkInkGradient> filter;
  filter->SetInputData(
    MakeImage(VTK_FLOAT, { 0, 30, 0, 30, 0, 300 }, [](double x, double y, double z) { return x * y + z; }));
  filter->ComputeLaplacianOn();
  vtkNew<Watcher> watcher;
  filter->AddObserver(vtkCommand::ProgressEvent, watcher);
  filter->Update();
  const vtkIdType whole = filter->GetOutput()->GetNumberOfPoints();
  check(whole == 31 * 31 * 301, "all points, found ", whole);
  check(watcher->Shares.size() > 8, "progress on the way, found ", watcher->Shares.size(), " reports");
  check(std::is_sorted(watcher->Shares.begin(), watcher->Shares.end()), "progress that grows");
  check(watcher->Shares.front() >= 0.0 && watcher->Shares.back() == 1.0, "progress up to 1");
  check(watcher->SameThread, "progress from the thread that updates");

  for (const double abortAt : { 0.1, 0.4, 0.6, 0.9 })
  {
    watcher->AbortAt = abortAt;
    filter->Modified();
    filter->Update();
    check(filter->GetOutput()->GetNumberOfPoints() == 0, "an empty output after an abort at ", abortAt);
  }
  watcher->AbortAt = 2.0;
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  check(filter->GetOutput()->GetNumberOfPoints() == whole, "all points again");
  return check.Result();
}
