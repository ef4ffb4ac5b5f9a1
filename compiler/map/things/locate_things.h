// Reads things that are mapped as points, by the table of things.
#pragma once

#include <vector>

#include "compiler/map/features.h"
#include "compiler/map/read_context.h"
#include "compiler/map/things/thing_table.h"

namespace citykiln::map {

/// The things of a map.
struct LocatedThings {
  std::vector<ThingFeature> things;           ///< Inside the extent.
  std::vector<ThingFeature> supports_beyond;  ///< Nodes of power lines outside of it.
};

/// Returns the nodes that have a row in the table and are not read as points with a body (trees, lamps), with the roads
/// and rails that they belong to. A tag that cannot be read is diagnosed kBadTagValue. Dropped: kOutsideBounds, and
/// what standing.h says. Ledger "map/thing". O(nodes · rows + points of tracks).
///
/// @param features  Their tracks, points, barriers and power lines are used.
///
/// Source: wiki.openstreetmap.org, Key:direction: "forward" is for traffic along the way.
LocatedThings locate_things(const ReadContext& context, const ThingTable& table, const Features& features);

/// Returns the digits that a sign shows: those of maxspeed=*, else those in brackets or after the last hyphen of
/// traffic_sign=* ("DE:274[50]", "DE:274-50"); at most three, "" for none.
std::string digits_of(std::string_view maxspeed, std::string_view traffic_sign);

}  // namespace citykiln::map
