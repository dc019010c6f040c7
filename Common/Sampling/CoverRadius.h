#pragma once

namespace ink
{

/// How large discs around samples must be to leave no holes. Zhang et al. 2014 (section 4) give A / n, which
/// has the unit of an area; a length in its place is in proportion to sqrt(A / n).

/// For blue noise of a radius and gap: no place of the surface is farther from a sample, see sampleBlueNoise.
double blueNoiseCover(double radius, double gap);

/// For `count` blue-noise samples on an area of which no more than a tenth of a saturated set was left out,
/// the most crowded first.
double blueNoiseCover(double area, double count, double gap);

/// For `count` samples of sampleProgressively: their radius, and as far again as no candidate may have
/// fallen. Candidates are independent, so that a gap of an area has none with a probability that falls
/// exponentially with it, as the holes of whiteNoiseCover; how the area grows with the gap is measured, so
/// that again one in a hundred samplings has a hole.
double progressiveCover(double area, double count, double candidates);

/// For `count` independent samples, evenly on an area. Discs that cover x times the area between them leave
/// holes, n x exp(-x) in the mean (Hall 1988, section 3.2); x is chosen so that this is one in a hundred.
double whiteNoiseCover(double area, double count);

} // namespace ink
