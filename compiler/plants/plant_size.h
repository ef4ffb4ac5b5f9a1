// How large plants get: what their prototypes' one scale, the height, is made from.
#pragma once

#include "compiler/map/plant_kind.h"
#include "compiler/plants/species.h"

namespace citykiln::plants {

/// A crown's width as a share of the plant's height.
double crown_share(Species species);

/// How high a plant of a species is as its tags tell: by its crown's width, else by its girth, else by the year it was
/// planted in; 0 where none is told. At most as tall as the species is drawn. Metres, in eighths.
double height_from_tags_m(Species species, const map::PlantTags& plant_tags);

/// How high a plant of a species mostly is where it stands alone and nobody says.
double default_height_m(Species species);

}  // namespace citykiln::plants
