#include "compiler/things/free_places.h"

#include <cmath>

#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"
#include "compiler/ground/plan.h"

namespace citykiln::things {
namespace {

using map::LandCoverClass;
using map::LandCoverGroup;

constexpr double kBlock_m = 256, kBlockMargin_m = 32, kStep_m = 0.25;
constexpr int kDirectionsAround = 16, kBorderPoints = 8;

// Street lamps have the same rule, but stand beside pedestrian streets too (may_have_lamps() of
// props/street_lamps.cpp).
bool is_barred(LandCoverClass surface) {
  if (surface == LandCoverClass::kPedestrianStreet) return false;
  switch (map::values_of(surface).group) {
    case LandCoverGroup::kRoad:
    case LandCoverGroup::kRail:
    case LandCoverGroup::kWater:
    case LandCoverGroup::kBuilding:
      return true;
    case LandCoverGroup::kPath:
      return surface != LandCoverClass::kFootPath && surface != LandCoverClass::kPavedFootPath;
    default:
      return surface == LandCoverClass::kParkingLane;
  }
}

}  // namespace

FreePlaces::FreePlaces(std::span<const ground::LandCoverPolygon> cover) : cover_(cover) {
  std::vector<Box2> boxes;
  for (const ground::LandCoverPolygon& surface : cover) {
    const Box2 box = ground::box_of(surface);
    boxes.push_back(box.is_empty() ? Box2{{}, {}} : box);
  }
  near_ = grid_of(boxes, kBlock_m);
}

const FreePlaces::Block& FreePlaces::block_at(Vec2 at) {
  const auto column = static_cast<int>(std::floor(at.x / kBlock_m)),
             row = static_cast<int>(std::floor(at.y / kBlock_m));
  std::unique_ptr<Block>& block = blocks_[{column, row}];
  if (block) return *block;
  block = std::make_unique<Block>();
  const Vec2 corner{column * kBlock_m, row * kBlock_m};
  const Box2 box = Box2{corner, corner + Vec2{kBlock_m, kBlock_m}}.widened(kBlockMargin_m);
  for (const std::uint32_t i : boxes_about(near_, box)) {
    ground::LandCoverPolygon trimmed = ground::trimmed_to(cover_[i], box);
    if (!trimmed.rings.empty()) block->surfaces.push_back(std::move(trimmed));
  }
  block->index = ground::index_land_cover(block->surfaces, box);
  return *block;
}

const ground::LandCoverPolygon* FreePlaces::polygon_at(Vec2 at) {
  const Block& block = block_at(at);
  if (block.surfaces.empty()) return nullptr;
  const std::uint32_t top = ground::land_cover_at(block.index, at);
  return top == ground::kNoLandCover ? nullptr : &block.surfaces[top];
}

std::optional<LandCoverClass> FreePlaces::surface_at(Vec2 at) {
  const ground::LandCoverPolygon* top = polygon_at(at);
  return top == nullptr ? std::nullopt : std::optional(top->surface);
}

bool FreePlaces::is_barred_at(Vec2 at) {
  const std::optional<LandCoverClass> surface = surface_at(at);
  return surface && is_barred(*surface);
}

bool FreePlaces::is_free(Vec2 at, double radius_m) {
  if (is_barred_at(at)) return false;
  for (int i = 0; radius_m > 0 && i < kBorderPoints; ++i)
    if (is_barred_at(at + direction_of(static_cast<double>(i) / kBorderPoints) * radius_m)) return false;
  return true;
}

std::optional<Vec2> FreePlaces::nearest_free(Vec2 at, double radius_m) {
  if (is_free(at, radius_m)) return at;
  for (double off_m = kStep_m; off_m <= kMaxMove_m; off_m += kStep_m)
    for (int i = 0; i < kDirectionsAround; ++i) {
      const Vec2 place = snapped(at + direction_of(static_cast<double>(i) / kDirectionsAround) * off_m);
      if (is_free(place, radius_m)) return place;
    }
  return std::nullopt;
}

std::optional<Vec2> FreePlaces::first_free(Vec2 from, Vec2 direction, double radius_m) {
  for (double off_m = 0; off_m <= kMaxOffAxis_m; off_m += kStep_m)
    if (const Vec2 place = snapped(from + direction * off_m); is_free(place, radius_m)) return place;
  return std::nullopt;
}

std::optional<WallPlace> FreePlaces::nearest_wall(Vec2 at, double before_m) {
  std::optional<WallPlace> nearest;
  double nearest_m = kMaxWall_m;
  for (const ground::LandCoverPolygon& surface : block_at(at).surfaces) {
    if (map::values_of(surface.surface).group != LandCoverGroup::kBuilding) continue;
    for (const Ring& ring : surface.rings)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()], on = nearest_point(a, b, at);
        if (a == b || distance(on, at) >= nearest_m) continue;
        const Vec2 out = left_of(unit(b - a)) * -1.0;  // rings run with the building on their left
        if (!is_free(snapped(on + out * before_m), 0)) continue;
        nearest_m = distance(on, at);
        nearest = WallPlace{on, out};
      }
  }
  return nearest;
}

}  // namespace citykiln::things
