// Parks, squares and other land without much on it.
#pragma once

#include "compiler/invent/invented_map.h"
#include "compiler/invent/town/blocks/block_room.h"

namespace citykiln::invent {

/// Adds the area and all that lies in it.
void add_park(const std::string& name, BlockRoom& room, InventedMap& map);
void add_square(const std::string& name, BlockRoom& room, InventedMap& map);
void add_cemetery(BlockRoom& room, InventedMap& map);
void add_allotments(BlockRoom& room, InventedMap& map);
void add_sports_ground(BlockRoom& room, InventedMap& map);

}  // namespace citykiln::invent
