// Rule files that parse, and what they are applied to, out of a string of choices: for tests and fuzz_derivation.
//
// A mutator that knows no grammar hardly ever gets through the parser. Here every string of bytes is a sound program;
// operations, functions and values come out of their tables, so that a new row is tried without a line here.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "grammars/operations/table.h"
#include "grammars/shapes/shape.h"

namespace citykiln::grammars {

/// Choices out of bytes; where there are no more, always the first.
class Choices {
 public:
  explicit Choices(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint32_t byte() { return next_ < bytes_.size() ? bytes_[next_++] : 0; }
  std::uint32_t below(std::size_t count) { return byte() % static_cast<std::uint32_t>(count); }
  /// In 255 steps.
  double between(double low, double high) { return low + (high - low) * byte() / 255; }
  /// True one time in `count`, and never where there are no more bytes.
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

/// A whole rule file: attributes, constants, functions and six rules, the first of which is "Lot". Rules come to those
/// behind them, now and then to any. read_rules_of() takes it.
std::string made_rules(Choices& choices);

/// A footprint: rectangles, steps, stars, with a hole or without; and what no map should hold: rings that cross
/// themselves, corners twice, slivers, nothing at all. Plane metres, counter-clockwise where it is sound.
Polygon made_footprint(Choices& choices);

/// Its rings cross neither themselves nor each other, its holes lie within it, and it is no larger than a block:
/// distances to what is made of it mean something.
bool is_sound(const Polygon& footprint);

/// The footprint as a lot, or as a mass with walls and some roof.
Shape made_shape(Choices& choices, const Polygon& footprint);

}  // namespace citykiln::grammars
