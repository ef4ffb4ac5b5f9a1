// Polygon overlay with priorities: where rings of several owners overlap, the owner with the lowest number gets the
// area.
//
//    +---+                +---+
//    | 0 |--+    0 on     | 0 |--+
//    |   |1 |    top:     |   | 1|
//    +---+  |             +---+  |
//      +----+               +----+
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/arrangement.h"
#include "compiler/geometry/polygon.h"

namespace citykiln {

/// Returns each owner's area as polygons: the area inside its rings (winding number above zero) and outside the rings
/// of all owners with lower numbers.
///
/// @param segments  Closed rings, counter-clockwise around added area; owners 0 … owner_count - 1.
/// Guarantees: rings are simple, counter-clockwise outside, holes clockwise, and touch themselves and each other at
/// vertices only; polygons of different owners share edges, not area; no vertex is farther than 2^-10 m from the rings.
/// Cannot fail: it is based on a snap-rounded arrangement; polygons that rounding leaves without area are dropped.
/// Cost: as arrange(), plus for each edge the number of owners and of the edges in its row, about the square root of
/// all.
std::vector<std::vector<Polygon>> overlay(std::span<const OwnedSegment> segments, std::uint32_t owner_count);

/// Returns the part of a polygon outside of others, as overlay() does. Cost: that of overlay().
std::vector<Polygon> difference(const Polygon& polygon, std::span<const Polygon> taken);

/// Appends the segments of a ring (plane metres) with an owner.
void add_ring(std::vector<OwnedSegment>& segments, std::span<const Vec2> ring, std::uint32_t owner);

}  // namespace citykiln
