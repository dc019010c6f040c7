// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTestProgress_h
#define InkTestProgress_h

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <vector>

/// Hears of a filter's progress, and asks it to stop beyond a share of it.
class InkTestProgress : public vtkCommand
{
public:
  static InkTestProgress* New() { return new InkTestProgress; }
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
  double AbortAt = 2.0; ///< more than there is: never
};

/// Runs a filter whose input makes long work of it: progress is told on the way, and a run that is aborted
/// leaves an empty output and a filter that works.
template <class Filter>
void InkTestProgressAndAbort(Filter* filter)
{
  vtkNew<InkTestProgress> progress;
  filter->AddObserver(vtkCommand::ProgressEvent, progress);
  filter->Update();
  const vtkIdType whole = filter->GetOutput()->GetNumberOfPoints();
  EXPECT_GT(whole, 10000) << "many points, found " << whole;
  EXPECT_GT(progress->Shares.size(), 8)
    << "progress on the way, found " << progress->Shares.size() << " reports";
  EXPECT_TRUE(std::is_sorted(progress->Shares.begin(), progress->Shares.end())) << "progress that grows";
  EXPECT_TRUE(!progress->Shares.empty() && progress->Shares.front() >= 0.0 && progress->Shares.back() == 1.0)
    << "progress up to 1";
  EXPECT_TRUE(progress->SameThread) << "progress from the thread that updates";

  for (const double abortAt : { 0.1, 0.4, 0.6, 0.9 })
  {
    progress->AbortAt = abortAt;
    filter->Modified();
    filter->Update();
    EXPECT_TRUE(filter->GetOutput()->GetNumberOfPoints() == 0 && filter->GetOutput()->GetNumberOfCells() == 0)
      << "an empty output after an abort at " << abortAt;
  }
  progress->AbortAt = 2.0;
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), whole) << "all points again";
}

#endif
