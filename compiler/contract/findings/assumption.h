// Names what citykiln adds where the map is silent, and sets of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace citykiln {

/// The rows of assumptions.inc.
enum class Assumption : std::uint8_t {
#define ASSUMPTION(name, ...) name,
#include "compiler/contract/findings/assumptions.inc"
#undef ASSUMPTION
  kCount
};

/// A set of assumptions: the sum of their bits.
using Assumptions = std::uint16_t;

inline constexpr Assumptions kNoAssumptions = 0;
inline constexpr auto kAllAssumptions = static_cast<Assumptions>((1U << static_cast<unsigned>(Assumption::kCount)) - 1);

/// Returns the set that has this assumption alone.
constexpr Assumptions bit_of(Assumption assumption) {
  return static_cast<Assumptions>(1U << static_cast<unsigned>(assumption));
}

/// All that --assume can name: houses belong to --fill.
inline constexpr Assumptions kNamedAssumptions = kAllAssumptions & ~bit_of(Assumption::kHouses);
/// True if a set has the assumption.
constexpr bool has(Assumptions set, Assumption assumption) { return (set & bit_of(assumption)) != 0; }

/// The name of an assumption for --assume and in outputs, such as "pavements".
std::string_view name_of(Assumption assumption);
/// The text of its row, such as "the storeys of buildings".
std::string_view text_of(Assumption assumption);
/// Returns the assumption with a name; empty if there is none.
std::optional<Assumption> assumption_named(std::string_view name);

}  // namespace citykiln
