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

  /// The name of an array that says what cells, or the faces of cells, are; empty of others, as of values.
  static std::string_view nameOfCells(vtkXMLDataElement* array)
  {
    vtkXMLDataElement* set = array->GetParent();
    const std::string_view kind = set && set->GetName() ? set->GetName() : "";
    const char* name = array->GetAttribute("Name");
    return name &&
        (kind == "Cells" || kind == "Verts" || kind == "Lines" || kind == "Strips" || kind == "Polys")
      ? name
      : "";
  }

  /// Faults: where an array of cells is too short, VTK 9.2 says so with the name of one of points, which need
  /// not be there; what is aborted says nothing. VTK makes room for as many numbers of points as an offset of
  /// the cells, or of their faces, says, and of faces as the largest number of one, before it looks whether
  /// they are there. -1 is the offset of cells without faces.
  int ReadArrayValues(vtkXMLDataElement* element, vtkIdType arrayIndex, vtkAbstractArray* array,
    vtkIdType start, vtkIdType count, vtkXMLReader::FieldType type) override
  {
    if (!this->Reader::ReadArrayValues(element, arrayIndex, array, start, count, type))
    {
      if (!this->AbortExecute)
      {
        const char* tooShort = element->GetAttribute("Name");
        vtkErrorMacro("its array '" << (tooShort ? tooShort : "") << "' has fewer values than it should");
        this->SetAbortExecute(1);
      }
      return 0;
    }
    const std::string_view name = nameOfCells(element);
    auto* numbers = vtkDataArray::SafeDownCast(array);
    if (!numbers || (!name.ends_with("offsets") && name != "polyhedron_to_faces"))
    {
      return 1;
    }
    const double least = name == "faceoffsets" ? -1.0 : 0.0;
    for (vtkIdType i = arrayIndex; i < arrayIndex + count; ++i)
    {
      const double number = numbers->GetComponent(i, 0);
      if (!(number >= least && number <= this->MostValues))
      {
        vtkErrorMacro("its cells say that they have " << number << (name == "offsets" ? " points" : " faces")
                                                      << ", for which the file is too short");
        return 0;
      }
    }
    return 1;
  }

private:
  double MostValues = 0.0;
};

} // namespace ink::io
