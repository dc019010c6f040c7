// What `ink` reads files with, given any bytes as a file of one format, which INK_FUZZ_FORMAT names by its
// suffix: nothing but a Failure may come out, no message, and what was read is sound and took no more memory
// than its file explains. `make fuzz` runs it with libFuzzer, and the ordinary tests FuzzCorpus.* run it over
// the files in Corpus/.

#include "Errors.h"
#include "Input.h"
#include "Progress.h"
#include "ReadFile.h"
#include "VolumeSlices.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include <unistd.h>

// There with the address sanitizer.
extern "C" int __attribute__((weak)) __sanitizer_install_malloc_and_free_hooks(
  void (*)(const volatile void*, std::size_t), void (*)(const volatile void*));
extern "C" std::size_t __attribute__((weak)) __sanitizer_get_allocated_size(const volatile void*);

namespace
{

using namespace ink::cli;
namespace fs = std::filesystem;

// What reading may take: ten times the file, and what VTK's readers need whatever they read.
constexpr std::size_t memoryPerByte = 10;
constexpr std::size_t fixedMemory = 16 << 20;

std::atomic<std::int64_t> allocated = 0;
std::atomic<std::int64_t> mostAllocated = 0;

void countAllocation(const volatile void*, std::size_t size)
{
  const std::int64_t now = allocated += static_cast<std::int64_t>(size);
  if (now > mostAllocated)
  {
    mostAllocated = now;
  }
}

void countRelease(const volatile void* memory)
{
  allocated -= memory ? static_cast<std::int64_t>(__sanitizer_get_allocated_size(memory)) : 0;
}

[[noreturn]] void fall(const std::string& reason)
{
  std::printf("FuzzRead: %s\n", reason.c_str());
  std::fflush(stdout);
  std::abort();
}

/// Whatever VTK says while nobody catches it.
class LoudWindow : public vtkOutputWindow
{
public:
  static LoudWindow* New();
  vtkTypeMacro(LoudWindow, vtkOutputWindow);
  void DisplayText(const char* message) override { fall(std::string("a message: ") + message); }
};
vtkStandardNewMacro(LoudWindow);

/// The place of the file that is read, alone in a folder but for the data that headers may name.
struct Place
{
  std::string format;
  fs::path folder;
  fs::path file;

  Place()
  {
    const char* name = std::getenv("INK_FUZZ_FORMAT");
    if (!name)
    {
      fall("INK_FUZZ_FORMAT names no format; expected a suffix as ply, or dicom or raw");
    }
    this->format = name;
    const fs::path shared = "/dev/shm";
    this->folder = (fs::is_directory(shared) ? shared : fs::temp_directory_path()) /
      ("ink-fuzz-" + std::to_string(getpid()));
    fs::create_directories(this->folder / "series");
    this->file = this->folder / ("series/a." + this->format);
    if (this->format == "nhdr" || this->format == "mhd")
    {
      std::ofstream(this->folder / "series/a.raw", std::ios::binary) << std::string(64, '\1');
    }
    // As in ink's main.
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    vtkOutputWindow::SetInstance(vtkNew<LoudWindow>());
    if (__sanitizer_install_malloc_and_free_hooks)
    {
      __sanitizer_install_malloc_and_free_hooks(countAllocation, countRelease);
    }
  }
  ~Place()
  {
    vtkOutputWindow::SetInstance(nullptr);
    std::error_code error;
    fs::remove_all(this->folder, error);
  }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;
};

Input read(const Place& place, const std::string& layout)
{
  Progress progress(true);
  const Memory memory;
  if (place.format == "raw")
  {
    return readRawVolume(place.file, RawLayout::parse(layout), memory, progress);
  }
  if (place.format == "dicom")
  {
    return readDicomFolder(place.file.parent_path(), memory, progress);
  }
  if (place.format == "xyz")
  {
    return readPoints(place.file, progress);
  }
  for (const char* mesh : { "ply", "obj", "stl", "vtp" })
  {
    if (place.format == mesh)
    {
      return readMesh(place.file, "." + place.format, progress);
    }
  }
  return readVolume(place.file, "." + place.format, memory, progress);
}

void useMesh(vtkPolyData* mesh)
{
  const vtkIdType count = mesh->GetNumberOfPoints();
  if (count == 0)
  {
    fall("a mesh without points");
  }
  vtkNew<vtkIdList> ids;
  for (vtkCellArray* cells : { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    for (vtkIdType cell = 0; cells && cell < cells->GetNumberOfCells(); ++cell)
    {
      cells->GetCellAtId(cell, ids);
      for (const vtkIdType id : *ids)
      {
        if (id < 0 || id >= count)
        {
          fall("a cell of points that are not there");
        }
      }
    }
  }
  for (int i = 0; i < mesh->GetPointData()->GetNumberOfArrays(); ++i)
  {
    if (mesh->GetPointData()->GetAbstractArray(i)->GetNumberOfTuples() != count)
    {
      fall("a point array of another length than the points");
    }
  }
  mesh->GetBounds();
}

void useVolume(vtkImageData* image)
{
  VolumeSlices volume(image);
  double sum = 0.0;
  vtkDataArray* scalars = volume.get(0, volume.dimensions()[2])->GetPointData()->GetScalars();
  if (scalars->GetNumberOfTuples() != image->GetNumberOfPoints() || scalars->GetNumberOfComponents() != 1)
  {
    fall("not one value a voxel");
  }
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    sum += scalars->GetComponent(i, 0);
  }
  volatile double used = sum;
  static_cast<void>(used);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const Place place;
  // The first line of a raw volume is its --raw.
  const std::uint8_t* begin = data;
  std::string layout;
  if (place.format == "raw")
  {
    begin = std::find(data, data + size, '\n');
    layout.assign(data, begin);
    begin += begin < data + size ? 1 : 0;
  }
  std::ofstream(place.file, std::ios::binary)
    .write(reinterpret_cast<const char*>(begin), static_cast<std::streamsize>(data + size - begin));
  if (begin == data + size)
  {
    // readInput refuses these before it looks for a reader.
    return 0;
  }

  // Where C libraries and C++ ones complain.
  char* text = nullptr;
  std::size_t textSize = 0;
  std::FILE* const standardError = stderr;
  stderr = open_memstream(&text, &textSize);
  std::ostringstream stream;
  std::streambuf* const streamBuffer = std::cerr.rdbuf(stream.rdbuf());
  const std::int64_t before = allocated;
  mostAllocated = before;
  std::string refused;
  try
  {
    const Input input = read(place, layout);
    if (auto* mesh = vtkPolyData::SafeDownCast(input.data))
    {
      useMesh(mesh);
    }
    else
    {
      useVolume(vtkImageData::SafeDownCast(input.data));
    }
  }
  catch (const Failure& failure)
  {
    refused = failure.what();
  }
  catch (const UsageError& error)
  {
    refused = error.what();
  }
  const std::int64_t most = mostAllocated - before;
  std::cerr.rdbuf(streamBuffer);
  std::fclose(stderr);
  stderr = standardError;
  const std::string said = stream.str() + std::string(text, textSize);
  std::free(text);
  if (!said.empty())
  {
    fall("a message: " + said);
  }
  if (most > static_cast<std::int64_t>(fixedMemory + memoryPerByte * size))
  {
    fall("a file of " + std::to_string(size) + " bytes took " + std::to_string(most) + " bytes of memory; " +
      refused);
  }
  if (std::getenv("INK_FUZZ_VERBOSE"))
  {
    std::printf("%s\n", refused.empty() ? "read" : refused.c_str());
  }
  return 0;
}
