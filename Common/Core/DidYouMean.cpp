// SPDX-License-Identifier: BSD-3-Clause
#include "Core/DidYouMean.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace ink
{
namespace
{

std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::size_t alignmentDistance(const std::string& a, const std::string& b)
{
  // distance[i][j] is that of the first i letters of a and the first j of b.
  std::vector<std::vector<std::size_t>> distance(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
  {
    for (std::size_t j = 0; j <= b.size(); ++j)
    {
      if (i == 0 || j == 0)
      {
        distance[i][j] = i + j;
        continue;
      }
      distance[i][j] = std::min({ distance[i - 1][j] + 1, distance[i][j - 1] + 1,
        distance[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1) });
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
      {
        distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
      }
    }
  }
  return distance[a.size()][b.size()];
}

} // namespace

std::string didYouMean(const std::string& found, const std::vector<std::string>& known)
{
  const std::string wanted = lowerCase(found);
  std::size_t nearest = std::max<std::size_t>(wanted.size() / 3, 1) + 1;
  const std::string* best = nullptr;
  for (const std::string& word : known)
  {
    const std::size_t distance = alignmentDistance(wanted, lowerCase(word));
    // Of a word of few letters nothing would be left.
    if (distance < nearest && distance < word.size() / 2 + 1)
    {
      nearest = distance;
      best = &word;
    }
  }
  return best ? "; did you mean '" + *best + "'?" : "";
}

} // namespace ink
