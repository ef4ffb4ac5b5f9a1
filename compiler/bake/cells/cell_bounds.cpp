// cell_bounds() of bake_cell.h.
#include <algorithm>
#include <cmath>
#include <concepts>

#include "compiler/bake/cells/bake_cell.h"
#include "compiler/bake/ground/ground_beyond.h"
#include "compiler/bake/tile_levels.h"
#include "compiler/ground/plan.h"
#include "compiler/map/locate.h"
#include "compiler/plants/generate.h"
#include "compiler/props/street_lamps.h"

namespace citykiln::bake {
namespace {

// Lamps of streets, whose arms rise above the lamp's height.
constexpr double kStreetLampTop_m = props::kTallestStreetLamp_m + 0.5;
// The reach of crowns, and an upper bound of that of lamps' arms and tree pits.
constexpr double kCrown_m = plants::kCrownReach * plants::kTallestPlant_m, kBeside_m = 4;

void grow(Bounds& bounds, const Bounds& more) {
  bounds.plan.grow(more.plan.min), bounds.plan.grow(more.plan.max);
  bounds.low_m = std::min(bounds.low_m, more.low_m), bounds.high_m = std::max(bounds.high_m, more.high_m);
}

Bounds widened_bounds(Bounds bounds, double by_m) {
  bounds.plan = bounds.plan.widened(by_m), bounds.low_m -= by_m, bounds.high_m += by_m;
  return bounds;
}

// The bounds of a tile's cells while objects are added.
class CellBoxes {
 public:
  CellBoxes(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view)
      : header_(header), chunk_(chunk), view_(view), tile_(scene::box_of(header, chunk.tile)) {}

  std::vector<Bounds> all() {
    const std::vector<ViewCell> cells = cells_of(view_, tile_);
    for (const ViewCell& cell : cells) bounds_.push_back(ground_of(cell));
    for (const Box2& outside : ground_beyond(header_, chunk_))
      grow(bounds_[cell_beside(cells, outside)], ground_at(outside));
    for_each_bounded(chunk_, [&]<typename Object>(const Object&, const Bounds& bounds) {
      add(std::same_as<Object, props::Barrier> ? widened_bounds(bounds, kGraded_m) : bounds);
    });
    for (const things::Thing& thing : chunk_.things) add_thing(thing);
    for (const roads::Road& road : chunk_.roads)
      if (road.surface == map::LandCoverClass::kSteps) add_steps(road);
    return std::move(bounds_);
  }

 private:
  // Terrain, and the profiles of roads and water near a box.
  Bounds ground_at(const Box2& box) const {
    Bounds bounds = bounds_of(chunk_.heights, box);
    const Box2 near = box.widened(2 * kGraded_m);
    const auto take = [&](const Profile& profile, const Polyline& axis) {
      if (profile.empty() || !box_of(axis).touches(near)) return;
      const auto [low, high] = std::ranges::minmax(profile, {}, &Knot::z_m);
      bounds.low_m = std::min(bounds.low_m, low.z_m), bounds.high_m = std::max(bounds.high_m, high.z_m);
    };
    for (const roads::Road& road : chunk_.roads) take(road.profile, road.axis);
    for (const roads::Strip& strip : chunk_.watercourses) take(strip.profile, strip.axis);
    for (const ground::Landform& form : chunk_.landforms) take(form.profile, form.axis);
    for (const ground::LandCoverPolygon& surface : chunk_.surfaces)
      if (surface.level_m && ground::box_of(surface).touches(near))
        bounds.low_m = std::min(bounds.low_m, *surface.level_m),
        bounds.high_m = std::max(bounds.high_m, *surface.level_m);
    return bounds;
  }

  Bounds ground_of(const ViewCell& cell) const {
    const Box2& box = cell.level.cell;
    Bounds bounds = ground_at(box);
    bounds.low_m -= kGraded_m + cell.skirt_m + cell.level.tolerance_m;
    bounds.high_m += kGraded_m + cell.level.tolerance_m;
    const bool has_plants = may_have_plants(box);
    bounds.plan = bounds.plan.widened(has_plants ? kCrown_m : kBeside_m);
    bounds.high_m += has_plants ? plants::kTallestPlant_m : std::max(kStreetLampTop_m, tallest_lamp_m(box));
    return bounds;
  }

  double tallest_lamp_m(const Box2& box) const {
    double tallest_m = 0;
    for (const props::Lamp& lamp : chunk_.lamps)
      if (box.contains(lamp.at)) tallest_m = std::max(tallest_m, lamp.height_m);
    return tallest_m;
  }

  bool may_have_plants(const Box2& box) const {
    const Box2 near = box.widened(plants::kObstacleInfluence_m);
    const auto is_near = [&](const auto& plant) { return box_of(plant.axis).touches(near); };
    const auto is_hedge = [&](const props::Barrier& b) { return b.kind == map::BarrierKind::kHedge && is_near(b); };
    const auto touches = [&](const ObjectId& id) {
      return std::ranges::any_of(chunk_.surfaces,
                                 [&](const auto& s) { return s.id == id && ground::box_of(s).touches(near); });
    };
    return std::ranges::any_of(chunk_.trees, [&](const plants::Tree& tree) { return near.contains(tree.at); }) ||
           std::ranges::any_of(chunk_.tree_rows, is_near) || std::ranges::any_of(chunk_.barriers, is_hedge) ||
           std::ranges::any_of(chunk_.woods, [&](const plants::Wood& wood) { return touches(wood.surface); }) ||
           std::ranges::any_of(chunk_.plantings, [&](const plants::Planting& p) { return touches(p.surface); });
  }

  // With the tolerance of the object's level.
  void add(const Bounds& bounds) {
    const double tolerance_m = tolerance_m_of(view_.view, level_for(view_.view, bounds));
    grow(bounds_[cell_at(tile_, bounds.plan.centre())], widened_bounds(bounds, tolerance_m));
  }

  // The part of its tile's cell that a thing may reach into.
  void add_thing(const things::Thing& thing) {
    const Box2 box = Box2{thing.at, thing.at}.widened(length(Vec2{thing.form.width_m, thing.form.depth_m}) / 2);
    Bounds bounds = ground_at(box);
    bounds.low_m -= kGraded_m, bounds.high_m += kGraded_m + thing.form.height_m;
    if (thing.foot_m) bounds.low_m = *thing.foot_m, bounds.high_m = *thing.foot_m + thing.form.height_m;
    grow(bounds_[cell_at(tile_, thing.at)], bounds);
  }

  // The part of a road that has stairs in the tile, and its middle, are not known yet.
  void add_steps(const roads::Road& road) {
    const Box2 box = box_of(road.axis).widened(roads::max_offset_m(road) + 1);
    for (std::size_t i = 0; i < bounds_.size(); ++i)
      if (box.touches(cells_of(tile_)[i])) grow(bounds_[i], widened_bounds(ground_at(box), kBeside_m));
  }

  const scene::Header& header_;
  const scene::Chunk& chunk_;
  const ViewLevels& view_;
  Box2 tile_;
  std::vector<Bounds> bounds_;
};

}  // namespace

std::vector<Bounds> cell_bounds(const scene::Header& header, const scene::Chunk& chunk, const ViewLevels& view) {
  return CellBoxes(header, chunk, view).all();
}

}  // namespace citykiln::bake
