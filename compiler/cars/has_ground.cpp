#include "compiler/cars/has_ground.h"

#include <algorithm>
#include <array>

#include "compiler/contract/derived_id.h"

namespace citykiln::cars {
namespace {

using ground::LandCoverIndex;
using map::LandCoverClass;
using map::LandCoverGroup;

// A place may reach over the border of its ground by this much, since bays are as wide as their cells.
constexpr double kOver_m = 0.25;
// A car may reach over it by this much.
constexpr double kCarOver_m = 0.3125;

const ground::LandCoverPolygon* polygon_at(const LandCoverIndex& land_cover, Vec2 p) {
  if (!land_cover.box.contains(p)) return nullptr;
  const std::uint32_t top = ground::land_cover_at(land_cover, p);
  return top == ground::kNoLandCover ? nullptr : &land_cover.surfaces[top];
}

LandCoverClass class_at(const LandCoverIndex& land_cover, Vec2 p) {
  const ground::LandCoverPolygon* polygon = polygon_at(land_cover, p);
  return polygon ? polygon->surface : LandCoverClass::kUnknown;
}

// True if is_ground() holds for the polygons below the middle and along the long sides.
template <typename IsGround>
bool lies_on(const Place& place, const LandCoverIndex& land_cover, IsGround is_ground) {
  OrientedRect inner = rect_of(place);
  inner.length_m -= 2 * kOver_m, inner.width_m -= 2 * kOver_m;
  if (!is_ground(polygon_at(land_cover, place.at))) return false;
  // a corner of a building or a hedge may reach into a long side
  constexpr int kAlongSide = 6;
  const std::array<Vec2, 4> c = corners_of(inner);
  for (int i = 0; i <= kAlongSide; ++i) {
    const double share = static_cast<double>(i) / kAlongSide;
    for (const Vec2 p : {c[0] + (c[1] - c[0]) * share, c[3] + (c[2] - c[3]) * share})
      if (!is_ground(polygon_at(land_cover, p))) return false;
  }
  return true;
}

bool is_junction(const ground::LandCoverPolygon& polygon) { return polygon.id == junction_id(polygon.id); }

// True if a line of samples from kerb to kerb meets rails.
bool has_rails(const Place& place, const LandCoverIndex& land_cover) {
  constexpr double kSample_m = 0.75;
  const double across_m = length(place.across);
  const int samples = static_cast<int>(across_m / kSample_m) + 1;
  for (int i = 0; i <= samples; ++i) {
    const LandCoverClass at = class_at(land_cover, place.at + place.across * (static_cast<double>(i) / samples));
    if (map::values_of(at).group == LandCoverGroup::kRail) return true;
  }
  return false;
}

bool is_built_up(const Place& place, const LandCoverIndex& land_cover) {
  const int buildings = map::values_of(LandCoverClass::kBuilding).priority;
  return ground::clearance_m(land_cover, place.at, buildings, kBuiltUp_m) < kBuiltUp_m;
}

bool is_before_car_park(const Place& place, const LandCoverIndex& land_cover) {
  const Vec2 behind = place.at - unit(place.across) * (place.width_m / 2 + 1);
  const LandCoverClass at = class_at(land_cover, behind);
  return at == LandCoverClass::kParking || map::values_of(at).group == LandCoverGroup::kRoad;
}

bool is_free_carriageway(const Place& place, const LandCoverIndex& land_cover) {
  if (has_rails(place, land_cover)) return false;
  if (place.kind != PlaceKind::kKerb) return true;
  return is_built_up(place, land_cover) && !is_before_car_park(place, land_cover);
}

bool is_paved_or_yard(const ground::LandCoverPolygon* polygon) {
  if (!polygon) return false;
  switch (polygon->surface) {
    case LandCoverClass::kParking:
    case LandCoverClass::kPavedYard:
    case LandCoverClass::kAsphaltYard:
    case LandCoverClass::kGravelYard:
    case LandCoverClass::kEarthYard:
    case LandCoverClass::kDrive:
    case LandCoverClass::kGravelDrive:
    case LandCoverClass::kAsphaltDrive:
      return true;
    default:
      return false;
  }
}

// True for unmapped land, and for the land use that a plot is named after. Another land use may lie above its paving.
bool is_ground_of_plot(const ground::LandCoverPolygon* polygon, OsmId plot) {
  if (!polygon || polygon->surface == LandCoverClass::kUnknown) return true;
  const LandCoverGroup group = map::values_of(polygon->surface).group;
  const bool is_use = group == LandCoverGroup::kTown || group == LandCoverGroup::kIndustry;
  return is_use && polygon->id.osm == plot && !ground::is_yard(*polygon);
}

bool is_open(const ground::LandCoverPolygon* polygon) {
  const LandCoverGroup group = map::values_of(polygon ? polygon->surface : LandCoverClass::kUnknown).group;
  return group != LandCoverGroup::kBuilding && group != LandCoverGroup::kWater && group != LandCoverGroup::kRail;
}

// True if a polygon is ground for the cars of a place.
bool is_ground_of(const Place& place, const ground::LandCoverPolygon* polygon) {
  if (place.surface != LandCoverClass::kUnknown) {
    const bool is_own = polygon && polygon->surface == place.surface;
    return is_own && (place.across == Vec2{} || !is_junction(*polygon));
  }
  if (place.kind == PlaceKind::kSpace) return is_open(polygon);
  if (place.kind == PlaceKind::kPlot) return is_ground_of_plot(polygon, place.feature);
  return is_paved_or_yard(polygon);
}

}  // namespace

bool has_ground(const Place& place, const LandCoverIndex& land_cover) {
  const auto is_ground = [&](const ground::LandCoverPolygon* polygon) { return is_ground_of(place, polygon); };
  return lies_on(place, land_cover, is_ground) && (place.across == Vec2{} || is_free_carriageway(place, land_cover));
}

bool is_on_ground(const OrientedRect& car, const Place& place, const LandCoverIndex& land_cover) {
  OrientedRect inner = car;
  inner.length_m -= 2 * kCarOver_m, inner.width_m -= 2 * kCarOver_m;
  return std::ranges::all_of(corners_of(inner), [&](Vec2 p) { return is_ground_of(place, polygon_at(land_cover, p)); });
}

}  // namespace citykiln::cars
