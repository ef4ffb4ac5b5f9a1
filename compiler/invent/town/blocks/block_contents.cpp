#include "compiler/invent/town/blocks/block_contents.h"

#include "compiler/invent/town/blocks/block_room.h"
#include "compiler/invent/town/blocks/parks.h"
#include "compiler/invent/town/blocks/public_buildings.h"
#include "compiler/invent/town/town_names.h"

namespace citykiln::invent {
namespace {

void add_contents(const TownPlan& plan, const TownBlock& block, std::size_t number, InventedMap& map) {
  BlockRoom room(plan, block, number, "block contents");
  const std::string name = place_name(plan.settings.seed, number);
  switch (block.use) {
    case BlockUse::kPark:
      return add_park(name, room, map);
    case BlockUse::kSquare:
      return add_square(name, room, map);
    case BlockUse::kSchool:
      return add_school(name, room, map);
    case BlockUse::kChurch:
      return add_church(name, room, map);
    case BlockUse::kCemetery:
      return add_cemetery(room, map);
    case BlockUse::kSports:
      return add_sports_ground(room, map);
    case BlockUse::kAllotments:
      return add_allotments(room, map);
    case BlockUse::kMarket:
      return add_supermarket(room, map);
    default:
      return;
  }
}

}  // namespace

void add_block_contents(const TownPlan& plan, const std::vector<TownBlock>& blocks, InventedMap& map) {
  for (std::size_t i = 0; i < blocks.size(); ++i)
    if (!has_lots(blocks[i].use) && blocks[i].land.outer.size() >= 3) add_contents(plan, blocks[i], i, map);
}

}  // namespace citykiln::invent
