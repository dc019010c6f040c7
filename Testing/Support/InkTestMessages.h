// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTestMessages_h
#define InkTestMessages_h

#include "vtkCommand.h"
#include "vtkObject.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

/// Collects the errors and warnings of a vtkObject in place of VTK's printing them.
class InkTestMessages : public vtkCommand
{
public:
  static InkTestMessages* New() { return new InkTestMessages; }
  void Execute(vtkObject*, unsigned long, void* text) override
  {
    this->Messages.emplace_back(static_cast<const char*>(text));
  }
  void Observe(vtkObject* object)
  {
    object->AddObserver(vtkCommand::ErrorEvent, this);
    object->AddObserver(vtkCommand::WarningEvent, this);
  }

  /// There is one message, with all these words in it; without words, none.
  void Expect(const std::string& name, const std::vector<std::string>& words) const
  {
    ASSERT_EQ(this->Messages.size(), words.empty() ? 0u : 1u)
      << name << ": one message if any" << (this->Messages.empty() ? "" : ", found " + this->Messages[0]);
    for (const std::string& word : words)
    {
      EXPECT_NE(this->Messages[0].find(word), std::string::npos)
        << name << ": \"" << word << "\" in the message: " << this->Messages[0];
    }
  }

  std::vector<std::string> Messages;
};

#endif
