#include "compiler/furniture/utility_poles.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/contract/derived_id.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/line_part.h"
#include "compiler/geometry/snap.h"
#include "compiler/roads/width_limits/narrowed_section.h"
#include "compiler/things/facing.h"
#include "compiler/things/street_kinds.h"

namespace citykiln::furniture {
namespace {

using map::LandCoverClass;

constexpr double kBehindEdge_m = 0.4, kInsideEdge_m = 0.25, kFoot_m = 0.4;
// Poles stand between stations, so that they do not stand in furniture.
constexpr double kFirstPole_m = 2;
constexpr double kPoleWidth_m = 2.25, kPoleDepth_m = 0.5, kPoleHeight_m = 9.5;

bool is_main_street(LandCoverClass surface) {
  return surface == LandCoverClass::kSecondaryRoad || surface == LandCoverClass::kTertiaryRoad;
}

bool is_wide_pavement(const map::Lane& lane) {
  return lane.is_raised && lane.kind == map::LaneKind::kSidewalk && lane.width_m >= kCentrePavement_m;
}

bool may_have_poles(const roads::Road& road) {
  const bool is_street = is_main_street(road.surface) || road.surface == LandCoverClass::kResidentialRoad;
  return is_street && std::ranges::none_of(road.section.lanes, is_wide_pavement);
}

StableId poles_of(const roads::Road& road) { return stable_id(stable_id(road.id), "utility poles", 0); }

bool draws_poles(const roads::Road& road, std::uint64_t seed) {
  const things::UtilityPoleShare* share = things::utility_pole_share(road.country);
  if (!share) return false;
  const int percent = is_main_street(road.surface) ? share->main_percent : share->other_percent;
  return 100 * RandomSequence(seed, poles_of(road), "poles").unit(0) < percent;
}

bool is_on_left(const roads::Road& road, std::uint64_t seed) {
  return RandomSequence(seed, poles_of(road), "side").below(2, 0) == 0;
}

// The distance of poles from the axis, to the left positive.
double pole_offset_m(const roads::Road& road, double along_m, bool is_left) {
  const roads::RoadEdges edges = roads::road_edges_at(road, along_m);
  const double kerb_m = is_left ? edges.kerb_left_m : edges.kerb_right_m;
  const double outer_m = is_left ? edges.left_m : edges.right_m;
  const double off_m = outer_m > kerb_m ? kerb_m + std::min(kBehindEdge_m, outer_m - kerb_m) : kerb_m - kInsideEdge_m;
  return is_left ? off_m : -off_m;
}

bool is_of_concrete(map::CountryGroup country) {
  return country == map::CountryGroup::kJapan || country == map::CountryGroup::kSouthAsia ||
         country == map::CountryGroup::kSouthEastAsia || country == map::CountryGroup::kLatinAmerica;
}

// One pole in four has a transformer.
things::Form form_of_pole(const roads::Road& road, std::int64_t k, std::uint64_t seed) {
  const StableId key = stable_id(poles_of(road), "pole", static_cast<std::uint64_t>(k));
  return {.kind = std::string(things::kUtilityPole),
          .width_m = snapped(kPoleWidth_m),
          .depth_m = snapped(kPoleDepth_m),
          .height_m = snapped(kPoleHeight_m),
          .value = RandomSequence(seed, key, "transformer").below(4, 0) == 0 ? "transformer" : "",
          .material = is_of_concrete(road.country) ? "concrete" : "",
          .country = road.country};
}

struct PolePlanner {
  const roadside::TileRecipes& recipes;
  const roadside::ClearZones& zones;
  std::uint64_t seed;

  bool is_free(Vec2 at, Vec2 ahead) const {
    if (!recipes.land_cover.box.contains(at)) return false;
    const int buildings = map::values_of(LandCoverClass::kBuilding).priority;
    if (ground::clearance_m(recipes.land_cover, at, buildings, kFoot_m) < kFoot_m) return false;
    const std::uint32_t top = ground::land_cover_at(recipes.land_cover, at);
    const bool is_water = top != ground::kNoLandCover &&
                          map::values_of(recipes.land_cover.surfaces[top].surface).group == map::LandCoverGroup::kWater;
    const OrientedRect foot{.at = at, .ahead = ahead, .length_m = kFoot_m, .width_m = kFoot_m};
    return !is_water && roadside::is_clear(zones.streets, foot);
  }

  // The k-th pole of a road, if it stands free.
  std::optional<things::Thing> pole(const roads::Road& road, const std::vector<double>& along, std::int64_t k) const {
    const double at_m = kFirstPole_m + static_cast<double>(k) * kPoleStep_m;
    const Vec2 on_axis = point_at(road.axis, along, at_m);
    const Vec2 ahead = unit(point_at(road.axis, along, std::min(at_m + 1, along.back())) - on_axis);
    if (ahead == Vec2{}) return std::nullopt;
    const Vec2 at = on_axis + left_of(ahead) * pole_offset_m(road, at_m, is_on_left(road, seed));
    if (!is_free(at, ahead)) return std::nullopt;
    return things::Thing{.id = roadside_id(road.id, static_cast<std::uint32_t>(k)),
                         .at = snapped(at),
                         .direction = things::nearest_direction(ahead),
                         .is_in_way = true,
                         .form = form_of_pole(road, k, seed)};
  }
};

void add_line_of(const roads::Road& road, const PolePlanner& planner, const Box2& box, UtilityPoles& made) {
  const Box2 about = box.widened(kLongestPoleSpan_m / 2);
  const std::vector<double> along = roads::distances_along(road);
  const auto first = static_cast<std::int64_t>(std::ceil((along.front() - kFirstPole_m) / kPoleStep_m));
  std::optional<std::uint32_t> last;
  for (std::int64_t k = std::max<std::int64_t>(first, 0);
       kFirstPole_m + static_cast<double>(k) * kPoleStep_m < along.back(); ++k) {
    std::optional<things::Thing> pole = planner.pole(road, along, k);
    if (!pole || !about.contains(pole->at)) continue;
    const auto here = static_cast<std::uint32_t>(made.poles.size());
    if (last && distance(made.poles[*last].at, pole->at) <= kLongestPoleSpan_m &&
        box.contains_half_open((made.poles[*last].at + pole->at) * 0.5))
      made.spans.push_back({.id = pole->id, .from = *last, .to = here});
    made.poles.push_back(std::move(*pole));
    last = here;
  }
}

}  // namespace

UtilityPoles utility_poles(const roadside::TileRecipes& recipes, const roadside::ClearZones& zones, std::uint64_t seed,
                           const Box2& box) {
  UtilityPoles made;
  const PolePlanner planner{recipes, zones, seed};
  for (const roads::Road& road : recipes.roads)
    if (may_have_poles(road) && draws_poles(road, seed)) add_line_of(road, planner, box, made);
  return made;
}

}  // namespace citykiln::furniture
