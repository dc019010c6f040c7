// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkChosenScalars_h
#define InkChosenScalars_h

#include <string>

/// The array that a panel's choice of scalars names; empty: the active one. @param name or null
inline std::string InkChosenScalars(const char* name)
{
  const std::string chosen = name ? name : "";
  return chosen == "Active Scalars" ? std::string() : chosen;
}

#endif
