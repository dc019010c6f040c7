// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "CheckXmlFile.h"
#include "PromptXmlParser.h"
#include "ReadError.h"
#include "VtkMessages.h"

#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLReader.h"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace ink::io
{

/// One of VTK's XML readers for a file that may be broken.
template <typename Reader>
class CheckedXmlReader : public Reader
{
public:
  static CheckedXmlReader* New() { VTK_STANDARD_NEW_BODY(CheckedXmlReader); }

  /// Checks the file, see checkXml, and sets its name. @throws ReadError also if it is none for this reader
  /// @param format what it should be, in a few words
  void open(const std::filesystem::path& file, const std::string& format)
  {
    this->MostValues = checkXml(file);
    if (this->CanReadFile(file.c_str()) == 0)
    {
      failToRead(file, "it is not a " + format);
    }
    this->SetFileName(file.c_str());
  }

  /// Lets it do a part of its work, as Update(). @throws ReadError if VTK complained
  ///
  /// Fault: what VTK makes of a file complains itself, elements of types that are none and points of
  /// coordinates, where nobody can listen.
  void run(const std::function<void()>& part)
  {
    const VtkMessages messages;
    part();
    std::string problem = messages.error();
    if (problem.empty() && this->GetErrorCode() != 0)
    {
      problem = "VTK error " + std::to_string(this->GetErrorCode());
    }
    if (!problem.empty())
    {
      failToRead(this->GetFileName(), problem);
    }
  }

protected:
  CheckedXmlReader() = default;

  void CreateXMLParser() override { this->XMLParser = PromptXmlParser::New(); }

  /// Fault: VTK makes room for as many numbers of points as the last offset of the cells says, before it
  /// looks whether they are there.
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

} // namespace ink::io
