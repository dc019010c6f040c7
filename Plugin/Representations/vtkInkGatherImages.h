// SPDX-License-Identifier: BSD-3-Clause
/**
 * The images of several processes, put together.
 */
#ifndef vtkInkGatherImages_h
#define vtkInkGatherImages_h

#include "InkStyleProcesses.h" // for the images

#include <string>

class vtkMultiProcessController;

/**
 * All processes' images with one of their point arrays, as the active scalars or under its name, for the
 * first process, which needs memory for them; none for the others. Where each process has one image at most
 * and these cover the box around them, each cell once, they are parts of one image, and it is put together.
 * To be called by all processes at once, also without images.
 * @param array the name of an array that all images have; empty: the active scalars, whatever their name
 */
InkWholeImages vtkInkGatherImages(
  const InkWholeImages& images, const std::string& array, vtkMultiProcessController* controller);

#endif
