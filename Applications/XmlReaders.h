#pragma once

#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"
#include "vtkXMLReader.h"

#include <string_view>

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

  /// Where appended data begins in the file, after its underscore; 0 or less if there is none.
  vtkTypeInt64 appendedBegin() const { return this->AppendedDataPosition; }
  /// Whether that is base64, which takes no other form but text.
  bool appendedIsText()
  {
    const char* encoding = nullptr;
    for (int i = 0; i < this->GetRootElement()->GetNumberOfNestedElements(); ++i)
    {
      vtkXMLDataElement* element = this->GetRootElement()->GetNestedElement(i);
      if (std::string_view(element->GetName()) == "AppendedData")
      {
        encoding = element->GetAttribute("encoding");
      }
    }
    return !encoding || std::string_view(encoding) != "raw";
  }

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

  /// How many values an array can have: where cells say that they have more points, nothing is read.
  void SetMostValues(double most) { this->MostValues = most; }

protected:
  void CreateXMLParser() override { this->XMLParser = PromptXmlParser::New(); }

  /// VTK makes room for as many numbers of points as the last offset says, before it looks whether they are
  /// there.
  int ReadArrayValues(vtkXMLDataElement* element, vtkIdType arrayIndex, vtkAbstractArray* array,
    vtkIdType start, vtkIdType count, vtkXMLReader::FieldType type) override
  {
    if (!this->Reader::ReadArrayValues(element, arrayIndex, array, start, count, type))
    {
      return 0;
    }
    const char* name = element->GetAttribute("Name");
    auto* offsets = vtkDataArray::SafeDownCast(array);
    if (name && std::string_view(name) == "offsets" && offsets && count > 0 &&
      !(offsets->GetComponent(arrayIndex + count - 1, 0) <= this->MostValues))
    {
      vtkErrorMacro("its cells say that they have " << offsets->GetComponent(arrayIndex + count - 1, 0)
                                                    << " points, for which the file is too short");
      return 0;
    }
    return 1;
  }

private:
  double MostValues = 0.0;
};

} // namespace ink::cli
