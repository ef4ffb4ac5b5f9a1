#include "compiler/vacant/plot_parts.h"

#include <algorithm>
#include <limits>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/snap.h"
#include "compiler/plants/species_mix.h"
#include "compiler/vacant/ground_cover.h"

namespace citykiln::vacant {
namespace {

constexpr double kBushStep_m = 2, kRim_m = 1.2, kFromWay_m = 1, kFromWall_m = 2;
constexpr double kLowest_m = 0.75, kHighest_m = 2.5;

bool is_place_of_bush(const PlotInputs& inputs, Vec2 p) {
  const ground::LandCoverPolygon* cover = cover_at(inputs, p);
  if (!inputs.tile.contains_half_open(p) || !inputs.land_cover.box.contains(p)) return false;
  const bool is_soft = cover == nullptr || map::values_of(cover->surface).group == map::LandCoverGroup::kTown ||
                       is_left_over(cover->surface) || cover->surface == map::LandCoverClass::kAllotments;
  if (!is_soft || (cover != nullptr && ground::is_yard(*cover))) return false;
  const int paths = map::values_of(map::LandCoverClass::kBridleway).priority,
            buildings = map::values_of(map::LandCoverClass::kBuilding).priority;
  return ground::clearance_m(inputs.land_cover, p, paths, kFromWay_m) >= kFromWay_m &&
         ground::clearance_m(inputs.land_cover, p, buildings, kFromWall_m) >= kFromWall_m;
}

void add_bush(const PlotInputs& inputs, Vec2 p, ObjectId id, double share, Plots& plots) {
  const Vec2 at = snapped(p);
  if (!is_place_of_bush(inputs, at)) return;
  const plants::SpeciesMix usual = plants::species_mix_of(plants::PlantCommunity::kGardenTrees);
  plots.plants.push_back({.id = id,
                          .at = at,
                          .height_m = snapped(kLowest_m + (kHighest_m - kLowest_m) * share * share),
                          .species_mix = plants::species_mix_for({.kind = map::PlantKind::kBush}, usual)});
}

}  // namespace

Ring ring_of(const PlotRectangle& r) {
  return {snapped(r.at(0, 0)), snapped(r.at(r.width_m, 0)), snapped(r.at(r.width_m, r.depth_m)),
          snapped(r.at(0, r.depth_m))};
}

bool is_in_tile(const PlotInputs& inputs, const Ring& ring) {
  constexpr double kMargin_m = 1;
  const Box2 box = box_of(ring).widened(kMargin_m);
  return inputs.tile.contains(box.min) && inputs.tile.contains(box.max);
}

lots::Yard ground_of(const PlotRectangle& rectangle, ObjectId id, lots::LotKind kind, map::CountryGroup country) {
  lots::Yard yard{.building = id, .country = country, .kind = kind};
  yard.polygon.outer = ring_of(rectangle);
  yard.frame = lots::place_of({rectangle.corner, rectangle.along, rectangle.back});
  return yard;
}

ground::LandCoverPolygon surface_on(map::LandCoverClass surface, ObjectId id, int priority, std::vector<Ring> rings) {
  ground::LandCoverPolygon made{
      .id = id, .surface = surface, .area_m2 = std::numeric_limits<std::uint32_t>::max(), .rings = std::move(rings)};
  made.raised_priority = static_cast<std::uint8_t>(priority + 1);
  return made;
}

void add_bushes(const PlotInputs& inputs, const PlotRectangle& r, ObjectId id, double rim, double inside,
                Plots& plots) {
  const RandomSequence draw(inputs.seed, stable_id(id), "bushes");
  std::uint32_t index = 0;
  const auto try_at = [&](Vec2 p, double chance) {
    const std::uint32_t i = 4 * index++;
    const Vec2 moved = Vec2{draw.between(-0.8, 0.8, i + 1), draw.between(-0.8, 0.8, i + 2)};
    if (draw.unit(i) < chance) add_bush(inputs, p + moved, id, draw.unit(i + 3), plots);
  };
  const double rim_chance = rim * kBushStep_m / 100;
  for (double y_m = kBushStep_m; y_m < r.depth_m; y_m += kBushStep_m)
    for (const double x_m : {kRim_m, r.width_m - kRim_m}) try_at(r.at(x_m, y_m), rim_chance);
  for (double x_m = kBushStep_m; x_m < r.width_m; x_m += kBushStep_m) try_at(r.at(x_m, r.depth_m - kRim_m), rim_chance);
  const auto count = static_cast<std::uint32_t>(r.width_m * r.depth_m / 100 * inside * 2);
  for (std::uint32_t n = 0; n < count; ++n) {
    const std::uint32_t i = 4 * (1000 + n);
    try_at(r.at(draw.between(0, r.width_m, i), draw.between(0, r.depth_m, i + 1)), 0.5);
  }
}

}  // namespace citykiln::vacant
