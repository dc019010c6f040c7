// SPDX-License-Identifier: BSD-3-Clause
#include "FrameChoice.h"

#include "Errors.h"
#include "Pattern.h"

namespace ink::cli
{
namespace
{

constexpr std::size_t mostFrames = 100'000;

std::size_t countOf(const std::string& frames, const std::string& expected)
{
  static const io::Pattern pattern(R"(\d{1,6})");
  const std::size_t count = pattern.match(frames).empty() ? 0 : std::stoul(frames);
  if (count < 1 || count > mostFrames)
  {
    throw UsageError("--frames '" + frames + "': expected " + expected);
  }
  return count;
}

} // namespace

std::vector<std::size_t> chooseSteps(const std::string& frames, std::size_t steps)
{
  const std::string expected = "a number of frames from 1 to " + std::to_string(mostFrames) +
    ", or first:last or first:last:every, from 0 to " + std::to_string(steps - 1);
  std::vector<std::size_t> chosen;
  if (frames.find(':') != std::string::npos)
  {
    static const io::Pattern pattern(R"((\d{1,9}):(\d{1,9})(?::(\d{1,9}))?)");
    const std::vector<std::string> match = pattern.match(frames);
    const bool valid = !match.empty();
    const std::size_t first = valid ? std::stoul(match[1]) : 0;
    const std::size_t last = valid ? std::stoul(match[2]) : 0;
    const std::size_t every = valid && !match[3].empty() ? std::stoul(match[3]) : 1;
    if (!valid || first > last || last >= steps || every == 0)
    {
      throw UsageError("--frames '" + frames + "': expected " + expected);
    }
    for (std::size_t step = first; step <= last; step += every)
    {
      chosen.push_back(step);
    }
    return chosen;
  }
  const std::size_t count = frames.empty() ? steps : countOf(frames, expected);
  for (std::size_t i = 0; i < count; ++i)
  {
    chosen.push_back(count == 1 ? 0 : (i * (steps - 1) + (count - 1) / 2) / (count - 1));
  }
  return chosen;
}

std::size_t turntableFrames(const std::string& frames)
{
  return countOf(frames, "a number of pictures once around, from 1 to " + std::to_string(mostFrames));
}

} // namespace ink::cli
