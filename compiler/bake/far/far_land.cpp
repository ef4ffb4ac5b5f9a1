// Belts after Ninot, Carrillo, Font, "The vegetation of the Pyrenees" (2007): alpine from 2,300 m, subnival from 2,800
// m on, where rock outweighs grass. Slopes: the angle of repose of scree (ground_material.h).
#include "compiler/bake/far/far_land.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/bake/ground/dry_ground.h"
#include "compiler/bake/ground/ground_material.h"
#include "compiler/bake/ground/ground_tint.h"
#include "compiler/materials/noise.h"
#include "compiler/plants/species_mix.h"
#include "compiler/plants/tree_line.h"
#include "compiler/surroundings/curvature.h"

namespace citykiln::bake {
namespace {

using map::LandCoverGroup;
using materials::Material;

constexpr int kPlaces = 256, kDirections = 64;
// Covers are means of as many directions on both sides.
constexpr int kBlur = kDirections / 8;

// Rock begins to show at 35°, and all is rock at 48°.
constexpr double kFirstRockCosine = 0.819;
// The colour of canopies relative to that of a wood's floor: crowns shade each other, and are greener.
constexpr TintFactor kCrowns = {0.52, 0.68, 0.45};
// Towns grow on land below 6°, and on none above 14°, a slope of 1 in 4.
constexpr double kTownCosine = 0.9945, kTownEndsCosine = 0.970;
// Between these belts rock grows to this share of level ground.
constexpr double kRockFrom_m = 2400, kRockUpTo_m = 2900, kRockShare = 0.7;
// Land begins to be too steep to be mown or ploughed at 10°, and all is at 22°: scrub covers this share of what is
// open, and woods cover this share of all below the tree line.
constexpr double kWildCosine = 0.985, kAllWildCosine = 0.927, kWildScrub = 0.75, kWildWood = 0.4;
// Woods and open land in patches of these wavelengths.
constexpr double kPatch_m = 900, kSmallPatch_m = 260;

// The material of the land, as light as the colours to which it is tinted.
Material base_of(const scene::Header& header) {
  const bool is_dry = ground::is_dry_anywhere(header.climate, local_month_of(header));
  return is_dry ? Material::kDryGround : Material::kScree;
}

Colour mixed(const Colour& a, const Colour& b, double share) {
  Colour colour{};
  for (std::size_t c = 0; c < 3; ++c) colour[c] = a[c] + (b[c] - a[c]) * share;
  return colour;
}

EdgeCover mixed(const EdgeCover& a, const EdgeCover& b, double share) {
  return {std::lerp(a.wood_share, b.wood_share, share), mixed(a.open, b.open, share),
          std::lerp(a.built_share, b.built_share, share), mixed(a.built, b.built, share)};
}

Colour colour_of(Material material) {
  const auto& colour = materials::values_of(material).base_colour;
  return {colour[0], colour[1], colour[2]};
}

Colour in_month(Material material, plants::Month month) {
  const TintFactor tint = seasonal_tint(month, material);
  const Colour colour = colour_of(material);
  return {colour[0] * tint.red, colour[1] * tint.green, colour[2] * tint.blue};
}

}  // namespace

Colour colour_of_cover(map::LandCoverClass cover, const scene::Header& header) {
  const climate::ClimateMix own(header.climate.origin_class);
  const ground::DryShares dry = ground::dry_shares(cover, own, local_month_of(header));
  const Material material = map::values_of(cover).material;
  if (dry == ground::DryShares{}) return in_month(material, month_of(header));
  const TintFactor tint = dry_tint(cover, dry);
  const Colour soil = colour_of(Material::kDryGround);
  return {soil[0] * tint.red, soil[1] * tint.green, soil[2] * tint.blue};
}

namespace {

bool is_built(LandCoverGroup group) {
  switch (group) {
    case LandCoverGroup::kTown:
    case LandCoverGroup::kIndustry:
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

// The mean colour of places.
struct MeanColour {
  double count = 0;
  Colour sum{};

  void add(const Colour& colour) {
    ++count;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += colour[c];
  }
  Colour or_else(const Colour& otherwise) const {
    return count == 0 ? otherwise : Colour{sum[0] / count, sum[1] / count, sum[2] / count};
  }
};

// Sums over places on land.
struct Sum {
  double wood = 0;
  MeanColour open{}, built{};

  void add(map::LandCoverClass cover, const scene::Header& header) {
    const map::LandCoverValues& values = map::values_of(cover);
    if (values.group == LandCoverGroup::kWater || values.group == LandCoverGroup::kUnknown) return;
    if (values.group == LandCoverGroup::kForest) return void(++wood);
    (is_built(values.group) ? built : open).add(colour_of_cover(cover, header));
  }

  EdgeCover mean(const EdgeCover& otherwise) const {
    const double grown = wood + open.count, land = grown + built.count;
    if (land == 0) return otherwise;
    return {grown > 0 ? wood / grown : otherwise.wood_share, open.or_else(otherwise.open), built.count / land,
            built.or_else(otherwise.built)};
  }
};

// 0 below a, 1 above b, smooth between them.
double rises(double a, double b, double value) {
  const double t = std::clamp((value - a) / (b - a), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// The share of the way around a square, from the middle of its eastern side: as places_on_border().
double around_square(Vec2 offset) {
  const double x = offset.x, y = offset.y;
  const double size = std::max(std::abs(x), std::abs(y));
  if (size == 0) return 0;
  const double turn = x == size ? y / size : y == size ? 2 - x / size : -x == size ? 4 - y / size : 6 + x / size;
  return (turn < 0 ? turn + 8 : turn) / 8;
}

EdgeCover cover_at(const FarLand& land, Vec2 place) {
  const auto count = static_cast<int>(land.ring.size());
  const double at = around_square(place - land.centre) * count;
  const int low = std::min(static_cast<int>(at), count - 1);
  const EdgeCover own = mixed(land.ring[static_cast<std::size_t>(low)],
                              land.ring[static_cast<std::size_t>((low + 1) % count)], std::clamp(at - low, 0.0, 1.0));
  const double away_m = surroundings::away_m(land.header.extent, place);
  return mixed(own, land.mean, away_m / (away_m + kEdgeFade_m));
}

// 0 to 1, in patches.
double patch_at(Vec2 place, std::uint64_t seed) {
  const double noise =
      0.6 * materials::noise_at(place, kPatch_m, seed + 1) + 0.4 * materials::noise_at(place, kSmallPatch_m, seed + 2);
  return std::clamp(0.5 + 0.8 * noise, 0.0, 1.0);
}

// The vegetation at a place: woods in patches, on slopes away from the sun more than on others, up to the tree line.
Colour growing_at(const FarLand& land, const EdgeCover& cover, const plants::Habitat& habitat, Vec3 normal) {
  constexpr double kSharpness = 3, kShadeShare = 0.5;
  const double dense = plants::wood_share_at(habitat.belt_m), high = (1 - dense) / (1 - plants::kSparseWood);
  const double wild = rises(-kWildCosine, -kAllWildCosine, -normal.z);
  const double least = std::max(cover.wood_share, kWildWood * wild);
  const double share = least * (1 - high) * (1 + kShadeShare * habitat.shade);
  const double wood = std::clamp((share - patch_at(habitat.at, land.header.seed)) * kSharpness + share, 0.0, 1.0);
  const Colour level = mixed(cover.open, colour_of_cover(map::LandCoverClass::kMeadow, land.header), high);
  const Colour open =
      mixed(level, colour_of_cover(map::LandCoverClass::kScrub, land.header), kWildScrub * wild * (1 - high));
  return mixed(open, colour_of_cover(map::LandCoverClass::kForest, land.header), wood);
}

// Towns go on beyond the edge where the land is not steep.
double built_share(const EdgeCover& cover, Vec3 normal) {
  return cover.built_share * (1 - rises(-kTownCosine, -kTownEndsCosine, -normal.z));
}

double rock_share(double belt_m, Vec3 normal) {
  const double by_slope = rises(-kFirstRockCosine, -kSteepCosine, -normal.z);
  const double by_height = kRockShare * rises(kRockFrom_m, kRockUpTo_m, belt_m);
  return by_slope + (1 - by_slope) * by_height;
}

materials::Tint far_tint(const Colour& colour, Material material, TintFactor place) {
  const Colour base = colour_of(material);
  return bake::tint_of({colour[0] / base[0], colour[1] / base[1], colour[2] / base[2]}, place);
}

}  // namespace

FarLand far_land_of(const scene::GroundLookup& lookup, const scene::Header& header) {
  FarLand land{.header = header, .centre = lookup.box().centre(), .ring = {}};
  std::vector<map::LandCoverClass> covers;
  for (const Vec2 place : scene::places_on_border(lookup.box(), kPlaces)) covers.push_back(lookup.at(place).cover);
  Sum all;
  for (const map::LandCoverClass cover : covers) all.add(cover, header);
  const Colour unknown = colour_of_cover(map::LandCoverClass::kUnknown, header);
  land.mean = all.mean({0, unknown, 0, unknown});
  constexpr int kEach = kPlaces / kDirections;
  for (int direction = 0; direction < kDirections; ++direction) {
    Sum own;
    for (int i = -kBlur * kEach; i <= kBlur * kEach; ++i)
      own.add(covers[static_cast<std::size_t>(direction * kEach + i + kPlaces) % kPlaces], header);
    land.ring.push_back(own.mean(land.mean));
  }
  return land;
}

namespace {

bool is_snow(const FarLand& land, Vec3 place, Vec3 normal) {
  const GroundFace face{.surface = map::LandCoverClass::kMeadow, .normal = normal, .centre = place};
  return material_of(face, land.header.snow_line_m, land.header.seed) == Material::kSnow;
}

plants::Habitat habitat_of(const FarLand& land, Vec3 place, Vec3 normal) {
  return plants::habitat_at({}, land.header.origin.lat_deg, in_plan(place), place.z, normal, false);
}

// The colour far from the edge, without rock.
Colour soft_colour(const FarLand& land, const plants::Habitat& habitat, Vec3 normal) {
  const EdgeCover cover = cover_at(land, habitat.at);
  return mixed(growing_at(land, cover, habitat, normal), cover.built, built_share(cover, normal));
}

Colour times(const Colour& a, double red, double green, double blue) { return {a[0] * red, a[1] * green, a[2] * blue}; }

materials::Tint tint_to(const Colour& colour, Material material) {
  const Colour base = colour_of(material);
  return bake::tint_of({colour[0] / base[0], colour[1] / base[1], colour[2] / base[2]}, {});
}

}  // namespace

materials::SurfaceMaterial far_material_of(const FarLand& land, Vec3 place, Vec3 normal) {
  assert(!land.ring.empty());
  if (is_snow(land, place, normal)) return {Material::kSnow};
  const plants::Habitat habitat = habitat_of(land, place, normal);
  const Colour colour =
      mixed(soft_colour(land, habitat, normal), colour_of(Material::kRock), rock_share(habitat.belt_m, normal));
  const Material base = base_of(land.header);
  return {base, far_tint(colour, base, place_tint(in_plan(place), Material::kMeadow, land.header.seed))};
}

Material material_of(const FarLand& land, const surroundings::Patch& patch, Vec3 place, Vec3 normal, double away_m) {
  const bool is_shore = patch.cover == map::LandCoverClass::kSea;
  if (map::values_of(patch.cover).group == LandCoverGroup::kWater && !is_shore)
    return map::values_of(patch.cover).material;
  if (is_snow(land, place, normal)) return Material::kSnow;
  const Material base = base_of(land.header);
  if (is_shore || base == Material::kDryGround || away_m > kOwnMaterial_m) return base;
  const bool is_rocky = patch.raised_m == 0 && rock_share(habitat_of(land, place, normal).belt_m, normal) > 0.25;
  return is_rocky ? base : map::values_of(patch.cover).material;
}

materials::Tint tint_of(const FarLand& land, const surroundings::Patch& patch, Material material, Vec3 place,
                        Vec3 normal, double away_m) {
  if (material == Material::kSnow) return materials::kNoTint;
  if (patch.cover == map::LandCoverClass::kSea) return tint_to(colour_of(Material::kScree), material);
  const map::LandCoverValues& values = map::values_of(patch.cover);
  const plants::Habitat habitat = habitat_of(land, place, normal);
  const TintFactor own_place = place_tint(in_plan(place), values.material, land.header.seed);
  const TintFactor meadow_place = place_tint(in_plan(place), Material::kMeadow, land.header.seed);
  const Colour own =
      times(times(colour_of_cover(patch.cover, land.header), patch.tint[0], patch.tint[1], patch.tint[2]),
            own_place.red, own_place.green, own_place.blue);
  const Colour far = times(soft_colour(land, habitat, normal), meadow_place.red, meadow_place.green, meadow_place.blue);
  const double light = 1 + 0.35 * materials::noise_at(in_plan(place), 30, 5);
  const TintFactor crowns = patch.raised_m > 0 ? times(kCrowns, {light, light, light}) : TintFactor{};
  const Colour soft =
      mixed(times(own, crowns.red, crowns.green, crowns.blue), far, rises(kPatches_m, kPatchesEnd_m, away_m));
  const double rock = patch.raised_m > 0 ? 0 : rock_share(habitat.belt_m, normal);
  return tint_to(mixed(soft, colour_of(Material::kRock), rock), material);
}

}  // namespace citykiln::bake
