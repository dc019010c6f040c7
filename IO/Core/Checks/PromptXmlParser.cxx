// SPDX-License-Identifier: BSD-3-Clause
#include "PromptXmlParser.h"

#include "vtkObjectFactory.h"
#include "vtkXMLDataElement.h"

#include <string_view>

#ifdef INK_EXPAT_DEFERS
#  include "vtk_expat.h"
#endif

namespace ink::io
{

vtkStandardNewMacro(PromptXmlParser);

bool PromptXmlParser::appendedIsText()
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

int PromptXmlParser::ParseBuffer(const char* buffer, unsigned int count)
{
#ifdef INK_EXPAT_DEFERS
  XML_SetReparseDeferralEnabled(static_cast<XML_Parser>(this->Parser), XML_FALSE);
#endif
  return this->Superclass::ParseBuffer(buffer, count);
}

} // namespace ink::io
