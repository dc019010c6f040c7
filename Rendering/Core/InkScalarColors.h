// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkScalarColors_h
#define InkScalarColors_h

#include "vtkInkRenderingCoreModule.h" // for the export macro

#include <string>

class vtkAbstractArray;
class vtkDataSet;
class vtkMapper;
class vtkUnsignedCharArray;

/// A mapper's colors by scalars: which scalars they are, what makes the colors of them, and the colors, which
/// are mapped only when asked for. Colors are to be sent to the GPU again when their description changes, and
/// not when the mapper or its cached colors are modified, as any property does it.
class VTKINKRENDERINGCORE_EXPORT InkScalarColors
{
public:
  enum class Of
  {
    Points,
    Cells
  };

  /// @param of what the scalars must belong to
  InkScalarColors(vtkMapper* mapper, vtkDataSet* input, Of of);

  /// Whether there are any: the mapper's ScalarVisibility is on and the input has the scalars that it asks
  /// for.
  bool Exist() const { return this->Scalars != nullptr; }

  /// Scalars that are not used because they belong to something else, for the user; empty if there are none.
  const std::string& GetProblem() const { return this->Problem; }

  /// The same text for the same colors; empty if there are none.
  std::string Describe() const;

  /// RGBA for each point or cell; the mapper's, until it maps others. Null if there are none.
  vtkUnsignedCharArray* Map() const;

private:
  vtkMapper* Mapper;
  vtkDataSet* Input;
  vtkAbstractArray* Scalars = nullptr;
  std::string Problem;
};

#endif
