// The heights of plants, from tags and by species. The height is the only scale of a prototype.
#pragma once

#include "compiler/map/plants/plant_kind.h"
#include "compiler/plants/species.h"

namespace citykiln::plants {

/// Returns the height that tags imply: by the crown's width, else by the trunk's girth, else by the year of planting; 0
/// without any of these. At most the species' tallest_m. Metres, rounded down to eighths.
double height_from_tags_m(const SpeciesValues& species, const map::PlantTags& plant_tags);

/// Returns the usual height of a free-standing plant without a tagged size.
double default_height_m(const SpeciesValues& species);

}  // namespace citykiln::plants
