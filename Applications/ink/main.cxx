// SPDX-License-Identifier: BSD-3-Clause
// ink: pen-and-ink pictures of volumes and meshes from the command line.

#include "CommandLine.h"
#include "Errors.h"
#include "ParseErrors.h"

#include "vtkLogger.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <string>

namespace
{

using namespace ink::cli;

enum ExitCode
{
  Success = 0,
  Failed = 1,
  WrongUsage = 2
};

int report(ExitCode code, const std::string& message)
{
  reportError(message);
  return code;
}

int run(int argc, char* argv[])
{
  const bool all = std::find(argv, argv + argc, std::string("--help-all")) != argv + argc;
  CommandLine commandLine(StyleArguments::findStyle(argc, argv), all);
  try
  {
    commandLine.app().parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() != 0)
    {
      return report(WrongUsage, describe(error, commandLine.app()));
    }
    // Asking for help is one of these as well.
    commandLine.hideUnlisted();
    return commandLine.app().exit(error);
  }
  commandLine.run();
  return std::cout.flush() ? Success : report(Failed, "cannot write to the standard output stream");
}

int runReportingErrors(int argc, char* argv[])
{
  // What VTK logs about its choice of a window, say, is not for the users of ink.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  try
  {
    return run(argc, argv);
  }
  catch (const UsageError& error)
  {
    return report(WrongUsage, error.what());
  }
  catch (const std::bad_alloc&)
  {
    return report(Failed, "there is not enough memory");
  }
  catch (const std::exception& error)
  {
    return report(Failed, error.what());
  }
}

} // namespace

int main(int argc, char* argv[])
{
  const int code = runReportingErrors(argc, argv);
  // All is written and closed. Without libraries' clean-up: VTK's pool of threads (vtkSMPThreadPool, up
  // to 9.7 at least) wakes a thread that has not yet begun to wait, which is lost, and joins it for ever.
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
  std::_Exit(code);
}
