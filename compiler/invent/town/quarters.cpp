#include "compiler/invent/town/quarters.h"

#include <algorithm>
#include <limits>

#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/polygons/offset_polygon.h"
#include "compiler/geometry/snap.h"
#include "compiler/invent/town/draws.h"
#include "compiler/invent/town/smooth_noise.h"

namespace citykiln::invent {
namespace {

/// A kind of block of which a town has a number by its area.
struct Wanted {
  BlockUse use;
  double per_km2;            ///< On a square kilometre of town.
  double least_m2, most_m2;  ///< Limits of the land.
  double least_density, most_density;
  double near_centre;  ///< 1: as near to a centre as possible; -1: as far.
  double apart_m;      ///< From others of its kind.
};

constexpr Wanted kWanted[] = {
    {BlockUse::kSquare, 0.9, 900, 9000, 0.3, 2, 1.5, 500},
    {BlockUse::kChurch, 0.9, 1200, 12000, 0.12, 2, 1, 450},
    {BlockUse::kPark, 1.6, 3000, 90000, 0.1, 2, 0.2, 320},
    {BlockUse::kSchool, 1.1, 7000, 26000, 0.1, 0.75, 0.3, 450},
    {BlockUse::kMarket, 0.8, 5000, 16000, 0.1, 0.6, 0.2, 500},
    {BlockUse::kSports, 0.6, 11000, 45000, 0.04, 0.4, -0.4, 700},
    {BlockUse::kCemetery, 0.3, 7000, 40000, 0.04, 0.4, -0.3, 900},
    {BlockUse::kAllotments, 0.6, 8000, 40000, 0.04, 0.35, -0.8, 350},
};

// the largest piece of a block's land behind its streets
Polygon land_of(const Ring& ring, double inset_m) {
  const Polygon whole{ring, {}};
  const OffsetPolygon offset = inset(whole, std::vector<double>(ring.size(), inset_m));
  Polygon largest;
  for (const Polygon& piece : offset.moved)
    if (area_m2(piece) > area_m2(largest)) largest = piece;
  for (Vec2& p : largest.outer) p = on_place_grid(p);
  largest.outer = without_repeats(largest.outer);
  largest.holes.clear();
  return largest;
}

double town_km2(const TownPlan& plan) {
  std::size_t inside = 0;
  for (const double density : plan.density.values) inside += density > kTownEdge;
  return static_cast<double>(inside) * plan.density.step_m * plan.density.step_m / 1e6;
}

// how well a block suits a use: the least is best, infinity not at all
double fit_of(const TownPlan& plan, const TownBlock& block, std::size_t i, const Wanted& wanted) {
  const double land_m2 = area_m2(block.land), density = plan.density.at(block.middle);
  constexpr double kUnfit = std::numeric_limits<double>::infinity();
  if (!block.is_whole || !has_lots(block.use) || land_m2 < wanted.least_m2 || land_m2 > wanted.most_m2) return kUnfit;
  if (density < wanted.least_density || density > wanted.most_density || plan.water.at(block.middle) < 20)
    return kUnfit;
  Draws draws(plan.settings.seed, "block", i * 16 + static_cast<std::size_t>(wanted.use));
  return wanted.near_centre * plan.centre_distance_m(block.middle) / 300 + draws.unit();
}

// gives the best blocks the use that is wanted, unless one of its kind is near
void assign(const TownPlan& plan, std::vector<TownBlock>& blocks, const Wanted& wanted, double km2) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < blocks.size(); ++i)
    if (const double fit = fit_of(plan, blocks[i], i, wanted); fit < std::numeric_limits<double>::infinity())
      order.push_back({fit, i});
  std::ranges::sort(order);
  const auto count = static_cast<std::size_t>(std::max(1.0, km2 * wanted.per_km2 + 0.5));
  std::vector<Vec2> chosen;
  for (const auto& [fit, i] : order) {
    const Vec2 p = blocks[i].middle;
    if (std::ranges::any_of(chosen, [&](Vec2 c) { return distance(c, p) < wanted.apart_m; })) continue;
    blocks[i].use = wanted.use;
    chosen.push_back(p);
    if (chosen.size() == count) return;
  }
}

// true if water or a track lies on the land of a block
bool is_wet_land(const TownPlan& plan, const Ring& land) {
  const Box2 box = box_of(land);
  for (double y = box.min.y; y <= box.max.y; y += 12)
    for (double x = box.min.x; x <= box.max.x; x += 12)
      if ((plan.water.at({x, y}) < 10 || plan.is_track_land({x, y})) && winding_number(land, {x, y}) != 0) return true;
  return false;
}

TownBlock block_of(const TownPlan& plan, const Ring& ring, bool has_dead_end, double land_inset_m) {
  TownBlock block;
  block.ring = ring;
  if (ring.size() < 3) return block;
  block.area_m2 = signed_area_m2(ring);
  block.middle = centroid(Polygon{ring, {}});
  if (block.area_m2 < 4e5) block.land = land_of(ring, land_inset_m);
  block.use = use_at(plan, block.middle);
  block.is_whole = !has_dead_end && !block.land.outer.empty() && !is_wet_land(plan, block.land.outer);
  if (block.is_whole && plan.is_reserved(block.middle)) block.use = BlockUse::kPark;
  return block;
}

}  // namespace

BlockUse use_at(const TownPlan& plan, Vec2 p) {
  const double density = plan.density.at(p);
  const std::uint64_t seed = plan.settings.seed;
  const double mix = smooth_noise(seed ^ 0xb10c, p, 160), works = smooth_noise(seed ^ 0x3072, p, 600);
  if (plan.settings.kind == TownKind::kVillage)
    return mix > 0.1 && density < 0.26 ? BlockUse::kHouses : BlockUse::kFarms;
  if (density > 0.56) return BlockUse::kCore;
  if (works > 0.52 && density < 0.42) return density > 0.3 ? BlockUse::kCommerce : BlockUse::kIndustry;
  if (density > 0.42) return mix > 0.3 ? BlockUse::kFlats : mix > -0.25 ? BlockUse::kTerraces : BlockUse::kCore;
  if (density > 0.22) return mix > 0.42 ? BlockUse::kFlats : mix > 0.05 ? BlockUse::kTerraces : BlockUse::kHouses;
  return mix > 0.25 ? BlockUse::kVillas : BlockUse::kHouses;
}

std::vector<TownBlock> plan_quarters(const TownPlan& plan, const StreetBlocks& blocks, double land_inset_m) {
  std::vector<TownBlock> quarters;
  for (std::size_t i = 0; i < blocks.rings.size(); ++i)
    quarters.push_back(block_of(plan, blocks.rings[i], blocks.has_dead_end[i], land_inset_m));
  const double km2 = town_km2(plan);
  for (const Wanted& wanted : kWanted) {
    const bool is_village = plan.settings.kind == TownKind::kVillage;
    if (is_village && wanted.use != BlockUse::kChurch && wanted.use != BlockUse::kSports) continue;
    assign(plan, quarters, wanted, km2);
  }
  return quarters;
}

}  // namespace citykiln::invent
