// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTestBaseline_h
#define InkTestBaseline_h

#include "InkTestImage.h"

#include <string>

/// Whether a picture is like Testing/Baselines/NAME.png. If it is not, or if there is no such file, writes
/// the picture and the difference beside the build and prints their paths.
/// @param tolerance on vtkImageDifference's thresholded error: the sum over all pixels of how much further
///   than 16/255 they differ, in units of a full channel, in the best of the shifts by a pixel
bool InkTestMatchesBaseline(const InkTestImage& image, const std::string& name, double tolerance);

#endif
