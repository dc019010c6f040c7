#pragma once

#include <array>
#include <string>

namespace ink::cli
{

/// Red, green and blue, 0 to 1.
using Color = std::array<double, 3>;

/// A color from its name in HTML ("black", "navy") or "#rrggbb" or "#rgb".
/// \param option that the text was given to, for messages.
/// \throw UsageError
Color parseColor(const std::string& option, const std::string& text);

} // namespace ink::cli
