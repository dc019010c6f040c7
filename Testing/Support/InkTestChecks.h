// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTestChecks_h
#define InkTestChecks_h

#include "vtkCommand.h"

#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

/// Counts what fails in a test and says what it was:
///   InkTestChecks check;
///   check(found == 3, "three points, found ", found);
///   return check.Result();
class InkTestChecks
{
public:
  template <typename... Parts>
  bool operator()(bool holds, const Parts&... expectation)
  {
    if (!holds)
    {
      std::ostringstream message;
      (message << ... << expectation);
      std::cerr << "Expected: " << message.str() << std::endl;
      ++this->Failures;
    }
    return holds;
  }

  /// How many expectations have failed so far.
  int Failed() const { return this->Failures; }

  /// What a VTK-style test returns.
  int Result() const { return this->Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

private:
  int Failures = 0;
};

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
  void Expect(InkTestChecks& check, const std::string& name, const std::vector<std::string>& words) const
  {
    if (!check(this->Messages.size() == (words.empty() ? 0 : 1), name, ": one message if any, found ",
          this->Messages.size(), this->Messages.empty() ? "" : ": " + this->Messages[0]))
    {
      return;
    }
    for (const std::string& word : words)
    {
      check(this->Messages[0].find(word) != std::string::npos, name, ": \"", word,
        "\" in the message: ", this->Messages[0]);
    }
  }

  std::vector<std::string> Messages;
};

#endif
