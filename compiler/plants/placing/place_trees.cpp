#include <optional>

#include "compiler/geometry/trig.h"
#include "compiler/plants/placing/placing.h"
#include "compiler/plants/plant_size.h"

namespace citykiln::plants {
namespace {

constexpr double kSpread = 0.25;

struct GrownPlant {
  Species species;
  double height_m;
};

GrownPlant grown(const Tree& tree, const PlacingContext& context, const Draw& draw) {
  const Habitat habitat = habitat_of(context, tree.at);
  const Species species = draw_species(tree.species_mix, habitat, context.seed, draw.unit(kSpeciesDraw));
  if (tree.height_m > 0) return {species, tree.height_m};
  const double spread = draw.between(1 - kSpread, 1 + kSpread, kHeightDraw);
  return {species, default_height_m(species) * height_factor(habitat) * spread};
}

// Trees are mapped to half a metre, and roads' edges follow from default lane widths: a tree up to kInRoad_m inside a
// road stands kBesideRoad_m outside its edge.
constexpr double kInRoad_m = 2, kBesideRoad_m = 0.5, kStep_m = 0.25;
constexpr int kDirections = 16;

bool is_on_road(const ground::LandCoverIndex& map, Vec2 p) {
  const std::uint32_t top = ground::land_cover_at(map, p);
  return top != ground::kNoLandCover && map::values_of(map.surfaces[top].surface).group == map::LandCoverGroup::kRoad;
}

// The nearest place beside the road that contains p; none more than kInRoad_m inside.
std::optional<Vec2> beside_road(const ground::LandCoverIndex& map, Vec2 p) {
  if (!is_on_road(map, p)) return std::nullopt;
  for (double in_m = 0; in_m <= kInRoad_m; in_m += kStep_m)
    for (int i = 0; i < kDirections; ++i) {
      const Vec2 out = direction_of(i / double{kDirections});
      const Vec2 place = p + out * (in_m + kBesideRoad_m);
      if (!is_blocked_ground(map, p + out * in_m) && !is_blocked_ground(map, place)) return place;
    }
  return std::nullopt;
}

// The place of a tree, or none where it is dropped; the same for all tiles.
std::optional<Vec2> place_of(const ground::LandCoverIndex& map, Vec2 p) {
  if (!map.box.contains(p)) return std::nullopt;
  return is_blocked_ground(map, p) ? beside_road(map, p) : p;
}

}  // namespace

std::vector<Obstacle> place_trees(PlacedPlants& placed, std::span<const Tree> trees, const PlacingContext& context,
                                  Report& report) {
  std::vector<Obstacle> obstacles;
  Account account;
  for (const Tree& tree : trees) {
    const std::optional<Vec2> at = place_of(context.surfaces, tree.at);
    // a moved tree belongs to the tile of its new place
    const bool is_here = is_in_half_open(context.box, at.value_or(tree.at));
    if (is_here) ++account.in;
    if (is_here && !at) report.drop(account, Code::kTreeOnRoad, tree.id.osm);
    if (!at) continue;
    const Draw draw(context.seed, stable_id(tree.id), "tree");
    const auto [species, height_m] = grown(tree, context, draw);
    obstacles.push_back({*at, crown_clearance_m(species, height_m)});
    if (!is_here) continue;
    if (*at != tree.at) report.add(Code::kTreeMoved, tree.id.osm, distance(*at, tree.at));
    ++account.out;
    place_plant(placed, context, species, *at, height_m, draw, tree.id.osm);
  }
  report.account("bake", "tree") = account;
  return obstacles;
}

}  // namespace citykiln::plants
