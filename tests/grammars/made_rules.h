// Makes valid rule files and first shapes from a string of bytes, for tests and fuzz_derivation.
//
// Mutated text rarely parses. Here every string of bytes gives a valid program. Operations, functions and values are
// taken from their tables, so that new rows are tested without a change here.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "grammars/language/operation_table.h"
#include "grammars/shapes/shape.h"

namespace citykiln::grammars {

/// Choices that are read from bytes; after the last byte always the first choice.
class Choices {
 public:
  explicit Choices(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint32_t byte() { return next_ < bytes_.size() ? bytes_[next_++] : 0; }
  std::uint32_t below(std::size_t count) { return byte() % static_cast<std::uint32_t>(count); }
  /// Returns one of 256 evenly spaced values.
  double between(double low, double high) { return low + (high - low) * byte() / 255; }
  /// True one time in `count`; never after the last byte.
  bool one_in(std::uint32_t count) { return byte() % count == count - 1; }
  template <typename List>
  auto of(const List& list) {
    return list[below(std::size(list))];
  }
  bool are_over() const { return next_ >= bytes_.size(); }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

/// Returns a rule file of attributes, constants, functions and six rules, the first of which is "Lot". Rules lead to
/// later rules, sometimes to any.
std::string made_rules(Choices& choices);

/// Returns a footprint: a rectangle, steps or a star, with a hole or without; or an invalid one: rings that cross
/// themselves, repeated corners, slivers, no corners. Plane metres; counter-clockwise if valid.
Polygon made_footprint(Choices& choices);

/// True if no rings cross, holes are inside, and the footprint is no larger than a city block, so that distances can be
/// measured.
bool is_sound(const Polygon& footprint);

/// Returns the footprint as a lot, or as a mass with walls and some roof.
Shape made_shape(Choices& choices, const Polygon& footprint);

}  // namespace citykiln::grammars
