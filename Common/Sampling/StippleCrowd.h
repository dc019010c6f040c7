#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace ink
{

/// The stipples that a voxel's new stipples keep away from, projected on the voxel's tangent plane. See
/// placeVolumeStipples.
class StippleCrowd
{
public:
  /// Candidates are judged side by side.
  static constexpr int lanes = 8;
  using Lanes = std::array<float, lanes>;

  /// \param capacity the most members there will be and one
  explicit StippleCrowd(std::size_t capacity);

  void clear() { this->Size = 0; }
  std::size_t size() const { return this->Size; }

  /// \param number how many stipples a voxel has when this one is drawn: its rank + 1
  void addIf(bool wanted, float x, float y, int number)
  {
    this->X[this->Size] = x;
    this->Y[this->Size] = y;
    this->Number[this->Size] = static_cast<float>(number);
    this->Size += wanted;
  }

  /// Forgets the members beyond a distance of the origin.
  void keepWithin(float distance);

  /// For each candidate the least squared distance to a member, times the larger of both numbers: in units of
  /// the area that a stipple has when both are drawn. Very large without members.
  void leastSpacing(const Lanes& x, const Lanes& y, int number, Lanes& least) const;

private:
  std::vector<float> X;
  std::vector<float> Y;
  std::vector<float> Number;
  std::size_t Size = 0;
};

} // namespace ink
