// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ink
{

/// Covering radii: how large discs around samples must be to leave no holes. Zhang et al. (2014, section 4)
/// give A / n, which has the unit of an area; a length must be proportional to sqrt(A / n).

/// For Poisson-disk samples of a radius and coverage slack: no position is farther from a sample, see
/// samplePoissonDisk.
double poissonDiskCover(double radius, double slack);

/// For `count` blue-noise samples on an area: a saturated set from which at most a tenth was removed, the
/// most crowded first.
double poissonDiskCover(double area, double count, double slack);

/// For `count` samples of sampleProgressively: their radius plus the width of the largest void without
/// candidates. Candidates are independent, so that the probability of a void falls exponentially with its
/// area, as in whiteNoiseCover; the area as a function of the width was measured, so that again one in a
/// hundred samplings has a hole.
double progressiveCover(double area, double count, double candidates);

/// For `count` independent, uniform samples on an area. Discs whose areas sum to x times that area leave n x
/// exp(-x) holes on average (Hall 1988, section 3.2); x is chosen so that this is one in a hundred.
double whiteNoiseCover(double area, double count);

} // namespace ink
