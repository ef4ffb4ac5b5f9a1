#include "compiler/scene/ground_lookup.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace citykiln::scene {
namespace {

Vec2 nearest_in(const Box2& box, Vec2 p) {
  return {std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y)};
}

}  // namespace

GroundLookup::GroundLookup(const Scene& scene) {
  assert(!scene.chunks.empty());
  for (const Chunk& chunk : scene.chunks) {
    Tile tile{&chunk, box_of(scene.header, chunk.tile), {}};
    for (const ground::LandCoverPolygon& area : chunk.surfaces) tile.areas.push_back(ground::box_of(area));
    box_.grow(tile.box.min), box_.grow(tile.box.max);
    tiles_.push_back(std::move(tile));
  }
}

const GroundLookup::Tile& GroundLookup::nearest(Vec2 place) const {
  return *std::ranges::min_element(tiles_, {},
                                   [&](const Tile& tile) { return distance(place, nearest_in(tile.box, place)); });
}

GroundPlace GroundLookup::at(Vec2 place) const {
  const Tile& tile = nearest(place);
  const ground::LandCoverPolygon* top = nullptr;
  for (std::size_t i = 0; i < tile.areas.size(); ++i) {
    const ground::LandCoverPolygon& area = tile.chunk->surfaces[i];
    if (!tile.areas[i].contains(place) || (top != nullptr && !ground::covers(area, *top))) continue;
    if (ground::winding_number(area, place) > 0) top = &area;
  }
  const double terrain_m = map::height_m_at(tile.chunk->heights, place);
  if (top == nullptr) return {terrain_m, map::LandCoverClass::kUnknown};
  return {top->level_m.value_or(terrain_m), top->surface, top};
}

bool GroundLookup::is_in_tile(Vec2 place) const {
  return std::ranges::any_of(tiles_, [&](const Tile& tile) { return tile.box.contains(place); });
}

std::vector<Vec2> places_on_border(const Box2& box, int count) {
  std::vector<Vec2> places;
  for (int i = 0; i < count; ++i) {
    const double turn = 8.0 * i / count;
    const auto along = [](double t) {
      return std::clamp(t < 4 ? 2 - std::abs(t - 2) : std::abs(t - 6) - 2, -1.0, 1.0);
    };
    const double y = along(turn), x = along(turn + 2 >= 8 ? turn - 6 : turn + 2);
    constexpr double kInside = 0.998;
    places.push_back(box.centre() + Vec2{x * box.width() / 2, y * box.height() / 2} * kInside);
  }
  return places;
}

}  // namespace citykiln::scene
