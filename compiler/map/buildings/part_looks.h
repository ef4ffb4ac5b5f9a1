// Gives building parts (building:part=*) the use, colours and materials of their building where their own tags do not
// state them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/map/tags/read_context.h"

namespace citykiln::map {

/// Sets values of building parts, in place, that their own tags leave open. Each value is taken from the first of these
/// whose own tags state it:
/// 1. the first member that is no part of a type=building relation of which the part is a member;
/// 2. the outline around the part;
/// 3. the tags of the relation. Members that are no parts take the values of these tags too.
///
/// | value | taken if |
/// |---|---|
/// | class | the part is kPlain, and the source is neither steps nor a building without walls |
/// | has_shop | the class may be taken, and the part is on the ground (min_height_m 0) |
/// | year | the part's is 0 |
/// | material of walls, of the roof | the part has none |
/// | colour of walls, of the roof | the part has neither this colour nor this material before the source is read |
///
/// Steps take nothing. Diagnosed: kBadTagValue for tags of relations that cannot be read. Cannot fail. O(n log n).
/// @param outlines  part_outlines() of the footprints: one index per footprint.
void complete_looks(const ReadContext& context, std::vector<Footprint>& footprints,
                    std::span<const std::uint32_t> outlines);

/// Diagnoses kPartUnlikeOutline for each part that differs from its outline (Footprint::outline) in a value which its
/// own tags do not state: the class, or the colour or material of walls or roof. It compares the footprints with the
/// tags of the map, so that it finds errors of complete_looks(). Not compared: parts that are steps, members of
/// type=building relations, and classes of outlines that are steps or have no walls. O(n log n).
void diagnose_unlike_parts(const ReadContext& context, std::span<const Footprint> footprints);

}  // namespace citykiln::map
