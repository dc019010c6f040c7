// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace ink::cli
{

/// Prints a message to the standard error stream, behind "ink: error: " and in one line.
void reportError(std::string message);

/// Something on this machine stands in the way: a file, a folder, the graphics. Ends the program with code 1.
class Failure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The command line asks for something that cannot be. Ends the program with code 2.
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace ink::cli
