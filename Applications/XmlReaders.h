#pragma once

#include "vtkObjectFactory.h"
#include "vtkXMLDataParser.h"

#ifdef INK_EXPAT_DEFERS
#  include "vtk_expat.h"
#endif

namespace ink::cli
{

/// A parser that reads a file's tags at once. Since expat 2.6 (and in distributions' patched versions of
/// earlier ones), expat waits for more data after a tag that came in parts, and VTK before 9.4, which stops
/// at the tag <AppendedData>, then misses it: files as VTK writes them by default could not be read.
class PromptXmlParser : public vtkXMLDataParser
{
public:
  static PromptXmlParser* New() { VTK_STANDARD_NEW_BODY(PromptXmlParser); }
  vtkTypeMacro(PromptXmlParser, vtkXMLDataParser);

protected:
  PromptXmlParser() = default;

  int ParseBuffer(const char* buffer, unsigned int count) override
  {
#ifdef INK_EXPAT_DEFERS
    XML_SetReparseDeferralEnabled(static_cast<XML_Parser>(this->Parser), XML_FALSE);
#endif
    return this->Superclass::ParseBuffer(buffer, count);
  }
};

/// One of VTK's XML readers, with this parser.
template <typename Reader>
class PromptXmlReader : public Reader
{
public:
  static PromptXmlReader* New() { VTK_STANDARD_NEW_BODY(PromptXmlReader); }

protected:
  void CreateXMLParser() override { this->XMLParser = PromptXmlParser::New(); }
};

} // namespace ink::cli
