#include "compiler/bake/far/patchwork.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/bake/far/far_land.h"
#include "compiler/bake/ground/dry_ground.h"
#include "compiler/materials/noise.h"
#include "compiler/plants/species_mix.h"
#include "compiler/plants/tree_line.h"
#include "compiler/surroundings/curvature.h"

namespace citykiln::bake {
namespace {

using map::LandCoverClass;
using map::LandCoverGroup;

// Single yards go on up to this distance from the edge.
constexpr double kOwnYards_m = 48;
// Lakes go on on land with no steeper slope, and where they are this wide.
constexpr double kLevelSlope = 0.02, kWideLake_m = 60;
// Towns leave steeper land to scrub and woods, which are in patches of this wavelength.
constexpr double kWildSlope = 0.3, kWildPatch_m = 140;
// Noise above this is wood: half of wild land, and a quarter where it is dry.
constexpr double kWoodAbove = 0, kDryWoodAbove = 0.3;

// A coordinate mirrored at the sides of an interval, to and fro within a depth.
double mirrored_at(double v, double low, double high) {
  const double depth = std::min(kMirrored_m, (high - low) / 2);
  const double out = std::max({low - v, v - high, 0.0});
  if (out == 0) return v;
  const double t = out - 2 * depth * std::floor(out / (2 * depth));
  // not on the edge itself, where polygons may end
  const double in = std::max(1.0, t < depth ? t : 2 * depth - t);
  return v > high ? high - in : low + in;
}

// True for the surfaces of single objects, which do not go on.
bool is_object(LandCoverGroup group) {
  switch (group) {
    case LandCoverGroup::kSport:
    case LandCoverGroup::kPaved:
    case LandCoverGroup::kRoad:
    case LandCoverGroup::kPath:
    case LandCoverGroup::kRail:
    case LandCoverGroup::kBuilding:
      return true;
    default:
      return false;
  }
}

LandCoverGroup group_at(const scene::GroundPlace& ground) { return map::values_of(ground.cover).group; }

}  // namespace

Patchwork::Patchwork(const scene::GroundLookup& lookup, const scene::Header& header)
    : lookup_(lookup), header_(header) {}

Vec2 Patchwork::mirrored(Vec2 place) const {
  const Box2& box = lookup_.box();
  return {mirrored_at(place.x, box.min.x, box.max.x), mirrored_at(place.y, box.min.y, box.max.y)};
}

Vec2 Patchwork::shift_at(Vec2 place) const {
  const double away_m = surroundings::away_m(lookup_.box(), place);
  const auto noise = [&](double wave_m, std::uint64_t key) {
    return Vec2{materials::noise_at(place, wave_m, header_.seed + key),
                materials::noise_at(place, wave_m, header_.seed + key + 1)};
  };
  return noise(260, 11) * (0.35 * std::min(away_m, 300.0)) + noise(1100, 13) * (0.5 * std::min(away_m, 1500.0));
}

// The rise over the distance, along the steeper axis.
double Patchwork::slope_at(Vec2 place) const {
  constexpr double kReach_m = 64;
  const auto height_m = [&](double x, double y) {
    return surroundings::height_m_at(header_.around, place + Vec2{x, y});
  };
  const double across = std::abs(height_m(kReach_m, 0) - height_m(-kReach_m, 0)),
               along = std::abs(height_m(0, kReach_m) - height_m(0, -kReach_m));
  return std::max(across, along) / (2 * kReach_m);
}

bool Patchwork::is_usable(const scene::GroundPlace& ground) const {
  const bool is_drive =
      ground.polygon != nullptr && ground::is_yard(*ground.polygon) && ground.cover != LandCoverClass::kLawn;
  const bool is_pier = ground.cover == LandCoverClass::kBreakwater || ground.cover == LandCoverClass::kWhiteWater;
  return !is_drive && !is_pier && !is_object(group_at(ground)) && group_at(ground) != LandCoverGroup::kWater;
}

bool Patchwork::is_lake(Vec2 from, Vec2 to, double away_m) const {
  if (away_m > kCanopies_m || slope_at(to) > kLevelSlope) return false;
  const auto is_water = [&](Vec2 at) {
    const scene::GroundPlace ground = lookup_.at(at);
    return group_at(ground) == LandCoverGroup::kWater && ground.cover != LandCoverClass::kSea;
  };
  // one side may be a pier or the shore
  constexpr std::array kSides = {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}};
  return std::ranges::count_if(kSides, [&](Vec2 aside) { return is_water(from + aside * kWideLake_m); }) >= 3;
}

