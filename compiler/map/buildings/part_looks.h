// Completes the use, colours and materials of building parts (building:part=*) by those of their building.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/map/read_context.h"

namespace citykiln::map {

/// Gives each part, except steps, what its tags do not say: the class, the year, the colour and the material of walls
/// and roof. They come from the outline that is in one relation of type=building with the part, else from the outline
/// around it, then from the tags of the relation itself. The outlines of a relation get them from its tags, too.
///
/// A part with a value of its own, such as building:part=garage, keeps its class; so do parts of roofs and shelters,
/// which have no use of their own. A part that states a material takes no colour. Diagnosed: kBadTagValue for values of
/// relations. O(n log n).
/// @param outlines  part_outlines() of the footprints.
void complete_looks(const ReadContext& context, std::vector<Footprint>& footprints,
                    std::span<const std::uint32_t> outlines);

}  // namespace citykiln::map
