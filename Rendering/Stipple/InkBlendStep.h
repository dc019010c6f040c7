// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkBlendStep_h
#define InkBlendStep_h

/// The smallest part of full brightness by which blending changes a pixel near white of what OpenGL draws
/// into now: 1/255 with 8 bits, as in windows and under depth peeling; 0 where it is too small to matter.
float InkFindBlendStep();

#endif
