// Street lamps, as mapped and as built.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/props/plan.h"
#include "compiler/props/street_lamps.h"
#include "compiler/roads/roads_on_ground.h"
#include "compiler/scene/land_cover.h"
#include "tests/charts/assumed_values.h"

namespace citykiln::charts {
namespace {

using roads::Road;

/// The farthest a lamp stands from the edge of its street; the shortest street and the fewest lamps that are measured.
constexpr double kFromEdge_m = 8, kShortestStreet_m = 60;
constexpr std::size_t kFewestLamps = 3;
/// Lamps on both sides of a street that stand across from each other are one place along it.
constexpr double kAcross_m = 3;
/// Sides count where this share of lamps stands on one of them.
constexpr double kOnOneSide = 0.8;
constexpr double kStreetBucket_m = 64, kCoverMargin_m = 64;

/// The lamps of one street.
struct LampsOfStreet {
  double length_m = 0;
  std::vector<double> along_m;  ///< Sorted.
  std::size_t left = 0;         ///< The number of lamps on the left.
  Vec2 at;
  int kind = 0;
};
using LampsByStreet = std::map<OsmId, LampsOfStreet>;

bool may_be_lit(const Road& road) { return map::values_of(road.surface).group == map::LandCoverGroup::kRoad; }

/// A place of a street's axis.
struct OnStreet {
  std::size_t road = 0;
  double from_edge_m = 0, along_m = 0;
  bool is_left = false;
};

OnStreet nearest_on_street(const Road& road, std::size_t number, Vec2 p) {
  OnStreet nearest{number, kFromEdge_m, 0, false};
  double start_m = road.start_along_m;
  for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
    const Vec2 a = road.axis[i], b = road.axis[i + 1], q = nearest_point(a, b, p);
    const bool is_left = cross(b - a, p - a) > 0;
    const double from_edge_m = distance(p, q) - (is_left ? roads::left_m(road) : roads::right_m(road));
    if (from_edge_m < nearest.from_edge_m) nearest = {number, from_edge_m, start_m + distance(a, q), is_left};
    start_m += distance(a, b);
  }
  return nearest;
}

/// Streets, found by place.
struct StreetIndex {
  std::vector<Road> streets;
  BoxGrid grid;

