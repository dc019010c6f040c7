// SPDX-License-Identifier: BSD-3-Clause
// vtkInk's readers of volumes and meshes, given any bytes as a file of one format, which INK_FUZZ_FORMAT
// names by its suffix: nothing but one error of the reader may come out, no other message, and what was read
// is sound and took no more memory than its file explains. `make fuzz` runs it with libFuzzer, and the
// ordinary tests FuzzCorpus.* run it over the files in Corpus/.

#include "InkTestMessages.h"
#include "VtkMessages.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInkMeshReader.h"
#include "vtkInkVolumeReader.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>

#include <unistd.h>

// There with the address sanitizer.
extern "C" int __attribute__((weak)) __sanitizer_install_malloc_and_free_hooks(
  void (*)(const volatile void*, std::size_t), void (*)(const volatile void*));
extern "C" std::size_t __attribute__((weak)) __sanitizer_get_allocated_size(const volatile void*);

namespace
{

namespace fs = std::filesystem;

// What reading may take: ten times the file, and what VTK's readers need whatever they read.
constexpr std::size_t memoryPerByte = 10;
constexpr std::size_t fixedMemory = 16 << 20;
// A grid becomes an image of up to two million voxels, and as many values more while it does.
constexpr std::size_t gridMemory = 48 << 20;

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
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfTuples() != image->GetNumberOfPoints() ||
    scalars->GetNumberOfComponents() != 1)
  {
    fall("not one value a voxel");
  }
  double sum = 0.0;
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    sum += scalars->GetComponent(i, 0);
  }
  volatile double used = sum;
  static_cast<void>(used);
}

/// What a reader answers. @return its error, empty if it read the file
std::string run(vtkAlgorithm* reader, const std::function<void()>& part)
{
  vtkNew<InkTestMessages> messages;
  messages->Observe(reader);
  messages->Observe(reader->GetExecutive());
  part();
  reader->RemoveObserver(messages);
  reader->GetExecutive()->RemoveObserver(messages);
  if (messages->Messages.empty())
  {
    return "";
  }
  const std::string error = ink::plainMessage(messages->Messages.front());
  if (messages->Messages.size() > 1 || !error.starts_with("cannot read '"))
  {
    fall("more than one error, or one that names no file: " + messages->Messages.back());
  }
  if (reader->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT) != 0)
  {
    fall("an error, but points: " + error);
  }
  return error;
}

/// The last slice, and of that half of the rows, once more.
void usePart(vtkInkVolumeReader* reader)
{
  vtkNew<vtkImageData> whole;
  whole->ShallowCopy(reader->GetOutput());
  int part[6];
  whole->GetExtent(part);
  part[0] += (part[1] - part[0]) / 2;
  part[4] = part[5];
  if (!run(reader, [&] { reader->vtkAlgorithm::UpdateExtent(part); }).empty())
  {
    fall("a part that cannot be read of a whole that can");
  }
  for (int y = part[2]; y <= part[3]; ++y)
  {
    for (int x = part[0]; x <= part[1]; ++x)
    {
      const double values[2] = { whole->GetScalarComponentAsDouble(x, y, part[4], 0),
        reader->GetOutput()->GetScalarComponentAsDouble(x, y, part[4], 0) };
      if (values[0] != values[1] && (values[0] == values[0] || values[1] == values[1]))
      {
        fall("a part of other values than the whole's");
      }
    }
  }
}

/// The layout of a raw volume from its first line, as 4x4x4:uint8. @return whether it is one
bool setLayout(vtkInkVolumeReader* reader, const std::string& layout)
{
  static const std::map<std::string, int> types{ { "int8", VTK_SIGNED_CHAR }, { "uint8", VTK_UNSIGNED_CHAR },
    { "int16", VTK_SHORT }, { "uint16", VTK_UNSIGNED_SHORT }, { "int32", VTK_INT },
    { "uint32", VTK_UNSIGNED_INT }, { "int64", VTK_LONG_LONG }, { "uint64", VTK_UNSIGNED_LONG_LONG },
    { "float32", VTK_FLOAT }, { "float64", VTK_DOUBLE } };
  int size[3];
  char type[8] = "";
  if (std::sscanf(layout.c_str(), "%dx%dx%d:%7s", &size[0], &size[1], &size[2], type) != 4 ||
    !types.contains(type))
  {
    return false;
  }
  reader->RawOn();
  reader->SetRawDimensions(size);
  reader->SetRawScalarType(types.at(type));
  return true;
}

/// Reads the file and looks at all of it. @return why it was refused, empty if it was not
std::string read(const Place& place, const std::string& layout)
{
  std::istringstream meshes(vtkInkMeshReader::GetFileExtensions());
  const std::istream_iterator<std::string> none;
  const bool isMesh = std::find(std::istream_iterator<std::string>(meshes), none, "." + place.format) != none;
  vtkNew<vtkInkMeshReader> mesh;
  // Legacy VTK files may hold volumes.
  if (isMesh && (place.format != "vtk" || mesh->CanReadFile(place.file.c_str()) != 0))
  {
    mesh->SetFileName(place.file.c_str());
    const std::string refused = run(mesh, [&] { mesh->Update(); });
    if (refused.empty())
    {
      useMesh(mesh->GetOutput());
    }
    return refused;
  }
  vtkNew<vtkInkVolumeReader> reader;
  reader->SetFileName((place.format == "dicom" ? place.file.parent_path() : place.file).c_str());
  if (place.format == "raw" && !setLayout(reader, layout))
  {
    return "no layout";
  }
  const std::string refused = run(reader, [&] { reader->Update(); });
  if (refused.empty())
  {
    useVolume(reader->GetOutput());
    usePart(reader);
  }
  return refused;
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
    // Refused before anything is looked at.
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
  const std::string refused = read(place, layout);
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
  const bool mayBeGrid = place.format == "vtr" || place.format == "vts" || place.format == "vtk";
  if (most > static_cast<std::int64_t>(fixedMemory + (mayBeGrid ? gridMemory : 0) + memoryPerByte * size))
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
