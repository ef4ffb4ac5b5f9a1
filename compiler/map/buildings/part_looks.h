// Completes the use, colours and materials of building parts (building:part=*) by those of their building.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/map/tags/read_context.h"

namespace citykiln::map {

/// Completes each part of a building, except steps, from the first of these that has a value: the member of its
/// type=building relation that is no part, the outline around it, the tags of the relation. Values are the class, the
/// shop (for parts on the ground), the year, and colour and material of walls and roof. Members that are no parts take
/// the values of their relation.
///
/// Only parts of class kPlain take a class, and neither that of steps nor of a building without walls. A surface whose
/// material is tagged takes no colour. Changes `footprints` in place. Diagnosed: kBadTagValue for values of relations.
/// O(n log n).
/// @param outlines  part_outlines() of the footprints.
void complete_looks(const ReadContext& context, std::vector<Footprint>& footprints,
                    std::span<const std::uint32_t> outlines);

/// Diagnoses kPartUnlikeOutline for each part whose tags do not say its use, colour or material while those of its
/// outline do, and which does not look like the outline. Steps and members of type=building relations do not count.
/// Compares the footprints with the tags of the map, so that it does not depend on complete_looks(). O(n log n).
void diagnose_unlike_parts(const ReadContext& context, std::span<const Footprint> footprints);

}  // namespace citykiln::map
