// Bounds from the rules alone, before a derivation, how far a body can move a surface.
//
// This is an abstract interpretation of the rules: numbers are intervals, every branch of a case counts whose condition
// may hold, and what cannot be bounded is infinite. It bounds what displacement.h measures. Each operation has its rule
// in the `bound` column of operations.inc, expressions share the operators and functions of evaluate.h. Bounded are
// planar faces whose normal is along the scope's z or y, as facades, lots and their parts have, and prisms over them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "grammars/derivation/displacement.h"
#include "grammars/language/syntax.h"
#include "grammars/shapes/shape.h"

namespace citykiln::grammars {

struct Run;
struct Execution;

/// An interval that contains a number; infinite if nothing is known of it.
struct NumberRange {
  double low = -kUnbounded_m, high = kUnbounded_m;
  bool operator==(const NumberRange&) const = default;
};

/// By slot.
using NumberRanges = std::vector<NumberRange>;

struct DisplacementBound {
  Displacement moved = {kUnbounded_m, kUnbounded_m};
  bool survives = false;  ///< The result surely has a surface; else `moved.back_m` has no meaning.
};

/// For KnownBound::attributes: whatever they are.
inline constexpr std::uint32_t kAnyAttributes = ~0u;

/// The bound of a body for shapes with these attributes (Shape::attributes) and these arguments.
struct KnownBound {
  std::uint32_t attributes = 0;
  NumberRanges arguments;
  DisplacementBound bound;
  std::uint32_t next = 0;  ///< 1 + index into BoundTable::found of the next of the same body; 0 for the last.
};

/// The bounds found so far.
struct BoundTable {
  std::vector<KnownBound> found;
  std::vector<std::uint32_t> first_of;  ///< By Body::number: 1 + index of the newest in `found`; 0 for none.
  std::uint32_t evaluations = 0;        ///< Of bodies and values; beyond a limit everything is unbounded.
};

/// The bound of a body applied to a face for which is_flat() holds. Derives nothing and draws no random numbers.
/// Guarantee: the measured displacement is never larger, unless a limit ends the derivation. What moves more than the
/// tolerance may be unbounded. O(bodies that the body can lead to), once for each kind of arguments.
DisplacementBound displacement_bound(Execution& execution, const NumberRanges& arguments, const Body& body);

/// The parameters and locals of the node, for displacement_bound() of bodies in it.
NumberRanges ranges_of(const Execution& execution);

/// True for one planar face whose normal is along the scope's z or y.
bool is_flat(const Shape& shape);

/// The bound of what the body moves the node's shape, if it is within the tolerance, so that the node need not be
/// derived (DeriveOptions::prune_early). std::nullopt also for bodies that divide nothing: their successors are tried.
std::optional<Displacement> bound_within_tolerance(Execution& execution, const Body& body);

}  // namespace citykiln::grammars
