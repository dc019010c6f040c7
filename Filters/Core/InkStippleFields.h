// SPDX-License-Identifier: BSD-3-Clause

// The field data of stipples: what vtkInkStippleGenerator says about all of them, and who draws them reads.
#ifndef InkStippleFields_h
#define InkStippleFields_h

#include "vtkInkFiltersCoreModule.h" // for the export macro

#include <span>

class vtkPolyData;

constexpr const char* InkElementKindName = "ElementKind";
constexpr const char* InkElementSizeName = "ElementSize";
constexpr const char* InkStipplesPerElementName = "StipplesPerElement";

/// What the elements are, as ElementKind has it.
enum class InkElementKind
{
  Volume = 0,
  Surface = 1
};

/// Adds a field array of numbers.
VTKINKFILTERSCORE_EXPORT void InkAddField(
  vtkPolyData* output, const char* name, std::span<const double> values);

/// Adds those that all stipples have. @param size in world units @param perElement stipples of an element
VTKINKFILTERSCORE_EXPORT void InkAddStippleFields(
  vtkPolyData* output, InkElementKind kind, double size, double perElement);

#endif
