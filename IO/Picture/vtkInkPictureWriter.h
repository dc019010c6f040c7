// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkPictureWriter
 * @brief   writes a picture with its resolution, as PNG, JPEG or TIFF
 *
 * The input is image data of one slice, whose scalars are bytes: red, green and blue, or with alpha, which
 * JPEG cannot hold. The first row is the lowest one. The format is that of the file's name: .png, .jpg,
 * .jpeg, .tif or .tiff. JPEG is of high quality without subsampled colors, TIFF compressed without loss.
 *
 * Errors, with an error code: no such format, an input that is no such picture, a file that cannot be
 * written.
 */
#ifndef vtkInkPictureWriter_h
#define vtkInkPictureWriter_h

#include "vtkAlgorithm.h"
#include "vtkInkIOPictureModule.h" // for the export macro

#include <string> // for names' ends

class VTKINKIOPICTURE_EXPORT vtkInkPictureWriter : public vtkAlgorithm
{
public:
  static vtkInkPictureWriter* New();
  vtkTypeMacro(vtkInkPictureWriter, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The picture. Default: none.
  void SetInputData(vtkDataObject* image);

  /// Writes it. False, after one error, if it could not be written.
  bool Write();

  ///@{
  /**
   * The file to write. Default: none, which is an error.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * How many pixels an inch of the printed picture has. 1 to 30000; default: 300.
   */
  void SetDotsPerInch(double dots);
  vtkGetMacro(DotsPerInch, double);
  ///@}

  /**
   * The ends of the names of files that can be written, as ".png, .jpg or .tif".
   */
  static std::string GetFileExtensions();

  /**
   * Whether a file's name ends in one of them, and whether such a file can hold alpha.
   */
  static bool CanWriteFile(VTK_FILEPATH const char* fileName);
  static bool CanWriteAlpha(VTK_FILEPATH const char* fileName);

protected:
  vtkInkPictureWriter();
  ~vtkInkPictureWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkInkPictureWriter(const vtkInkPictureWriter&) = delete;
  void operator=(const vtkInkPictureWriter&) = delete;

  bool Fail(unsigned long code, const std::string& problem);

  char* FileName = nullptr;
  double DotsPerInch = 300.0;
};

#endif
