// Bounds the distance by which a body (the statements of a rule) can move a surface, from the rules alone, before a
// derivation.
//
// This is an abstract interpretation of the rules: numbers are intervals, every branch whose condition may hold counts,
// and a displacement without a known bound is infinite. The result is an upper bound of the displacement that
// displacement.h measures. The `bound` column of operations.inc has the method of each operation; expressions share the
// operators and functions of evaluate.h. It handles planar faces whose normal is along the scope's z or y, such as
// facades, lots and their parts, and prisms over such faces.
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

/// An interval that contains a number; infinite if the number is unknown.
struct NumberRange {
  double low = -kUnbounded_m, high = kUnbounded_m;
  bool operator==(const NumberRange&) const = default;
};

/// The ranges of a rule's parameters, followed by the ranges of its locals.
using NumberRanges = std::vector<NumberRange>;

/// A bound of the displacement by a body.
struct DisplacementBound {
  Displacement moved = {kUnbounded_m, kUnbounded_m};
  bool survives = false;  ///< True if the result has a surface for certain. If false, `moved.to_later_m` is undefined.
};

/// A value of KnownBound::attributes: the bound holds for any attributes.
inline constexpr std::uint32_t kAnyAttributes = ~0u;

/// A computed bound of a body, for shapes with these attributes (Shape::attributes) and these arguments.
struct KnownBound {
  std::uint32_t attributes = 0;
  NumberRanges arguments;
  DisplacementBound bound;
  std::uint32_t next = 0;  ///< 1 + index into BoundTable::found of the body's next bound; 0 for the last.
};

/// All bounds computed in a derivation until now.
struct BoundTable {
  std::vector<KnownBound> found;
  /// By Body::number: 1 + index of the body's newest bound in `found`; 0 for none.
  std::vector<std::uint32_t> first_of;
  /// The number of evaluated bodies and values. Beyond a limit everything is unbounded.
  std::uint32_t evaluations = 0;
};

/// Returns the bound of a body applied to a face for which is_flat() holds, without a derivation and without random
/// numbers. Guarantee: the measured displacement is never larger, unless a limit ends the derivation. A displacement
/// above the tolerance may be returned as infinite. O(bodies that the body can lead to), once for each distinct set of
/// arguments.
/// @param execution  The node in which the body would be applied.
/// @param arguments  The ranges of the node's parameters and locals: ranges_of().
DisplacementBound displacement_bound(Execution& execution, const NumberRanges& arguments, const Body& body);

/// Returns the values of a node's parameters and locals as ranges, for displacement_bound().
NumberRanges ranges_of(const Execution& execution);

/// True for one planar face whose normal is along the scope's z or y.
bool is_flat(const Shape& shape);

/// Returns the bound of the displacement of the node's shape by a body, if it is within the tolerance and the node need
/// not be derived (DeriveOptions::prune_early). Returns std::nullopt for a body that divides nothing: each rule that
/// such a body applies is tested by itself.
std::optional<Displacement> bound_within_tolerance(Execution& execution, const Body& body);

}  // namespace citykiln::grammars
