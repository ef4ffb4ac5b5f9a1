// Schools, churches and supermarkets, with the land about them.
#pragma once

#include "compiler/invent/invented_map.h"
#include "compiler/invent/town/blocks/block_room.h"

namespace citykiln::invent {

void add_school(const std::string& name, BlockRoom& room, InventedMap& map);
/// A church has a nave and a tower, parts of one building.
void add_church(const std::string& name, BlockRoom& room, InventedMap& map);
void add_supermarket(BlockRoom& room, InventedMap& map);

}  // namespace citykiln::invent
