// SPDX-License-Identifier: BSD-3-Clause
#include "InkReportException.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"

#include <algorithm>
#include <exception>
#include <new>
#include <stdexcept>

namespace
{

std::string ReasonOf(const std::exception_ptr& exception)
{
  constexpr const char* memory = "there is not enough memory";
  try
  {
    std::rethrow_exception(exception);
  }
  catch (const std::bad_alloc&)
  {
    return memory;
  }
  catch (const std::length_error&)
  {
    // A vector longer than its maximum size.
    return memory;
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  catch (...)
  {
    return "it failed for an unknown reason";
  }
}

} // namespace

void InkReportException(vtkAlgorithm* filter, vtkDataObject* output, const std::string& failure)
{
  const std::string reason = ReasonOf(std::current_exception());
  // The partial output is released first: an error message needs memory, too.
  if (output)
  {
    output->Initialize();
  }
  vtkErrorWithObjectMacro(filter, << failure << ": " << reason << ".");
}

std::string InkTextOfMessage(const char* message)
{
  std::string text = message;
  const std::size_t address = text.find("): ");
  text.erase(0, address == std::string::npos ? 0 : address + 3);
  const std::size_t last = text.find_last_not_of(" \n.");
  text.resize(last == std::string::npos ? 0 : last + 1);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}
