// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>

namespace ink::io
{

/// Takes the next bytes of a file.
using ByteSink = std::function<void(std::span<const unsigned char>)>;

} // namespace ink::io
