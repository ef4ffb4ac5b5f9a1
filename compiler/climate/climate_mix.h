// Shares of climate classes at a place between the places that the table has.
#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <span>

#include "compiler/climate/climate_class.h"

namespace citykiln::climate {

struct ClimateShare {
  ClimateClass climate{};
  double share = 0;
};

/// Climate classes with shares, each class once. The caller makes the shares add up to 1; a new mix is empty.
class ClimateMix {
 public:
  ClimateMix() = default;
  explicit ClimateMix(ClimateClass climate) { add(climate, 1); }

  /// Adds to the share of a class. At most 16 different classes.
  void add(ClimateClass climate, double share) {
    std::uint8_t i = 0;
    while (i < count_ && all_[i].climate != climate) ++i;
    assert(i < all_.size());
    if (i == count_) all_[count_++] = {climate, 0};
    all_[i].share += share;
  }

  std::span<const ClimateShare> shares() const { return std::span(all_).first(count_); }

  /// The mean of a value of classes.
  template <typename ValueOf>
  double mean(ValueOf value_of) const {
    double sum = 0;
    for (const ClimateShare& each : shares()) sum += each.share * value_of(each.climate);
    return sum;
  }

 private:
  std::array<ClimateShare, 16> all_{};  // four places with four classes each
  std::uint8_t count_ = 0;
};

}  // namespace citykiln::climate
