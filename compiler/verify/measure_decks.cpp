#include "compiler/verify/measure_decks.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/map/features.h"
#include "compiler/structures/plates.h"

namespace citykiln::verify {
namespace {

constexpr double kDeckStep_m = 2, kPlateBucket_m = 64;

// The plates of all tiles, by place. A plate is in several tiles.
struct PlateIndex {
  std::vector<const structures::Plate*> plates;
  BoxGrid grid;
};

PlateIndex index_plates(const scene::Scene& scene) {
  PlateIndex index;
  std::vector<Box2> boxes;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const structures::Span& bridge : chunk.bridges)
      for (const structures::Plate& plate : bridge.plates) {
        Box2 box;
        for (const structures::PlatePart& part : plate.parts)
          for (const structures::PlateCorner& corner : part.rings.front()) box.grow(in_plan(corner.at));
        if (box.is_empty()) continue;
        index.plates.push_back(&plate);
        boxes.push_back(box);
      }
  index.grid = grid_of(boxes, kPlateBucket_m);
  return index;
}

// True for a bridge that an area has because no way of the map runs over it. Rails of a street are derived, too.
bool is_axis_of_area(const structures::Span& bridge) {
  return is_derived(bridge.id) && map::values_of(bridge.surface).group != map::LandCoverGroup::kRail;
}

bool has_own_plate(const PlateIndex& index, const structures::Span& bridge) {
  return std::ranges::any_of(boxes_about(index.grid, box_of(bridge.axis)),
                             [&](std::uint32_t i) { return index.plates[i]->id == bridge.id.osm; });
}

bool is_on_any_plate(const PlateIndex& index, Vec2 p) {
  return std::ranges::any_of(boxes_about(index.grid, p),
                             [&](std::uint32_t i) { return structures::is_on_plate(*index.plates[i], p); });
}

// True if a plate lies below half of the axis in the extent.
bool lies_on_plates(const PlateIndex& index, const Polyline& axis, const Box2& extent) {
  int places = 0, on = 0;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const int steps = std::max(1, static_cast<int>(std::ceil(distance(axis[i], axis[i + 1]) / kDeckStep_m)));
    for (int k = 0; k < steps; ++k) {
      const Vec2 p = axis[i] + (axis[i + 1] - axis[i]) * ((k + 0.5) / steps);
      if (!extent.contains(p)) continue;
      ++places;
      on += is_on_any_plate(index, p);
    }
  }
  return 2 * on >= places;
}

}  // namespace

BridgesOnAreas measure_decks(const scene::Scene& scene) {
  const PlateIndex index = index_plates(scene);
  BridgesOnAreas found;
  for (const scene::Chunk& chunk : scene.chunks)
    for (const structures::Span& bridge : chunk.bridges) {
      const bool is_axis = is_axis_of_area(bridge);
      if (bridge.deck == structures::DeckForm::kOwn && !is_axis) continue;
      if (scene::baking_tile(scene.header, bridge) != chunk.tile) continue;
      ++found.tests;
      // an axis joins places on the outline, so it may run beside an area that is bent
      if ((is_axis && has_own_plate(index, bridge)) || lies_on_plates(index, bridge.axis, scene.header.extent))
        continue;
      if (found.missing++ == 0) found.at = bridge.axis.front(), found.element = bridge.id.osm;
    }
  return found;
}

}  // namespace citykiln::verify
