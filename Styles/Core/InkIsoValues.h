// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkIsoValues_h
#define InkIsoValues_h

#include <vector>

/// Iso-values that are given, or chosen where none is, beside those that marks were made with. A change that
/// leaves these as they are needs no new marks: the chosen value is given, or is chosen once more.
class InkIsoValues
{
public:
  /// Why none can be chosen.
  static constexpr const char* None =
    "expected an image with two different finite values or more, found none";

  const std::vector<double>& GetGiven() const { return this->Given; }
  /// @return whether marks made at the values used last are others now
  bool Give(const std::vector<double>& values)
  {
    const bool changes = values != this->Given && (values.empty() ? !this->Chosen : values != this->Used);
    this->Given = values;
    return changes;
  }

  /// To be called when marks are made; without values before it is known whether there are any.
  void Use(const std::vector<double>& values)
  {
    this->Used = values;
    this->Chosen = this->Given.empty() && !values.empty();
  }
  const std::vector<double>& GetUsed() const { return this->Used; }

private:
  std::vector<double> Given;
  std::vector<double> Used;
  bool Chosen = false; ///< whether these were
};

#endif
