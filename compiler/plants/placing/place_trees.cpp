#include <optional>

#include "compiler/geometry/trig.h"
#include "compiler/plants/placing/placing_steps.h"
#include "compiler/plants/plant_size.h"

namespace citykiln::plants {
namespace {

constexpr double kTreeHeightSpread = 0.25;

struct TreeGrowth {
  Species species;
  double height_m;
};

TreeGrowth grown(const Tree& tree, const PlacingContext& context, const RandomSequence& draw) {
  const Habitat habitat = habitat_of(context, tree.at);
  const Species species =
      draw_species(context.species, tree.species_mix, habitat, context.seed, draw.unit(kSpeciesDraw));
  if (tree.height_m > 0) return {species, tree.height_m};
  const double spread = draw.between(1 - kTreeHeightSpread, 1 + kTreeHeightSpread, kHeightDraw);
  return {species, default_height_m(context.species[species]) * height_factor(habitat) * spread};
}

// A tree in a road or on rails stands kBesideWay_m outside the edge: edges follow from default widths, and half of the
// junctions of most streets is kInWay_m. Buildings and shores are mapped, as trees are, to kImprecise_m.
constexpr double kInWay_m = 8, kImprecise_m = 2, kBesideWay_m = 0.5, kStep_m = 0.25;
constexpr int kDirections = 16;

// A tile knows all trees that its woods keep clear of, wherever they are moved.
static_assert(kInWay_m + kBesideWay_m + kMostClearance_m <= kObstacleInfluence_m);

// How far a tree is moved at most to get out of what covers p.
double most_moved_m(const ground::LandCoverIndex& land_cover, Vec2 p) {
  const map::LandCoverGroup group =
      map::values_of(land_cover.surfaces[ground::land_cover_at(land_cover, p)].surface).group;
  return group == map::LandCoverGroup::kRoad || group == map::LandCoverGroup::kRail ? kInWay_m : kImprecise_m;
}

// The nearest place beside what blocks p; none farther out than most_moved_m().
std::optional<Vec2> beside_blocked(const ground::LandCoverIndex& land_cover, Vec2 p) {
  for (double in_m = 0; in_m <= most_moved_m(land_cover, p); in_m += kStep_m)
    for (int i = 0; i < kDirections; ++i) {
      const Vec2 out = direction_of(i / double{kDirections});
      const Vec2 place = p + out * (in_m + kBesideWay_m);
      if (!is_blocked_ground(land_cover, p + out * in_m) && !is_blocked_ground(land_cover, place)) return place;
    }
  return std::nullopt;
}

// The place of a tree, or none where it is dropped; the same for all tiles.
std::optional<Vec2> place_of_tree(const ground::LandCoverIndex& land_cover, Vec2 p) {
  if (!land_cover.box.contains(p)) return std::nullopt;
  return is_blocked_ground(land_cover, p) ? beside_blocked(land_cover, p) : p;
}

// How far inside what blocks it a dropped tree stands at least.
double inside_m(const ground::LandCoverIndex& land_cover, Vec2 p) {
  return land_cover.box.contains(p) ? most_moved_m(land_cover, p) : 0;
}

}  // namespace

std::vector<TreeClearance> place_trees(PlacedPlants& placed, std::span<const Tree> trees, const PlacingContext& context,
                                       Report& report) {
  std::vector<TreeClearance> clearances;
  Account account;
  for (const Tree& tree : trees) {
    const std::optional<Vec2> at = place_of_tree(context.surfaces, tree.at);
    // a moved tree belongs to the tile of its new place
    const bool is_here = context.box.contains_half_open(at.value_or(tree.at));
    if (is_here) ++account.in;
    if (is_here && !at) report.drop(account, Code::kTreeOnRoad, tree.id.osm, inside_m(context.surfaces, tree.at));
    if (!at) continue;
    const RandomSequence draw(context.seed, stable_id(tree.id), "tree");
    const auto [species, height_m] = grown(tree, context, draw);
    clearances.push_back({*at, crown_clearance_m(context.species[species], height_m)});
    if (!is_here) continue;
    if (*at != tree.at) report.add(Code::kTreeMoved, tree.id.osm, distance(*at, tree.at));
    ++account.out;
    place_plant(placed, context, species, *at, height_m, draw, tree.id.osm);
  }
  report.account("bake", "tree") = account;
  return clearances;
}

}  // namespace citykiln::plants
