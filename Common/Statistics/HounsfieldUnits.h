// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink
{

struct IsoStatistics;

/// Whether values are Hounsfield units: air and soft tissue are where they are in CT, with little between
/// them, and nothing is below air but padding.
bool areHounsfieldUnits(const IsoStatistics& statistics);

} // namespace ink