surroundings::Patch Patchwork::patch_from(const scene::GroundPlace& ground, double height_m, double away_m) const {
  surroundings::Patch patch{.cover = ground.cover};
  if (ground.polygon != nullptr) {
    const materials::Material material = map::values_of(ground.cover).material;
    const TintFactor own = surface_tint(*ground.polygon, material, header_.seed, scene::month_of(header_));
    const TintFactor season = seasonal_tint(scene::month_of(header_), material);
    // the class's colour has the season already
    const auto without = [](double own_factor, double season_factor) {
      return season_factor > 0 ? own_factor / season_factor : 1;
    };
    patch.tint = {without(own.red, season.red), without(own.green, season.green), without(own.blue, season.blue)};
  }
  if (group_at(ground) == LandCoverGroup::kForest) {
    const double belt_m = plants::habitat_at({}, header_.origin.lat_deg, {}, height_m, Vec3{0, 0, 1}, false).belt_m;
    if (plants::wood_share_at(belt_m) < 0.6) return {.cover = LandCoverClass::kMeadow};
    if (away_m < kCanopies_m) patch.raised_m = kCanopy_m;
  }
  return patch;
}

surroundings::Patch Patchwork::wild_at(Vec2 place, double height_m, double away_m) const {
  const bool is_dry = ground::is_dry_anywhere(header_.climate, local_month_of(header_));
  const bool is_wood =
      materials::noise_at(place, kWildPatch_m, header_.seed + 31) > (is_dry ? kDryWoodAbove : kWoodAbove);
  scene::GroundPlace ground;
  ground.cover = is_wood ? LandCoverClass::kForest : LandCoverClass::kScrub;
  return patch_from(ground, height_m, away_m);
}

std::optional<surroundings::Patch> Patchwork::patch_on_border(Vec2 place) const {
  const Box2& box = lookup_.box();
  const scene::GroundPlace ground = lookup_.at(
      {std::clamp(place.x, box.min.x + 1, box.max.x - 1), std::clamp(place.y, box.min.y + 1, box.max.y - 1)});
  if (!is_usable(ground)) return std::nullopt;
  surroundings::Patch patch = patch_from(ground, surroundings::height_m_at(header_.around, place), 0);
  patch.raised_m = 0;
  return patch;
}

// A cell is larger than yards: it has the mean of lawns and other ground of towns about a place.
surroundings::Patch Patchwork::town_around(Vec2 from) const {
  constexpr std::array kReaches_m = {45.0, 100.0};
  constexpr std::array kAbout = {Vec2{1, 0},     Vec2{-1, 0},     Vec2{0, 1},       Vec2{0, -1},
                                 Vec2{0.6, 0.6}, Vec2{-0.6, 0.6}, Vec2{-0.6, -0.6}, Vec2{0.6, -0.6}};
  double lawns = 0;
  for (const double reach_m : kReaches_m)
    for (const Vec2 aside : kAbout) lawns += lookup_.at(from + aside * reach_m).cover == LandCoverClass::kLawn;
  const double share = lawns / (kAbout.size() * kReaches_m.size());
  const Colour town = colour_of_cover(LandCoverClass::kResidential, header_),
               lawn = colour_of_cover(LandCoverClass::kLawn, header_);
  surroundings::Patch patch{.cover = LandCoverClass::kResidential};
  for (std::size_t c = 0; c < 3; ++c) patch.tint[c] = (town[c] + (lawn[c] - town[c]) * share) / town[c];
  return patch;
}

surroundings::Patch Patchwork::patch_of(const surroundings::Cell& cell, double away_m) const {
  const Vec2 middle = cell.box().centre();
  if (away_m > kPatchesEnd_m) return {.cover = LandCoverClass::kMeadow};
  const surroundings::Cover cover = surroundings::cover_at(header_.around, middle);
  if (cover == surroundings::Cover::kSea) return {.cover = LandCoverClass::kSea};
  if (cover == surroundings::Cover::kLake) return {.cover = LandCoverClass::kLake};
  const Vec2 at = middle + shift_at(middle);
  const double height_m = surroundings::height_m_at(header_.around, middle);
  if (is_lake(mirrored(at), middle, away_m)) return {.cover = LandCoverClass::kLake};
  constexpr std::array kAside = {Vec2{0, 0},    Vec2{24, 10},  Vec2{-10, 24},  Vec2{-50, -20}, Vec2{20, -60},
                                 Vec2{110, 40}, Vec2{-90, 90}, Vec2{40, -240}, Vec2{300, 150}, Vec2{-500, 200}};
  for (const Vec2 aside : kAside) {
    const Vec2 from = mirrored(at + aside);
    const scene::GroundPlace ground = lookup_.at(from);
    if (!is_usable(ground)) continue;
    const bool is_town = group_at(ground) == LandCoverGroup::kTown || ground.cover == LandCoverClass::kLawn;
    const bool may_be_wild = is_town || group_at(ground) == LandCoverGroup::kUnknown;
    if (may_be_wild && slope_at(middle) > kWildSlope) return wild_at(middle, height_m, away_m);
    if (is_town && away_m >= kOwnYards_m) return town_around(from);
    return patch_from(ground, height_m, away_m);
  }
  if (slope_at(middle) > kWildSlope) return wild_at(middle, height_m, away_m);
  return {.cover = LandCoverClass::kMeadow};
}

}  // namespace citykiln::bake
