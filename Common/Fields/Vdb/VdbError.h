// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace ink
{

/// What is wrong with a .vdb file, or with a grid in it, as a clause: "it ends within a leaf's values".
class VdbError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A valid grid that exceeds the memory limit.
class VdbTooLarge : public VdbError
{
public:
  using VdbError::VdbError;
};

} // namespace ink
