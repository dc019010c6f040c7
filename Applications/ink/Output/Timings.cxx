// SPDX-License-Identifier: BSD-3-Clause
#include "Timings.h"

#include "InkUploadEvent.h"

#include "vtkTimerLog.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <numeric>

namespace ink::cli
{
namespace
{

/// More than a picture's tiles, layers and passes make.
constexpr int mostEvents = 100'000;

/// What VTK's log of times says of uploads.
double uploadSeconds()
{
  double seconds = 0.0;
  double begin = 0.0;
  for (int i = 0; i < vtkTimerLog::GetNumberOfEvents(); ++i)
  {
    if (std::strcmp(vtkTimerLog::GetEventString(i), InkUploadEvent) != 0)
    {
      continue;
    }
    const double time = vtkTimerLog::GetEventWallTime(i);
    if (vtkTimerLog::GetEventType(i) == vtkTimerLogEntry::START)
    {
      begin = time;
    }
    else
    {
      seconds += time - begin;
    }
  }
  return seconds;
}

} // namespace

Timings::Timings()
  : Begin(vtkTimerLog::GetUniversalTime())
{
  vtkTimerLog::SetMaxEntries(mostEvents);
  vtkTimerLog::ResetLog();
}

void Timings::end(const std::string& step)
{
  const double now = vtkTimerLog::GetUniversalTime();
  this->Steps.emplace_back(step, now - this->Begin);
  this->Begin = now;
}

void Timings::endDrawing()
{
  const double uploading = uploadSeconds();
  this->end("drawing");
  double& drawing = this->Steps.back().second;
  drawing = std::max(drawing - uploading, 0.0);
  this->Steps.insert(this->Steps.end() - 1, { "uploading", uploading });
}

std::string Timings::text() const
{
  const double all = std::accumulate(this->Steps.begin(), this->Steps.end(), 0.0,
    [](double sum, const auto& step) { return sum + step.second; });
  std::string text;
  for (const auto& [step, seconds] : this->Steps)
  {
    char number[64];
    std::snprintf(
      number, sizeof(number), " %.2f s (%.0f %%)", seconds, all > 0.0 ? 100.0 * seconds / all : 0.0);
    text += (text.empty() ? "" : ", ") + step + number;
  }
  return text;
}

} // namespace ink::cli
