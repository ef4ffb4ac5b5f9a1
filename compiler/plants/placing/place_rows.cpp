#include <algorithm>

#include "compiler/plants/placing/placing_steps.h"
#include "compiler/plants/plant_size.h"

namespace citykiln::plants {
namespace {

// Heights differ little, as the trees of a row have one age.
constexpr double kRowHeightSpread = 0.08;

// Spacing in crown widths, so that crowns touch.
constexpr double kCrownSpacing = 0.95, kLeastSpacing_m = 2, kMostSpacing_m = 14;

// All trees of a row have the species drawn at its middle.
Species species_of_row(const TreeRow& row, const PlacingContext& context, const RandomSequence& draw) {
  return draw_species(context.species, row.species_mix, habitat_of(context, row.axis[row.axis.size() / 2]),
                      context.seed, draw.unit(kSpeciesDraw));
}

double spacing_m_of(const TreeRow& row, const SpeciesValues& species, double height_m) {
  if (row.spacing_m > 0) return row.spacing_m;
  return std::clamp(kCrownSpacing * species.crown_share * height_m, kLeastSpacing_m, kMostSpacing_m);
}

void place_row(PlacedPlants& placed, const TreeRow& row, const TreeClearanceIndex& mapped,
               const PlacingContext& context, std::vector<TreeClearance>& trees) {
  const RandomSequence of_row(context.seed, stable_id(row.id), "row");
  const Species species = species_of_row(row, context, of_row);
  const double mean_m = row.height_m > 0 ? row.height_m : default_height_m(context.species[species]);
  const double spacing_m = spacing_m_of(row, context.species[species], mean_m);
  const Box2 about = context.box.widened(kTrunksAbout_m);
  const std::vector<Vec2> places = spaced_along(row.axis, spacing_m);
  for (std::uint32_t number = 0; number < places.size(); ++number) {
    const Vec2 at = places[number];
    if (!about.contains(at) || is_blocked_ground(context.surfaces, at)) continue;
    const bool is_mapped = std::ranges::any_of(boxes_about(mapped.grid, at), [&](std::uint32_t i) {
      return distance(mapped.all[i].at, at) < std::min(spacing_m / 2, mapped.all[i].radius_m);
    });
    if (is_mapped) continue;
    const RandomSequence draw(context.seed, stable_id(stable_id(row.id), "tree", number), "tree");
    const double height_m = mean_m * draw.between(1 - kRowHeightSpread, 1 + kRowHeightSpread, kHeightDraw);
    trees.push_back({at, crown_clearance_m(context.species[species], height_m)});
    if (context.box.contains_half_open(at)) place_plant(placed, context, species, at, height_m, draw, row.id.osm);
  }
}

}  // namespace

std::vector<TreeClearance> place_rows(PlacedPlants& placed, std::span<const TreeRow> rows,
                                      std::vector<TreeClearance> trees, const PlacingContext& context) {
  const std::vector<TreeClearance> single = trees;
  const TreeClearanceIndex mapped = index_tree_clearances(single);
  for (const TreeRow& row : rows) place_row(placed, row, mapped, context, trees);
  return trees;
}

}  // namespace citykiln::plants
