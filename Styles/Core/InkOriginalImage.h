// SPDX-License-Identifier: BSD-3-Clause
/**
 * What an image was made of that was enlarged, by repeating samples or by interpolating slices
 * (InkOriginalSamples.h), also where each process has a part of it. It is found again only where the image
 * or what is looked for has changed.
 */
#ifndef InkOriginalImage_h
#define InkOriginalImage_h

#include "vtkSmartPointer.h"
#include "vtkType.h" // for vtkMTimeType
#include "vtkWeakPointer.h"

#include <string>

class InkStyleProcesses;
class vtkDataObject;
class vtkImageData;
class vtkTrivialProducer;

class InkOriginalImage
{
public:
  struct Search
  {
    std::string Array; ///< whose values are looked at; empty: the active scalars, or else the first
    bool Repeats = false;
    bool Slices = false;
    bool operator==(const Search&) const = default;
  };

  /// Looks for it in the image, or in what all processes' parts make, for which the first process needs
  /// memory. All call it at once, also without data.
  /// @return whether data is such an image; false for all other data
  bool Find(InkStyleProcesses& processes, vtkDataObject* data, const Search& search);

  /// Of what was found, all of it on the first process, and an empty image on the others.
  vtkTrivialProducer* GetSource() const { return this->Source; }
  /// That something else is drawn than was given, and how to have that drawn.
  const std::string& GetNote() const { return this->Note; }

private:
  bool IsKnown(vtkImageData* image, const Search& search) const;

  vtkWeakPointer<vtkImageData> Image; ///< looked at last, as are the next two
  vtkMTimeType Time = 0;
  Search Looked;
  vtkSmartPointer<vtkTrivialProducer> Source; ///< null: the image was not enlarged
  std::string Note;
};

#endif
