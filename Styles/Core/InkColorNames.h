// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkColorNames_h
#define InkColorNames_h

#include "vtkInkStylesModule.h" // for the export macro

#include <array>
#include <optional>
#include <string>

/// A color by its name as in HTML, or as #rrggbb or #rgb; RGB in 0..1. None where the text is neither.
VTKINKSTYLES_EXPORT std::optional<std::array<double, 3>> InkParseColor(const std::string& text);

#endif
