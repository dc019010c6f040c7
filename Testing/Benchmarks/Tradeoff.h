// SPDX-License-Identifier: BSD-3-Clause
// A knob that trades accuracy for speed, measured at each of its settings. A program Tradeoff*.cxx defines
// its knobs, adds what each setting runs and how wrong it is, and prints rows of CSV, which
// Testing/Benchmarks/tradeoff.py turns into Documentation/accuracy-and-speed.md:
//
//   Tradeoff knob("Gradient method", "Keep the default; ...", "mean angle to the true gradient, degrees");
//   knob.Add("central difference", [&] { ... what is timed ... }, { { "no noise", 0.1 }, { "5% noise", 13.0 }
//   }); knob.Add("regression 3x3x3", ..., Tradeoff::Default); knob.Print();
#ifndef Tradeoff_h
#define Tradeoff_h

#include "ProcessorTime.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

class Tradeoff
{
public:
  /// The errors of a setting, one a scene. Every setting of a knob has the same scenes.
  using Errors = std::vector<std::pair<std::string, double>>;
  enum Role
  {
    Choice,
    Default
  };

  /// @param name      of the knob, as the documentation calls it
  /// @param advice    one sentence: which setting for whom
  /// @param errorUnit what the errors are, and in which unit
  /// @param work      what is timed, on which data
  Tradeoff(std::string name, std::string advice, std::string errorUnit, std::string work)
    : Name(std::move(name))
    , Advice(std::move(advice))
    , ErrorUnit(std::move(errorUnit))
    , Work(std::move(work))
  {
  }

  /// Adds a setting. One of a knob's settings is the Default.
  void Add(std::string setting, std::function<void()> run, Errors errors, Role role = Choice)
  {
    this->Settings.push_back({ std::move(setting), std::move(run), std::move(errors), role, {} });
  }

  /// Times all settings in turns, on one thread, and prints a row for each setting and scene. The time is the
  /// least of processor time, which other programs on the machine disturb the least.
  void Print(int repetitions = 9)
  {
    setenv("VTK_SMP_MAX_THREADS", "1", 1);
    // The first turn warms up: memory and caches.
    for (int turn = 0; turn <= repetitions; ++turn)
    {
      for (Setting& setting : this->Settings)
      {
        const double begin = ProcessorTime();
        setting.Run();
        const double milliseconds = ProcessorTime() - begin;
        if (turn > 0)
        {
          setting.Times.push_back(milliseconds);
        }
      }
    }
    for (const Setting& setting : this->Settings)
    {
      for (const auto& [scene, error] : setting.Errors)
      {
        std::cout << Quoted(this->Name) << ',' << Quoted(this->Advice) << ',' << Quoted(this->ErrorUnit)
                  << ',' << Quoted(this->Work) << ',' << Quoted(setting.Name) << ','
                  << (setting.Role == Default ? "yes" : "no") << ',' << Quoted(scene) << ',' << error << ','
                  << *std::min_element(setting.Times.begin(), setting.Times.end()) << std::endl;
      }
    }
  }

  /// The first line of the output.
  static void PrintHeader() { std::cout << "knob,advice,error_unit,work,setting,default,scene,error,ms\n"; }

private:
  struct Setting
  {
    std::string Name;
    std::function<void()> Run;
    Tradeoff::Errors Errors;
    Tradeoff::Role Role;
    std::vector<double> Times;
  };

  static std::string Quoted(const std::string& text)
  {
    std::string quoted = "\"";
    for (const char c : text)
    {
      quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + '"';
  }

  std::string Name;
  std::string Advice;
  std::string ErrorUnit;
  std::string Work;
  std::vector<Setting> Settings;
};

#endif
