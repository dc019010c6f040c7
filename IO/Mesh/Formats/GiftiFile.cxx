// SPDX-License-Identifier: BSD-3-Clause
#include "GiftiFile.h"

#include "ReadError.h"
#include "VtkMessages.h"
#include "Words.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkXMLParser.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <utility>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

/// Keeps of a GIFTI file's elements what its arrays are.
class GiftiParser : public vtkXMLParser
{
public:
  static GiftiParser* New() { VTK_STANDARD_NEW_BODY(GiftiParser); }
  vtkTypeMacro(GiftiParser, vtkXMLParser);

  /// @return false if it is no XML, of which VTK says why
  bool parse(const fs::path& file, const Progress& progress)
  {
    const std::string bytes = contentsOf(file);
    this->Path = file;
    this->Most = bytes.size();
    this->InitializeParser();
    constexpr std::size_t step = 1 << 20;
    for (std::size_t begin = 0; !this->ParseError && !this->Problem && begin < bytes.size(); begin += step)
    {
      this->guard([&] { advance(progress, static_cast<double>(begin) / static_cast<double>(bytes.size())); });
      const std::size_t size = std::min(step, bytes.size() - begin);
      this->ParseChunk(bytes.data() + begin, static_cast<unsigned int>(size));
    }
    const bool isXml = this->CleanupParser() != 0;
    if (this->Problem)
    {
      std::rethrow_exception(this->Problem);
    }
    return isXml;
  }

  std::vector<GiftiArray> take() { return std::move(this->Arrays); }

protected:
  GiftiParser() = default;

  void StartElement(const char* name, const char** attributes) override
  {
    this->guard([&] { this->begin(name, attributes); });
  }
  void EndElement(const char* name) override
  {
    this->guard([&] { this->end(name); });
  }
  void CharacterDataHandler(const char* data, int length) override
  {
    this->guard([&] { this->add({ data, static_cast<std::size_t>(length) }); });
  }

private:
  /// No exception may pass through the parser, which is C: the first one waits here until that has ended.
  void guard(const std::function<void()>& part)
  {
    if (!this->Problem)
    {
      try
      {
        part();
      }
      catch (...)
      {
        this->Problem = std::current_exception();
      }
    }
  }

  void begin(std::string_view name, const char** attributes)
  {
    if (!std::exchange(this->Begun, true) && name != "GIFTI")
    {
      failToRead(
        this->Path, "it is no GIFTI file: its first element is '" + shortened(name) + "'; expected GIFTI");
    }
    // Also where an array begins within another one's text, which moves then.
    this->Target = nullptr;
    if (name == "DataArray")
    {
      this->InArray = true;
      GiftiArray& array = this->Arrays.emplace_back();
      for (; attributes && attributes[0]; attributes += 2)
      {
        array.attributes[attributes[0]] = attributes[1];
      }
    }
    else if (this->InArray && (name == "Data" || name == "Name" || name == "Value"))
    {
      this->Target = name == "Data" ? &this->Arrays.back().text : name == "Name" ? &this->Key : &this->Value;
      this->Target->clear();
    }
  }

  void end(std::string_view name)
  {
    this->Target = nullptr;
    this->InArray = this->InArray && name != "DataArray";
    if (this->InArray && name == "Value" && this->Key == "Name")
    {
      this->Arrays.back().name = this->Value;
    }
  }

  /// Entities can make text longer than the file.
  void add(std::string_view text)
  {
    if (text.size() > this->Most)
    {
      failToRead(this->Path, "its entities make more text than the file has");
    }
    this->Most -= text.size();
    if (this->Target)
    {
      this->Target->append(text);
    }
  }

  fs::path Path;
  std::size_t Most = 0; ///< characters that text may have yet
  std::exception_ptr Problem;
  std::vector<GiftiArray> Arrays;
  bool Begun = false;
  bool InArray = false;
  std::string* Target = nullptr; ///< what the text of an element is for
  std::string Key;
  std::string Value;
};

} // namespace

std::string_view GiftiArray::attribute(std::string_view key) const
{
  const auto found = this->attributes.find(key);
  return found == this->attributes.end() ? std::string_view() : std::string_view(found->second);
}

std::vector<GiftiArray> giftiArrays(const fs::path& file, const Progress& progress)
{
  vtkNew<GiftiParser> parser;
  const VtkMessages messages;
  if (!parser->parse(file, progress))
  {
    const std::string problem = messages.error();
    failToRead(file, "it is no XML that can be read" + (problem.empty() ? "" : ": " + problem));
  }
  return parser->take();
}

} // namespace ink::io
