// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkReportedMessages_h
#define InkReportedMessages_h

#include "vtkType.h"

#include <set>
#include <string>

/// The messages about an input that were reported: a mapper meets the same problem in every picture, and says
/// it once until the input changes.
class InkReportedMessages
{
public:
  /// Whether the message is to be reported now.
  /// @param inputTime the input's modification time
  bool Add(vtkMTimeType inputTime, const std::string& message)
  {
    if (this->InputTime != inputTime)
    {
      this->InputTime = inputTime;
      this->Messages.clear();
    }
    return this->Messages.insert(message).second;
  }

private:
  vtkMTimeType InputTime = 0;
  std::set<std::string> Messages;
};

#endif
