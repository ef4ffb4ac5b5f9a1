// What tags say of plants: their kind, their leaves, their size.
#pragma once

#include "compiler/map/plant_kind.h"
#include "compiler/map/read_context.h"

namespace citykiln::map {

/// By genus, species, taxon, trees, crop and produce, by the taxa of lsystems/species/species.inc; leaves by leaf_type,
/// leaf_cycle and the older wood=* and type=*; else by the kind. Sizes that cannot be read are diagnosed kBadTagValue.
PlantTags read_plant_tags(const ReadContext& context, OsmId id, source::Range tags);

/// height, est_height; 0 where nobody says. Metres.
double tagged_plant_height_m(const ReadContext& context, OsmId id, source::Range tags);

/// tree_lined=*.
TreeSides tree_sides_of(std::string_view tree_lined);

}  // namespace citykiln::map
