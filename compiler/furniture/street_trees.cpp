#include "compiler/furniture/street_trees.h"

#include <algorithm>
#include <optional>

#include "compiler/contract/derived_id.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/furniture/stations.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/plants/species_mix.h"

namespace citykiln::furniture {
namespace {

using map::LandCoverClass;

struct LinedShare {
  map::CountryGroup country;
  int main_percent, other_percent;
};
constexpr LinedShare kLinedShares[] = {
#define STREET_TREES(country, main_percent, other_percent) {map::CountryGroup::country, main_percent, other_percent},
#include "compiler/furniture/street_trees.inc"
#undef STREET_TREES
};

constexpr double kInsidePavement_m = 0.8;
// The ground that a trunk and its pit take.
constexpr double kPit_m = 1.25;

bool is_main(LandCoverClass surface) {
  return surface == LandCoverClass::kPrimaryRoad || surface == LandCoverClass::kSecondaryRoad ||
         surface == LandCoverClass::kTertiaryRoad;
}

bool may_be_lined(const roads::Road& road) {
  return is_main(road.surface) || road.surface == LandCoverClass::kResidentialRoad;
}

bool is_lined(const roads::Road& road, const Station& station, std::uint64_t seed) {
  const auto* const share = std::ranges::find(kLinedShares, road.country, &LinedShare::country);
  if (share == std::end(kLinedShares)) return false;
  const int percent = is_main(road.surface) ? share->main_percent : share->other_percent;
  return 100 * RandomSequence(seed, station.side, "street trees").unit(0) < percent;
}

// The foot of a tree 4 m beside a station, if there is room.
std::optional<Vec2> foot_after(const Station& station) {
  const bool is_in_verge = station.verge_m >= kTreeVerge_m;
  if (!is_in_verge && station.room_m < kTreePavement_m) return std::nullopt;
  const Vec2 halfway = station.inner_edge + left_of(station.outward) * (kStationStep_m / 2);
  return halfway + station.outward * (is_in_verge ? -station.verge_m / 2 : kInsidePavement_m);
}

struct StreetTreePlanter {
  const roadside::TileRecipes& recipes;
  const roadside::ClearZones& zones;
  const MappedTrees& mapped;
  const DrawStreetSpecies& draw_species;
  std::uint64_t seed;
  const Box2& box;
  lots::Capsules lamps;

  bool lies_beside_carriageway(Vec2 at) const {
    if (!recipes.land_cover.box.contains(at)) return false;
    const std::uint32_t top = ground::land_cover_at(recipes.land_cover, at);
    if (top == ground::kNoLandCover) return false;
    const LandCoverClass surface = recipes.land_cover.surfaces[top].surface;
    return surface == LandCoverClass::kPavement || surface == LandCoverClass::kVerge;
  }

  bool has_mapped_trees_near(Vec2 at) const {
    const auto is_near_tree = [&](const plants::Tree& tree) {
      return !is_derived(tree.id) && distance(tree.at, at) < kMappedStreetTree_m;
    };
    const auto is_near_row = [&](const plants::TreeRow& row) {
      return distance_to_polyline(row.axis, at) < kMappedStreetTree_m;
    };
    return std::ranges::any_of(mapped.trees, is_near_tree) || std::ranges::any_of(mapped.rows, is_near_row);
  }

  bool is_free(Vec2 at, const Station& station) const {
    const OrientedRect pit{.at = at, .ahead = station.outward, .length_m = kPit_m, .width_m = kPit_m};
    return roadside::is_clear(zones.streets, pit) && roadside::is_clear(zones.doors, pit) &&
           roadside::is_clear(lamps, pit) && !overlaps_any(zones.things, pit, 0);
  }

  // The height that the distance from walls leaves room for; 0: none. The crowns of palms are narrow.
  double height_at(Vec2 at, plants::SpeciesMix species) const {
    const bool is_palm = species == plants::species_mix_of(plants::Species::kPalm);
    const double lowest_m = 6, highest_m = is_palm ? 16 : 12, per_distance = is_palm ? 4 : 2;
    const int buildings = map::values_of(LandCoverClass::kBuilding).priority;
    const double away_m = ground::clearance_m(recipes.land_cover, at, buildings, highest_m / per_distance);
    return away_m < kTreeFromWall_m ? 0 : snapped(std::clamp(per_distance * away_m, lowest_m, highest_m));
  }

  plants::SpeciesMix species_of(const roads::Road& road, Vec2 foot) const {
    return draw_species(foot, RandomSequence(seed, stable_id(ObjectId{road.id.osm, 0}), "street species").unit(0));
  }

  std::optional<plants::Tree> tree_at(const roads::Road& road, const Station& station) const {
    const std::optional<Vec2> foot = foot_after(station);
    if (!foot || !box.contains_half_open(*foot) || !lies_beside_carriageway(*foot)) return std::nullopt;
    const plants::SpeciesMix species = species_of(road, *foot);
    const double height_m = height_at(*foot, species);
    if (height_m == 0 || !is_free(*foot, station) || has_mapped_trees_near(*foot)) return std::nullopt;
    return plants::Tree{
        .id = roadside_id(road.id, station.number), .at = snapped(*foot), .height_m = height_m, .species_mix = species};
  }
};

std::vector<lots::Capsule> about_lamps(std::span<const props::StreetLamp> lamps) {
  std::vector<lots::Capsule> clear;
  for (const props::StreetLamp& lamp : lamps) clear.push_back({lamp.at, lamp.at, kTreeFromLamp_m});
  return clear;
}

}  // namespace

std::vector<plants::Tree> street_trees(const roadside::TileRecipes& recipes, const roadside::ClearZones& zones,
                                       const MappedTrees& mapped, const DrawStreetSpecies& draw_species,
                                       std::uint64_t seed, const Box2& box) {
  const StreetTreePlanter planter{
      recipes, zones, mapped, draw_species, seed, box, lots::index_capsules(about_lamps(recipes.lamps))};
  std::vector<plants::Tree> trees;
  for (const roads::Road& road : recipes.roads) {
    if (!may_be_lined(road)) continue;
    for (const Station& station : stations_along(road, box, kStationStep_m)) {
      if (!is_lined(road, station, seed)) continue;
      if (const std::optional<plants::Tree> tree = planter.tree_at(road, station)) trees.push_back(*tree);
    }
  }
  return trees;
}

}  // namespace citykiln::furniture
