// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkInkIOCoreModule.h" // for the export macro

#include "vtkXMLDataParser.h"

namespace ink::io
{

/// A parser that reads a file's tags at once.
///
/// Fault: since expat 2.6 (and in distributions' patched versions of earlier ones), expat waits for more data
/// after a tag that came in parts, and VTK before 9.4, which stops at the tag <AppendedData>, then misses it:
/// files as VTK writes them by default could not be read.
class VTKINKIOCORE_EXPORT PromptXmlParser : public vtkXMLDataParser
{
public:
  static PromptXmlParser* New();
  vtkTypeMacro(PromptXmlParser, vtkXMLDataParser);

  /// Where appended data begins in the file, after its underscore; 0 or less if there is none.
  vtkTypeInt64 appendedBegin() const { return this->AppendedDataPosition; }
  /// Whether that is base64, which takes no other form but text.
  bool appendedIsText();

protected:
  PromptXmlParser() = default;

  int ParseBuffer(const char* buffer, unsigned int count) override;
};

} // namespace ink::io
