// SPDX-License-Identifier: BSD-3-Clause
// All styles. A new one is added here and in CMakeLists.txt.
#include "vtkInkContoursStyle.h"
#include "vtkInkIllustrationStyle.h"
#include "vtkInkLineArtStyle.h"
#include "vtkInkSplattingLinesStyle.h"
#include "vtkInkStippleStyle.h"

#include <string>

namespace
{

struct Registered
{
  const char* Name;
  vtkInkStyle* (*Create)();
};

/// The first is the default of programs.
constexpr Registered Styles[] = {
  { "illustration", []() -> vtkInkStyle* { return vtkInkIllustrationStyle::New(); } },
  { "contours", []() -> vtkInkStyle* { return vtkInkContoursStyle::New(); } },
  { "line-art", []() -> vtkInkStyle* { return vtkInkLineArtStyle::New(); } },
  { "splatting-lines", []() -> vtkInkStyle* { return vtkInkSplattingLinesStyle::New(); } },
  { "stipple", []() -> vtkInkStyle* { return vtkInkStippleStyle::New(); } },
};

} // namespace

int vtkInkStyle::GetNumberOfStyles()
{
  return static_cast<int>(std::size(Styles));
}

const char* vtkInkStyle::GetStyleName(int style)
{
  return style >= 0 && style < GetNumberOfStyles() ? Styles[style].Name : nullptr;
}

vtkInkStyle* vtkInkStyle::CreateStyle(const char* name)
{
  for (const Registered& style : Styles)
  {
    if (name && std::string(name) == style.Name)
    {
      return style.Create();
    }
  }
  return nullptr;
}
