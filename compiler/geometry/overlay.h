// Who owns what, where rings of many owners overlap: polygons that share no area, by rank.
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

/// The places where each owner is on top: inside its rings (winding above zero) and inside no owner of a lower number.
///
/// @param segments  Closed rings, counter-clockwise around what they add; owners 0 … owner_count - 1, 0 on top.
/// Guarantees: rings are simple, counter-clockwise outside, holes clockwise, and touch themselves and each other at
/// vertices only; polygons of different owners share edges, not area; no vertex lies farther than 2^-10 m from the
/// rings. Total: it is made of a snapped arrangement, in which nothing can fail; what rounding leaves without area is
/// gone. Cost: the arrangement's, plus edges² for the labels: meant for one junction or one block, not for a city.
std::vector<std::vector<Polygon>> overlay(std::span<const OwnedSegment> segments, std::uint32_t owner_count);

/// Adds a ring's segments.
void add_ring(std::vector<OwnedSegment>& segments, std::span<const Vec2> ring, std::uint32_t owner);

}  // namespace citykiln
