// SPDX-License-Identifier: BSD-3-Clause
/**
 * The images of several processes, put together.
 */
#ifndef vtkInkGatherImages_h
#define vtkInkGatherImages_h

#include "InkStyleProcesses.h" // for the images

class vtkMultiProcessController;

/**
 * All processes' images, which have active scalars, with these for the first process, which needs memory for
 * them; none for the others. Where each process has one image at most and these cover the box around them,
 * each cell once, they are parts of one image, and it is put together. To be called by all processes at once,
 * also without images.
 */
InkWholeImages vtkInkGatherImages(const InkWholeImages& images, vtkMultiProcessController* controller);

#endif
