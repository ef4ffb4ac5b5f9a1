#include <vector>

#include "compiler/contract/derived_id.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/segment.h"
#include "compiler/verify/assumed/measure_assumed.h"
#include "compiler/verify/standing/taken_land.h"

namespace citykiln::verify {
namespace {

using map::LandCoverClass;
using map::LandCoverGroup;

constexpr double kYardGrid_m = 4, kInBarrier_m = 0.25;
// Houses of neighbouring lots may touch.
constexpr double kInsideWall_m = 0.125;

// The mapped element in or below which a tree of a yard stands; none if its place is free.
OsmId no_place_for_tree(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover, Vec2 p) {
  if (const std::uint32_t top = ground::land_cover_at(land_cover, p); top != ground::kNoLandCover) {
    const ground::LandCoverPolygon& surface = land_cover.surfaces[top];
    const OsmId taken = taken_element_at(land_cover, p);
    if (taken.type != OsmType::kNone) return taken;
    if (map::values_of(surface.surface).group == LandCoverGroup::kPath) return surface.id.osm;
  }
  for (const plants::PowerLineCorridor& wire : chunk.corridors)
    if (distance_to_polyline(wire.axis, p) < wire.width_m / 2) return wire.id.osm;
  for (const props::Barrier& barrier : chunk.barriers)
    if (distance_to_polyline(barrier.axis, p) < barrier.width_m / 2 + kInBarrier_m) return barrier.id.osm;
  return {};
}

// True for mapped land on which no yard may lie.
bool is_finer_than_use(const ground::LandCoverPolygon& surface) {
  return !ground::is_yard(surface) && !is_of_field(surface.id) && surface.surface != LandCoverClass::kUnknown &&
         surface.surface != LandCoverClass::kResidential && surface.surface != LandCoverClass::kCommercial &&
         surface.surface != LandCoverClass::kRetail && surface.surface != LandCoverClass::kIndustrial;
}

// Mapped land with an index of its boxes.
struct FinerLand {
  std::vector<const ground::LandCoverPolygon*> all;
  BoxGrid grid;
};

FinerLand finer_land(const scene::Chunk& chunk) {
  FinerLand land;
  std::vector<Box2> boxes;
  for (const ground::LandCoverPolygon& surface : chunk.surfaces) {
    const Box2 box = ground::box_of(surface);
    if (!is_finer_than_use(surface) || box.is_empty()) continue;
    land.all.push_back(&surface);
    boxes.push_back(box);
  }
  if (!boxes.empty()) land.grid = grid_of(boxes, 32);
  return land;
}

// True if a place lies in a polygon, and not on its border, where either side may be on top: outlines of lots are off
// by up to 0.3 m (lots/coarse_outlines.h).
bool is_well_inside(const ground::LandCoverPolygon& surface, Vec2 p) {
  constexpr double kBorder_m = 0.3125;
  for (const Vec2 step : {Vec2{kBorder_m, 0}, Vec2{-kBorder_m, 0}, Vec2{0, kBorder_m}, Vec2{0, -kBorder_m}})
    if (ground::winding_number(surface, p + step) <= 0) return false;
  return true;
}

void test_yard_places(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover, const Box2& box,
                      AssumedTests& found) {
  const FinerLand land = finer_land(chunk);
  for (double x = box.min.x + kYardGrid_m / 2; x < box.max.x; x += kYardGrid_m)
    for (double y = box.min.y + kYardGrid_m / 2; y < box.max.y; y += kYardGrid_m) {
      const Vec2 p{x, y};
      const std::uint32_t top = ground::land_cover_at(land_cover, p);
      if (top == ground::kNoLandCover || !ground::is_yard(land_cover.surfaces[top])) continue;
      ++found.tested;
      if (land.all.empty()) continue;
      for (const std::uint32_t i : boxes_about(land.grid, p))
        if (is_well_inside(*land.all[i], p)) {
          if (found.conflicts++ == 0)
            found.at = p, found.element = land_cover.surfaces[top].id.osm, found.obstacle = land.all[i]->id.osm;
          break;
        }
    }
}

// The element on which a place of a house lies, other than the house's own lot; none if the place is free.
OsmId no_place_for_house(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover, OsmId lot, Vec2 p) {
  if (const std::uint32_t top = ground::land_cover_at(land_cover, p); top != ground::kNoLandCover) {
    const ground::LandCoverPolygon& surface = land_cover.surfaces[top];
    const bool is_mapped_path = map::values_of(surface.surface).group == LandCoverGroup::kPath;
    const OsmId on = is_mapped_path ? surface.id.osm : taken_element_at(land_cover, p);
    if (on.type != OsmType::kNone && on != lot) return on;
  }
  for (const buildings::Building& other : chunk.buildings)
    if (other.id.osm != lot && contains(other.footprint, p)) return other.id.osm;
  return {};
}

}  // namespace

AssumedTests measure_assumed_yards(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                   const Box2& box) {
  AssumedTests found;
  if (std::ranges::none_of(chunk.surfaces, ground::is_yard)) return found;
  for (const plants::Tree& tree : chunk.trees) {
    if (!is_derived(tree.id) || !box.contains_half_open(tree.at)) continue;
    ++found.tested;
    const OsmId on = no_place_for_tree(chunk, land_cover, tree.at);
    if (on.type != OsmType::kNone && found.conflicts++ == 0)
      found.at = tree.at, found.element = tree.id.osm, found.obstacle = on;
  }
  test_yard_places(chunk, land_cover, box, found);
  return found;
}

AssumedTests measure_assumed_houses(const scene::Chunk& chunk, const ground::LandCoverIndex& land_cover,
                                    const Box2& box) {
  AssumedTests found;
  for (const buildings::Building& house : chunk.buildings) {
    if (house.id.osm.type != OsmType::kLot) continue;
    const Ring& ring = house.footprint.outer;
    const Vec2 middle = centroid(house.footprint);
    for (std::size_t i = 0; i < ring.size(); ++i)
      for (const Vec2 wall : {ring[i], (ring[i] + ring[(i + 1) % ring.size()]) * 0.5}) {
        const Vec2 p = wall + unit(middle - wall) * kInsideWall_m;
        if (!box.contains_half_open(p)) continue;
        ++found.tested;
        const OsmId on = no_place_for_house(chunk, land_cover, house.id.osm, p);
        if (on.type != OsmType::kNone && found.conflicts++ == 0)
          found.at = p, found.element = house.id.osm, found.obstacle = on;
      }
  }
  return found;
}

}  // namespace citykiln::verify
