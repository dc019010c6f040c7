// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkNIFTIImageReader
 * @brief   vtkNIFTIImageReader, with the range of the values found on all threads
 *
 * ParaView asks each array that it reads for its range, which many builds of VTK then look for on one thread:
 * of a head CT of 512 x 512 x 432 for longer than all else takes up to its first picture. For ParaView, whose
 * own filters leave out directions, so that images that have them, as those of vtkInkVolumeReader, do not lie
 * where their contours are.
 */
#ifndef vtkInkNIFTIImageReader_h
#define vtkInkNIFTIImageReader_h

#include "vtkInkIOVolumeModule.h" // for the export macro
#include "vtkNIFTIImageReader.h"

class VTKINKIOVOLUME_EXPORT vtkInkNIFTIImageReader : public vtkNIFTIImageReader
{
public:
  static vtkInkNIFTIImageReader* New();
  vtkTypeMacro(vtkInkNIFTIImageReader, vtkNIFTIImageReader);

protected:
  vtkInkNIFTIImageReader() = default;
  ~vtkInkNIFTIImageReader() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkNIFTIImageReader(const vtkInkNIFTIImageReader&) = delete;
  void operator=(const vtkInkNIFTIImageReader&) = delete;
};

#endif
