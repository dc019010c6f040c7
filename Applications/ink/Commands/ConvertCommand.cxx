// SPDX-License-Identifier: BSD-3-Clause
#include "ConvertCommand.h"

#include "Core/FormatNumber.h"
#include "Errors.h"
#include "OutputFile.h"
#include "Progress.h"
#include "Vdb/VdbLibrary.h"

#include "Fields/Vdb/VdbWrite.h"
#include "InkImageGrid.h"
#include "InkVolumeValues.h"

#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cmath>
#include <iostream>

namespace ink::cli
{
namespace
{

/// 64-bit integers beyond 2^53 are rounded by a double.
bool isRounded(vtkDataArray* scalars, const double range[2])
{
  constexpr double exact = 9007199254740992.0;
  return scalars->GetDataTypeSize() == 8 && scalars->GetDataType() != VTK_DOUBLE &&
    (range[0] < -exact || range[1] > exact);
}

} // namespace

void convert(const ConvertOptions& options)
{
  if (options.output.extension() != ".vdb")
  {
    throw UsageError("'" + options.output.string() + "': expected a name that ends in .vdb");
  }
  // What can fail soon should not fail late.
  const OutputFile output(options.output);

  Progress progress(options.quiet);
  Input input = readInput(options.input, progress);
  if (!input.isVolume())
  {
    throw UsageError("'" + options.input.file.string() + "': expected a volume, found a mesh");
  }
  auto* image = vtkImageData::SafeDownCast(input.data);
  if (!image)
  {
    throw Failure("cannot convert '" + options.input.file.string() +
      "': it is larger than memory; expected a larger --memory, found " +
      InkFormatMemory(options.input.memory.Limit));
  }
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const FiniteRange values = InkFindFiniteRange(image);
  const double range[2] = { values.least, values.greatest };
  // Also for NaN.
  if (options.around && !(*options.around > range[0] && *options.around <= range[1]))
  {
    throw UsageError("--around " + formatNumber(*options.around) + ": expected a value above " +
      formatNumber(range[0]) + " and up to " + formatNumber(range[1]) + ", which the volume has");
  }
  if (isRounded(scalars, range))
  {
    input.notes.emplace_back("its integers are rounded to doubles");
  }

  progress.step("converting");
  VdbConversion conversion;
  conversion.around = options.around;
  conversion.halfWidth = options.halfWidth;
  conversion.name = options.name;
  std::string bytes;
  try
  {
    bytes = vdbLibrary().convert(image, conversion);
  }
  catch (const std::invalid_argument& error)
  {
    throw Failure("cannot convert '" + options.input.file.string() + "': " + error.what());
  }
  progress.step("writing " + options.output.filename().string());
  output.write({ reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size() });
  progress.finish();
  if (!options.quiet)
  {
    for (const std::string& note : input.notes)
    {
      std::cerr << "ink: " << note << '\n';
    }
    std::cerr << "ink: wrote " << options.output.string() << ": " << bytes.size() << " bytes\n";
  }
}

} // namespace ink::cli
