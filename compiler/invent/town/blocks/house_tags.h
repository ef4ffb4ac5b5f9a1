// Tags of houses: kinds, storeys, roofs, walls.
#pragma once

#include "compiler/invent/invented_map.h"
#include "compiler/invent/town/draws.h"
#include "compiler/invent/town/quarters.h"

namespace citykiln::invent {

/// The storeys of a house with this density about it: more in cities, with some spread.
int storeys_at(const TownPlan& plan, double density, BlockUse use, Draws& draws);

/// Returns the tags of a main building on a lot.
Tags house_tags(BlockUse use, int storeys, bool is_corner, Draws& draws);

/// Returns the tags of a garage, shed, barn and the like, by the value of building=*.
Tags outhouse_tags(const char* building, Draws& draws);

/// Adds the colour and material of plastered, brick or other walls.
void paint_walls(Tags& tags, Draws& draws);

}  // namespace citykiln::invent
