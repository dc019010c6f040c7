// SPDX-License-Identifier: BSD-3-Clause
#ifndef SplattingLinesScene_h
#define SplattingLinesScene_h

#include "InkTestScene.h"
#include "vtkInkSplattingLinesMapper.h"

using SplattingLinesScene = InkTestScene<vtkInkSplattingLinesMapper>;

#endif