  /// The street whose edge is nearest to a lamp.
  std::optional<OnStreet> street_at(Vec2 p) const {
    std::optional<OnStreet> nearest;
    if (streets.empty()) return nearest;
    for (const std::uint32_t i : boxes_about(grid, p))
      if (const OnStreet on = nearest_on_street(streets[i], i, p);
          on.from_edge_m < (nearest ? nearest->from_edge_m : kFromEdge_m))
        nearest = on;
    return nearest;
  }
};

StreetIndex street_index(const std::vector<Road>& roads) {
  StreetIndex index;
  std::vector<Box2> boxes;
  for (const Road& road : roads) {
    if (!may_be_lit(road)) continue;
    index.streets.push_back(road);
    boxes.push_back(box_of(road.axis).widened(roads::max_offset_m(road) + kFromEdge_m));
  }
  if (!boxes.empty()) index.grid = grid_of(boxes, kStreetBucket_m);
  return index;
}

double length_of_road_m(const Road& road) { return distances_along(road).back() - road.start_along_m; }

LampsByStreet lamps_by_street(const std::vector<Road>& roads, const std::vector<props::StreetLamp>& lamps) {
  const StreetIndex index = street_index(roads);
  LampsByStreet streets;
  for (const Road& road : index.streets) {
    LampsOfStreet& street = streets[road.id.osm];
    street.length_m += length_of_road_m(road);
    street.at = box_of(road.axis).centre(), street.kind = static_cast<int>(road.surface);
  }
  for (const props::StreetLamp& lamp : lamps) {
    const auto on = index.street_at(lamp.at);
    if (!on) continue;
    LampsOfStreet& street = streets[index.streets[on->road].id.osm];
    street.along_m.push_back(on->along_m), street.left += on->is_left ? 1 : 0;
  }
  for (auto& [id, street] : streets) std::ranges::sort(street.along_m);
  return streets;
}

/// The lamps of a map: the mapped ones, and those along lit streets.
LampsByStreet built_lamps(const map::Features& features) {
  Report ignored;
  const std::vector<Road> roads = roads::roads_on_ground(features, ignored);
  const std::vector<props::Lamp> mapped = props::plan(features, {}, ignored).lamps;
  scene::CoverRecipes recipes{
      .areas = {}, .roads = roads, .junctions = {}, .watercourses = {}, .landforms = {}, .footprints = {}};
  for (const map::Footprint& footprint : features.footprints)
    if (!footprint.is_part && !footprint.is_open)
      recipes.footprints.push_back(scene::footprint_surface(footprint.id, footprint.polygon));
  const std::vector<ground::LandCoverPolygon> surfaces = scene::coarse_land_cover(recipes);
  const auto cover = ground::index_land_cover(surfaces, features.extent.widened(kCoverMargin_m));
  std::vector<props::StreetLamp> lamps = props::lamps_of_streets(roads, mapped, cover, features.extent);
  const std::vector<props::StreetLamp> single = props::mapped_lamps(mapped, roads);
  lamps.insert(lamps.end(), single.begin(), single.end());
  return lamps_by_street(roads, lamps);
}

double lamps_per_km(const LampsOfStreet& street) {
  return static_cast<double>(street.along_m.size()) / street.length_m * 1000;
}

/// The median distance between lamps, or nothing for a single place.
std::optional<double> median_spacing_m(const LampsOfStreet& street) {
  std::vector<double> gaps_m;
  for (std::size_t i = 1; i < street.along_m.size(); ++i)
    if (const double gap_m = street.along_m[i] - street.along_m[i - 1]; gap_m > kAcross_m) gaps_m.push_back(gap_m);
  if (gaps_m.empty()) return std::nullopt;
  std::ranges::nth_element(gaps_m, gaps_m.begin() + static_cast<std::ptrdiff_t>(gaps_m.size() / 2));
  return gaps_m[gaps_m.size() / 2];
}

double share_on_left(const LampsOfStreet& street) {
  return static_cast<double>(street.left) / static_cast<double>(street.along_m.size());
}

/// Only mapped lamps: lit streets of the map have none of their own.
LampsByStreet mapped_lamps_of(const Place& place) {
  map::Features features = place.mapped;
  for (map::Track& track : features.tracks) track.is_lit = false;
  return built_lamps(features);
}

/// A value of the lamps of a street; nothing if they have none.
using LampValue = std::optional<double> (*)(const LampsOfStreet& street);

std::vector<Sample> lamp_samples(const Place& place, LampValue value_of) {
  std::vector<Sample> samples;
  for (const auto& [id, street] : mapped_lamps_of(place)) {
    if (street.along_m.size() < kFewestLamps || street.length_m < kShortestStreet_m) continue;
    if (const auto value = value_of(street))
      samples.push_back({.key = {id, 0}, .at = street.at, .kind = street.kind, .tagged = *value});
  }
  return samples;
}

Values lamp_values(const map::Features& features, LampValue value_of) {
  Values values;
  for (const auto& [id, street] : built_lamps(features))
    if (const auto value = value_of(street)) values[{id, 0}] = *value;
  return values;
}

std::optional<double> per_km_of(const LampsOfStreet& street) { return lamps_per_km(street); }

std::optional<double> left_of_most(const LampsOfStreet& street) {
  if (street.along_m.empty()) return std::nullopt;
  const double left = share_on_left(street);
  return left >= kOnOneSide ? std::optional(1.0) : left <= 1 - kOnOneSide ? std::optional(0.0) : std::nullopt;
}

}  // namespace

std::vector<Sample> tagged_lamps_per_km(const Place& place) { return lamp_samples(place, per_km_of); }
Values built_lamps_per_km(const map::Features& features) { return lamp_values(features, per_km_of); }

std::vector<Sample> tagged_lamp_spacings(const Place& place) { return lamp_samples(place, median_spacing_m); }
Values built_lamp_spacings(const map::Features& features) { return lamp_values(features, median_spacing_m); }

std::vector<Sample> tagged_lamp_sides(const Place& place) { return lamp_samples(place, left_of_most); }
Values built_lamp_sides(const map::Features& features) { return lamp_values(features, left_of_most); }

}  // namespace citykiln::charts
