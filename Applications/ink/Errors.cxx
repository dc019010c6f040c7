// SPDX-License-Identifier: BSD-3-Clause
#include "Errors.h"

#include <algorithm>
#include <iostream>

namespace ink::cli
{

void reportError(std::string message)
{
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "ink: error: " << message << '\n';
}

} // namespace ink::cli
