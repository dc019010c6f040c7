// SPDX-License-Identifier: BSD-3-Clause
#include "RenderFrames.h"

#include "Drawing.h"
#include "InkHasPolygons.h"
#include "OutputFile.h"
#include "PictureFile.h"
#include "Progress.h"
#include "RenderCommand.h"
#include "Video.h"

#include "vtkCamera.h"
#include "vtkInkCameraFit.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace ink::cli
{
namespace
{

/// Pictures to numbered files or to a video.
class FrameOutput
{
public:
  FrameOutput(const RenderOptions& options, std::size_t frames)
    : Name(options.output)
  {
    const fs::path& file = this->Name;
    if (Video::isVideo(file))
    {
      this->Film = std::make_unique<Video>(
        file, options.size.width, options.size.height, options.animation->framesPerSecond);
      return;
    }
    for (std::size_t i = 0; i < frames; ++i)
    {
      this->Files.emplace_back(numbered(file, i));
    }
  }

  /// @param draw hands over all rows
  void write(
    std::size_t frame, const io::PictureLayout& layout, const std::function<void(const RowSink&)>& draw)
  {
    if (this->Film)
    {
      draw([this](std::span<const unsigned char> rows) { this->Film->add(rows); });
    }
    else
    {
      writePicture(this->Files[frame], this->Name, layout, draw);
    }
  }

  void finish()
  {
    if (this->Film)
    {
      this->Film->finish();
    }
  }

private:
  /// The name with its %04d replaced by a number.
  static fs::path numbered(const fs::path& file, std::size_t number)
  {
    const std::string name = file.filename().string();
    const std::size_t begin = name.find('%');
    const std::size_t end = name.find('d', begin);
    const std::string width = name.substr(begin + 1, end - begin - 1);
    std::string digits = std::to_string(number);
    const std::size_t wanted = width.empty() ? 0 : std::stoul(width);
    digits.insert(0, wanted > digits.size() ? wanted - digits.size() : 0, '0');
    return file.parent_path() / (name.substr(0, begin) + digits + name.substr(end + 1));
  }

  fs::path Name; ///< with its %04d
  std::deque<OutputFile> Files;
  std::unique_ptr<Video> Film;
};

/// Says each thing once.
class Notes
{
public:
  void add(const std::vector<std::string>& notes)
  {
    for (const std::string& note : notes)
    {
      if (std::find(this->All.begin(), this->All.end(), note) == this->All.end())
      {
        this->All.push_back(note);
      }
    }
  }
  const std::vector<std::string>& all() const { return this->All; }

private:
  std::vector<std::string> All;
};

/// Once around: the subject is made once.
void turn(const RenderOptions& options, FrameOutput& output, Notes& notes, Progress& progress)
{
  const std::size_t frames = options.animation->frames.size();
  const Input input = readInput(options.input, progress, wantedOf(options));
  const StyledScene subject = SceneMaker(options).make(input, progress);
  notes.add(input.notes);
  notes.add(subject.notes);
  const double* b = subject.frame->GetBounds();
  Drawing drawing(options);
  notes.add(drawing.look(input, options.input.file));
  notes.add(drawing.lookAtFrame(subject.frame));
  const auto fit = drawing.makeFit();
  fit->SetPivot((b[0] + b[1]) / 2, (b[2] + b[3]) / 2, (b[4] + b[5]) / 2);
  const auto angle = [&](std::size_t frame)
  { return 360.0 * static_cast<double>(frame) / static_cast<double>(frames); };
  for (std::size_t i = 0; i < frames; ++i)
  {
    fit->AddPoints(subject.frame, drawing.camera(angle(i)));
  }
  for (std::size_t i = 0; i < frames; ++i)
  {
    progress.step("drawing frame " + std::to_string(i + 1) + " of " + std::to_string(frames));
    output.write(i, drawing.layout(),
      [&](const RowSink& sink) { drawing.draw(subject, fit, sink, progress.watcher(), angle(i)); });
  }
}

/// One step after the other. First where each is, then its picture: all of them at once may not fit into
/// memory.
void play(const RenderOptions& options, FrameOutput& output, Notes& notes, Progress& progress)
{
  const Animation& animation = *options.animation;
  const auto inputAt = [&](std::size_t frame)
  {
    InputOptions one = options.input;
    one.file = animation.files[animation.frames[frame]];
    return readInput(one, progress, wantedOf(options));
  };
  SceneMaker subjects(options, true);
  Drawing drawing(options);
  const auto fit = drawing.makeFit();
  std::set<std::size_t> fitted;
  for (std::size_t i = 0; i < animation.frames.size(); ++i)
  {
    if (!fitted.insert(animation.frames[i]).second)
    {
      continue;
    }
    const Input input = inputAt(i);
    if (i == 0)
    {
      notes.add(drawing.look(input, animation.files[animation.frames[0]]));
    }
    std::vector<std::string> chosen;
    subjects.keepIsoValue(input, chosen, progress);
    notes.add(chosen);
    auto* mesh = vtkPolyData::SafeDownCast(input.data);
    // The samples of a mesh lie between its points. A cloud may have points that are left out.
    const bool hasFaces = mesh && InkHasPolygons(mesh);
    const vtkSmartPointer<vtkPoints> frame =
      hasFaces ? mesh->GetPoints() : subjects.make(input, progress).frame.Get();
    notes.add(drawing.lookAtFrame(frame));
    fit->AddPoints(frame, drawing.camera());
  }
  for (std::size_t i = 0; i < animation.frames.size(); ++i)
  {
    const Input input = inputAt(i);
    const StyledScene subject = subjects.make(input, progress);
    notes.add(input.notes);
    notes.add(subject.notes);
    progress.step(
      "drawing frame " + std::to_string(i + 1) + " of " + std::to_string(animation.frames.size()));
    output.write(i, drawing.layout(),
      [&](const RowSink& sink) { drawing.draw(subject, fit, sink, progress.watcher()); });
  }
}

} // namespace

void renderFrames(const RenderOptions& options)
{
  const Animation& animation = *options.animation;
  FrameOutput output(options, animation.frames.size());
  requireGraphics();
  Progress progress(options.quiet);
  Notes notes;
  (animation.files.empty() ? turn : play)(options, output, notes, progress);
  output.finish();
  progress.finish();
  if (!options.quiet)
  {
    for (const std::string& note : notes.all())
    {
      std::cerr << "ink: " << note << '\n';
    }
    std::cerr << "ink: wrote " << animation.frames.size() << " frames to " << options.output.string() << '\n';
  }
}

} // namespace ink::cli
