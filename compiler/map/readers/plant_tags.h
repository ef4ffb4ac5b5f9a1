// Reads tags of plants: kind, leaf type, size.
#pragma once

#include "compiler/map/plants/plant_kind.h"
#include "compiler/map/tags/read_context.h"

namespace citykiln::map {

/// Reads the kind from genus, species, taxon, trees, crop and produce, by the taxa of lsystems/species/species.inc, and
/// the leaf type from leaf_type, wood, type and leaf_cycle: the first of these whose value is known, else kUnknown.
/// Names of user-defined species are looked for first. Sizes that cannot be read are diagnosed kBadTagValue.
PlantTags read_plant_tags(const ReadContext& context, OsmId id, source::Range tags);

/// Returns 1 plus the index of the first row of the user-defined spawners that fits the tags; 0 if none does.
std::uint8_t tagged_spawner(const ReadContext& context, source::Range tags);

/// Returns height=* or est_height=* in metres; 0: not tagged.
double tagged_plant_height_m(const ReadContext& context, OsmId id, source::Range tags);

/// Returns the sides named by tree_lined=*.
TreeSides tree_sides_of(std::string_view tree_lined);

}  // namespace citykiln::map
