#include "compiler/verify/check_seams.h"

#include <fmt/format.h>

namespace citykiln::verify {

Borders borders_of(const bake::BakedTile& tile, const Box2& box) {
  return {border_edges_at_x(tile, box.min.x), border_edges_at_x(tile, box.max.x), border_edges_at_y(tile, box.min.y),
          border_edges_at_y(tile, box.max.y)};
}

void check_seams(const BordersByTile& borders, Check& seams) {
  for (const auto& [key, own] : borders) {
    const auto [level, tile] = key;
    if (const auto east = borders.find({level, {tile.x + 1, tile.y}}); east != borders.end()) {
      seams.test(borders_match(own.east, east->second.west),
                 fmt::format("{} and its eastern neighbour, level {}", to_string(tile), level));
    }
    if (const auto north = borders.find({level, {tile.x, tile.y + 1}}); north != borders.end()) {
      seams.test(borders_match(own.north, north->second.south),
                 fmt::format("{} and its northern neighbour, level {}", to_string(tile), level));
    }
  }
}

}  // namespace citykiln::verify
