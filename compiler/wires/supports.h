// Supports of wires: masts, poles and other things whose rules state where wires hang (grammars/things/README.md), with
// these places in plane metres.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/things/catalogue.h"
#include "compiler/things/generate.h"

namespace citykiln::wires {

/// A thing that holds wires.
struct Support {
  Vec2 at;                              ///< The middle of its base, plane metres.
  std::vector<things::WireHold> holds;  ///< At least one; places in plane metres.
};

/// Returns a support that stands at a place.
/// @param holds  things::wire_holds() of its form; at least one.
Support support_at(const Placement& placement, std::vector<things::WireHold> holds);

/// Supports by the number of their OSM node.
using Supports = std::map<std::int64_t, Support>;

/// Adds the things that hold wires, as they stand on the ground. Other things are skipped. Each form is derived once.
/// O(things · log + forms).
void add_supports(Supports& supports, std::span<const things::Thing> things, const things::Kinds& kinds,
                  std::uint64_t seed, const ground::GradedTerrain& ground);

/// Returns the attachments of one kind for wires in a direction: those on the left, then those in the middle, then
/// those on the right; each from the highest to the lowest. Left and right are as seen along the direction.
///
/// @param along  A unit vector in plan.
std::vector<Vec3> ordered_holds(const Support& support, things::WireKind kind, Vec2 along);

/// Returns `count` of the attachments, in their order: the highest ones on the right side if that has enough of them,
/// else the farthest from the axis of the line. All of them if there are not more.
/// @param holds  Result of ordered_holds().
/// @param at     Where the axis of the line passes the support (Support::at).
/// @param along  Direction of the line, as for ordered_holds().
std::vector<Vec3> chosen_holds(std::vector<Vec3> holds, std::size_t count, Vec2 at, Vec2 along);

}  // namespace citykiln::wires
