// Reads things that are mapped as points, lines and areas, by the table of things.
#pragma once

#include <vector>

#include "compiler/map/features.h"
#include "compiler/map/tags/read_context.h"
#include "compiler/map/things/thing_table.h"

namespace citykiln::map {

/// The things of a map.
struct LocatedThings {
  std::vector<ThingFeature> things;           ///< Inside the extent.
  std::vector<ThingFeature> supports_beyond;  ///< Nodes of power lines outside of it.
};

/// Returns what find_things() finds, with the roads and rails that its nodes belong to. A tag that cannot be read is
/// diagnosed kBadTagValue. Dropped: kOutsideBounds, what standing.h says, and nodes of bridges and tunnels. Ledger
/// "map/thing". O(elements · rows of their keys + n log n), n: points of tracks, barriers and power lines.
///
/// @param features  The features that were read before things.
///
/// Source: wiki.openstreetmap.org, Key:direction: "forward" is for traffic along the way.
LocatedThings locate_things(const ReadContext& context, const ThingTable& table, const Features& features);

/// Returns the digits that a sign shows: those of maxspeed=*, else those in brackets or after the last hyphen of
/// traffic_sign=* ("DE:274[50]", "DE:274-50"); at most three, "" for none.
std::string digits_of(std::string_view maxspeed, std::string_view traffic_sign);

}  // namespace citykiln::map
