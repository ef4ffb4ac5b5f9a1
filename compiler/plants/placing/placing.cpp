#include "compiler/plants/placing/placing.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"

namespace citykiln::plants {
namespace {

// Distance to water in which wet species grow; less than the terrain's shores cover.
constexpr double kByWater_m = 12;

bool is_by_water(const ground::GradedTerrain& ground, Vec2 p) {
  if (boxes_about(ground.shores, p).empty() || !ground.wet_index.box.contains(p)) return false;
  return clearance_m(ground.wet_index, p, 0, kByWater_m) < kByWater_m;
}

}  // namespace

std::vector<Vec2> spaced_along(const Polyline& axis, double spacing_m) {
  const double length = length_m(axis);
  const auto gaps = std::max<std::uint32_t>(1, static_cast<std::uint32_t>(std::ceil(length / spacing_m)));
  const bool is_closed = axis.size() > 3 && axis.front() == axis.back();
  std::vector<Vec2> places;
  double passed_m = 0;
  std::size_t segment = 0;
  for (std::uint32_t i = 0; i < gaps + (is_closed ? 0 : 1); ++i) {
    const double at_m = length * i / gaps;
    while (segment + 2 < axis.size() && passed_m + distance(axis[segment], axis[segment + 1]) < at_m)
      passed_m += distance(axis[segment], axis[segment + 1]), ++segment;
    const Vec2 a = axis[segment], b = axis[segment + 1];
    places.push_back(snapped(a + (b - a) * std::min((at_m - passed_m) / distance(a, b), 1.0)));
  }
  return places;
}

void place_plant_along(PlacedPlants& placed, const PlacingContext& context, Species species, Vec2 at, double height_m,
                       Vec2 along, const RandomSequence& draw, OsmId feature) {
  assert(height_m > 0);
  const auto variant = static_cast<std::uint8_t>(draw.unit(kVariantDraw) * kVariants);
  const Vec3 foot = snapped(at_height(at, land_m(context.ground, at)));
  placed[{species, variant}].push_back({.at = foot,
                                        .cos_yaw = along.x,
                                        .sin_yaw = along.y,
                                        .scale = std::min(height_m, kTallestPlant_m),
                                        .feature = feature});
}

void place_plant(PlacedPlants& placed, const PlacingContext& context, Species species, Vec2 at, double height_m,
                 const RandomSequence& draw, OsmId feature) {
  place_plant_along(placed, context, species, at, height_m, direction_of(draw.unit(kYawDraw)), draw, feature);
}

bool is_blocked_ground(const ground::LandCoverIndex& land_cover, Vec2 p) {
  const std::uint32_t top = ground::land_cover_at(land_cover, p);
  if (top == ground::kNoLandCover) return false;
  const map::LandCoverClass surface = land_cover.surfaces[top].surface;
  const map::LandCoverGroup group = map::values_of(surface).group;
  if (surface == map::LandCoverClass::kPedestrianStreet) return false;
  return group == map::LandCoverGroup::kRoad || group == map::LandCoverGroup::kRail ||
         group == map::LandCoverGroup::kBuilding || group == map::LandCoverGroup::kWater;
}

Habitat habitat_of(const PlacingContext& context, Vec2 p) {
  const map::Heightfield& terrain = context.ground.terrain;
  return habitat_at(climate_mix_at(context.climate, p), context.latitude_deg, p, height_m_at(terrain, p),
                    normal_at(terrain, p), is_by_water(context.ground, p));
}

}  // namespace citykiln::plants
