// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkVolumeReader
 * @brief   a volume of any format as image data of one component, checked and in parts
 *
 * Reads NIfTI (.nii, .nii.gz, pairs of .hdr and .img, also of Analyze 7.5, by either name), NRRD (.nrrd,
 * .nhdr), MetaImage (.mha, .mhd), MRC and CCP4 maps (.mrc, .map, .ccp4, each also with .gz), FreeSurfer
 * volumes (.mgh, .mgz), NumPy's arrays (.npy), VolVis' volumes (.slc), Gaussian's cubes (.cube), VTK XML
 * images (.vti), structured points of legacy VTK files (.vtk), rectilinear and structured grids of either
 * (.vtr, .vts, .vtk), which become images, TIFF stacks (.tif, .tiff, with what ImageJ and OME write into them
 * about distances, channels and times), a folder of TIFF files, each of which is a slice, a folder of DICOM
 * files, which becomes the series in it that has most slices, one DICOM file (.dcm, or any name), which is a
 * volume by itself or stands for the slices of its series in its folder, files of voxels alone whose names
 * say what is in them (skull_256x256x256_uint8.raw, also .raw.gz), and with Raw any file
 * without a header. Which format it is the file's name tells.
 *
 * The output has one point array of one component: the first of voxels that have several, in the type of the
 * file, or, where the file says that its values are to be rescaled, in short or int if all have room and else
 * in float. Origin and direction matrix are those of the file, turned to DICOM's axes (+x to the left of the
 * patient, +y to the back, +z to the head). Values that a file has in its cells alone are those of voxels in
 * the cells' centers. What of a file was not used as it is, say the notes.
 *
 * It differs from VTK's readers in this: whatever is in the file, it is read whole or refused in one error
 * that says what was found and what was expected, and a header is believed only as far as there are bytes for
 * what it promises. Parts of the image (update extents) are read without the rest, so that a filter which
 * streams needs no room for all of it; of compressed files what stands before a part is unpacked, but not
 * kept; all of a grid is read for its extent, by UpdateInformation().
 *
 * Errors, each with an empty output: no such file, none of these formats, one that is damaged or ends too
 * soon, and too little memory.
 *
 * @sa vtkInkVDBReader vtkInkMeshReader
 */
#ifndef vtkInkVolumeReader_h
#define vtkInkVolumeReader_h

#include "InkSetters.h"
#include "vtkImageAlgorithm.h"
#include "vtkInkIOVolumeModule.h" // for the export macro

#include <functional> // for progress
#include <memory>     // for what the file says

class VTKINKIOVOLUME_EXPORT vtkInkVolumeReader : public vtkImageAlgorithm
{
public:
  static vtkInkVolumeReader* New();
  vtkTypeMacro(vtkInkVolumeReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read, or a folder of DICOM or TIFF files. Default: none, which is an error.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Whether a file, or a folder, is one of these formats and its header can be read.
   */
  int CanReadFile(VTK_FILEPATH const char* fileName);

  /**
   * The ends of the names of files that are read, separated by spaces.
   */
  static const char* GetFileExtensions();

  /**
   * Whether a file, whatever its name, is a DICOM file.
   */
  static bool IsDicomFile(VTK_FILEPATH const char* fileName);

  ///@{
  /**
   * The distances between voxels along x, y and z, in world units, in place of those that the file says; of
   * negative ones the amount is taken, 0 leaves the file's, which of one without a header, or that does not
   * say, are 1. Numbers that are not finite are refused with a warning. Default: (0, 0, 0).
   */
  InkSetPointMacro(Spacing);
  vtkGetVector3Macro(Spacing, double);
  ///@}

  ///@{
  /**
   * The file has no header: the properties that begin with Raw say how its voxels lie, x fastest, and it has
   * to have exactly as many bytes, or, compressed with gzip, at least as many. Default: off.
   */
  vtkSetMacro(Raw, bool);
  vtkGetMacro(Raw, bool);
  vtkBooleanMacro(Raw, bool);
  ///@}

  ///@{
  /**
   * The number of voxels along x, y and z of a raw file, each 1 or more. Default: (1, 1, 1).
   */
  vtkSetVector3Macro(RawDimensions, int);
  vtkGetVector3Macro(RawDimensions, int);
  ///@}

  ///@{
  /**
   * The type of the voxels of a raw file: VTK_UNSIGNED_CHAR, VTK_SHORT, ... VTK_DOUBLE. Others, as bits and
   * strings, are an error. Default: VTK_UNSIGNED_CHAR.
   */
  vtkSetMacro(RawScalarType, int);
  vtkGetMacro(RawScalarType, int);
  ///@}

  ///@{
  /**
   * The values of a raw file begin with their most significant byte. Default: off.
   */
  vtkSetMacro(RawBigEndian, bool);
  vtkGetMacro(RawBigEndian, bool);
  vtkBooleanMacro(RawBigEndian, bool);
  ///@}

  ///@{
  /**
   * The range of the values is found as well, on all threads, for whoever asks the array for it: ParaView
   * does so of whatever it reads, on one thread. Default: off.
   */
  vtkSetMacro(FindRange, bool);
  vtkGetMacro(FindRange, bool);
  vtkBooleanMacro(FindRange, bool);
  ///@}

  /**
   * The file's format in a few words, as "NIfTI volume", after UpdateInformation().
   */
  const char* GetFormat();

  /**
   * How many components the file's voxels have, after UpdateInformation(), or, of .vti, after Update().
   */
  int GetNumberOfFileComponents();

  /**
   * How many bytes the values take that are read from the file, or that a grid's image has, after
   * UpdateInformation(); 0 if it does not say. Rescaling makes a second array of them.
   */
  vtkTypeInt64 GetMemorySize();

  ///@{
  /**
   * What of the file is not used as it is, each a sentence without its dot, after UpdateInformation(), or, of
   * .vti, after Update(). Null for an index that does not exist.
   */
  int GetNumberOfNotes();
  const char* GetNote(int index);
  ///@}

  /**
   * Whether voxels are stored as the output has them, after UpdateInformation(): not compressed, as text,
   * rescaled, or as XML. A part of them is read without the rest, as fast from anywhere.
   */
  bool HasPlainVoxels();

protected:
  vtkInkVolumeReader();
  ~vtkInkVolumeReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkVolumeReader(const vtkInkVolumeReader&) = delete;
  void operator=(const vtkInkVolumeReader&) = delete;

  struct Source;

  void Respace(double spacing[3]) const;
  std::function<bool(double done)> MakeProgress();

  char* FileName = nullptr;
  double Spacing[3] = { 0.0, 0.0, 0.0 };
  bool Raw = false;
  int RawDimensions[3] = { 1, 1, 1 };
  int RawScalarType = VTK_UNSIGNED_CHAR;
  bool RawBigEndian = false;
  bool FindRange = false;
  /// What UpdateInformation found; null if that failed, which then was said.
  std::unique_ptr<Source> Found;
};

#endif
