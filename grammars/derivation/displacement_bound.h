// How far a body can move a surface, known before anything is derived of it.
//
// What displacement.h measures is bounded here from the rules alone: numbers are intervals, of a case all branches
// count whose condition may hold, and what cannot be bounded is infinite. Known are flat faces that look along their
// scope's z or y, as facades, lots and their parts do, and prisms over them; looks, extrude, t, comp, split, setback
// and successors.
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

/// A number that lies somewhere between two; infinite where nothing is known.
struct NumberRange {
  double low = -kUnbounded_m, high = kUnbounded_m;
  bool operator==(const NumberRange&) const = default;
};

/// By slot.
using NumberRanges = std::vector<NumberRange>;

struct DisplacementBound {
  Displacement moved = {kUnbounded_m, kUnbounded_m};
  bool stays = false;  ///< Something surely comes of it; else `moved.back_m` says nothing.
};

/// For KnownBound: whatever they are.
inline constexpr std::uint32_t kAnyAttributes = ~0u;

/// What a body may move of a shape with these attributes (Shape::attributes) that is given these arguments.
struct KnownBound {
  std::uint32_t attributes = 0;
  NumberRanges arguments;
  DisplacementBound reach;
  std::uint32_t next = 0;  ///< Of the same body: 1 + where BoundTable::found has it; 0 for the last.
};

/// What has been found so far.
struct BoundTable {
  std::vector<KnownBound> found;
  std::vector<std::uint32_t> first_of;  ///< By Body::number: 1 + the newest of `found`; 0 for none.
  std::uint32_t looks = 0;              ///< Bodies and values looked at; after so many, everything is unbounded.
};

/// The bound for a body applied to a face that looks along its scope's z or y; nothing is derived and no dice are
/// thrown. Safe: what the derivation measures is never more, unless a limit ends it. What moves more than the tolerance
/// may be unbounded here. O(bodies that it may come to until that is known), once.
DisplacementBound displacement_bound(Execution& execution, const NumberRanges& arguments, const Body& body);

/// What the node was given, for displacement_bound() of bodies in it.
NumberRanges ranges_of(const Execution& execution);

/// True for one flat face that looks along its scope's z or y: what displacement_bound() knows.
bool is_flat(const Shape& shape);

/// What the body may move the node's shape, if that is known to be within the tolerance, so that the node need not be
/// derived (DeriveOptions::ahead). std::nullopt also for bodies that divide nothing: what they name is looked at in its
/// turn.
std::optional<Displacement> bound_within_tolerance(Execution& execution, const Body& body);

}  // namespace citykiln::grammars
