#include "compiler/plants/tufts/place_tufts.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>
#include <string_view>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"
#include "compiler/ground/cover/dry_cover.h"
#include "compiler/ground/height_layer.h"
#include "compiler/materials/noise.h"

namespace citykiln::plants {
namespace {

using map::LandCoverClass;
using map::LandCoverGroup;

struct TuftCover {
  LandCoverClass cover;
  double height_m, tall, flowers;
};
constexpr TuftCover kTuftCovers[] = {
#define TUFTS(cover, ...) {LandCoverClass::cover, __VA_ARGS__},
#include "compiler/plants/tufts/tuft_covers.inc"
};

struct Flower {
  TuftForm form;
  double height_m, lawn, meadow;
  std::string_view months;
};
constexpr Flower kFlowers[] = {
#define FLOWER(form, ...) {TuftForm::form, __VA_ARGS__},
#include "compiler/plants/tufts/flowers.inc"
};

// Grass from this height on is a meadow's.
constexpr double kMeadow_m = 0.1;
constexpr double kTallGrass_m = 0.4, kMostStrawWithFlowers = 0.5;
// Wavelength of patches of flowers, and of long and short grass.
constexpr double kFlowerPatch_m = 3, kHeightPatch_m = 1.5;
// Mowers miss the grass this near to a border, which grows this much higher.
constexpr double kMissed_m = 0.125, kMissedHeight = 1.6;

enum TuftDraw : std::uint32_t { kAlong, kAcross, kIsKept, kIsStanding, kForm, kHeight, kVariant, kYaw };

const TuftCover* row_of(LandCoverClass cover) {
  const auto* const row = std::ranges::find(kTuftCovers, cover, &TuftCover::cover);
  return row == std::end(kTuftCovers) ? nullptr : row;
}

// The share of tufts that is left at a distance from walked ground.
double share_at(double away_m, double far_share) {
  if (away_m < kTuftClearance_m) return 0;
  const double left = std::clamp((kTuftReach_m - away_m) / (kTuftReach_m - kDenseTufts_m), 0.0, 1.0);
  return far_share + (1 - far_share) * left * left;
}

// The climates of temperate lawns, C and D.
double temperate_share(const climate::ClimateMix& climate) {
  return climate.mean([](climate::ClimateClass each) {
    const char letter = name_of(each).front();
    return letter == 'C' || letter == 'D' ? 1.0 : 0.0;
  });
}

double in_flower(const Flower& flower, Month month) {
  const char letter = flower.months[(static_cast<std::size_t>(month) + 11) % 12];
  return letter == '.' ? 0 : (letter - '0') / 9.0;
}

// The share of tufts at a place that are this flower.
double share_of(const Flower& flower, const TuftCover& cover, Vec2 at, double flowers, const TuftGround& land) {
  const double usual = cover.height_m >= kMeadow_m ? flower.meadow : flower.lawn;
  const auto key = land.seed + 1 + static_cast<std::uint64_t>(flower.form);
  const double patch = std::max(0.0, materials::noise_at(at, kFlowerPatch_m, key)) * 2;
  return flowers * cover.flowers * usual * in_flower(flower, land.month) * patch;
}

// The grass or flower at a place.
struct Standing {
  TuftForm form = TuftForm::kMown;
  double height_m = 0;
};

Standing standing_at(const TuftGround& land, const TuftCover& cover, Vec2 at, double straw, double chance) {
  const double temperate = temperate_share(climate_mix_at(land.climate, at));
  const double flowers = temperate * std::max(0.0, 1 - straw / kMostStrawWithFlowers);
  for (const Flower& flower : kFlowers) {
    chance -= share_of(flower, cover, at, flowers, land);
    if (chance < 0) return {flower.form, flower.height_m};
  }
  if (chance < cover.tall) return {TuftForm::kTall, kTallGrass_m};
  return {TuftForm::kMown, cover.height_m * (1 + 0.4 * materials::noise_at(at, kHeightPatch_m, land.seed))};
}

bool is_obstructed(const TuftGround& land, Vec2 at, double height_m) {
  return std::ranges::any_of(land.obstacles, [&](const TuftObstacle& each) {
    return distance(at, nearest_point(each.from, each.to, at)) < each.half_width_m + height_m / 2;
  });
}

// A place with its numbers.
struct TuftPlace {
  Vec2 at;
  RandomSequence draw;
};

TuftPlace candidate_of(std::int64_t column, std::int64_t row, double spacing_m, std::uint64_t seed) {
  const auto number = static_cast<std::uint64_t>(column) << 32 ^ (static_cast<std::uint64_t>(row) & 0xffffffffu);
  const RandomSequence draw(seed, stable_id(StableId{}, "tuft", number), "tuft");
  return {snapped(Vec2{static_cast<double>(column) + draw.unit(kAlong), static_cast<double>(row) + draw.unit(kAcross)} *
                  spacing_m),
          draw};
}

Tuft tuft_at(const TuftGround& land, const TuftPlace& candidate, std::uint32_t surface, const Standing& standing) {
  const auto& [at, draw] = candidate;
  const ground::LandCoverPolygon& polygon = land.cover.surfaces[surface];
  const double ground_m = layer_height_m(heights_at(land.graded, at), layer_of(polygon));
  const Vec2 along = direction_of(draw.unit(kYaw));
  return {standing.form, static_cast<std::uint8_t>(draw.below(kTuftVariants, kVariant)), surface,
          Placement{.at = snapped(at_height(at, ground_m)),
                    .cos_yaw = along.x,
                    .sin_yaw = along.y,
                    .scale = standing.height_m * draw.between(0.7, 1.3, kHeight),
                    .feature = polygon.id.osm}};
}

// The tuft of a candidate, if one stands there.
std::optional<Tuft> tuft_of(const TuftGround& land, const TuftPlace& candidate) {
  const auto& [at, draw] = candidate;
  const std::uint32_t surface = ground::land_cover_at(land.cover, at);
  if (surface == ground::kNoLandCover) return std::nullopt;
  const LandCoverClass cover = land.cover.surfaces[surface].surface;
  const TuftCover* row = row_of(cover);
  if (row == nullptr) return std::nullopt;
  const double away_m = clearance_m(land.walked, at, 0, kTuftReach_m);
  if (draw.unit(kIsKept) >= share_at(away_m, land.far_share)) return std::nullopt;
  const ground::DryShares dry = ground::dry_shares(cover, climate_mix_at(land.climate, at), land.local_month);
  if (draw.unit(kIsStanding) < dry.bare) return std::nullopt;
  Standing standing = standing_at(land, *row, at, dry.straw, draw.unit(kForm));
  if (standing.form == TuftForm::kMown && away_m < kMissed_m) standing.height_m *= kMissedHeight;
  if (is_obstructed(land, at, standing.height_m)) return std::nullopt;
  return tuft_at(land, candidate, surface, standing);
}

}  // namespace

bool is_walked(LandCoverClass cover) {
  switch (map::values_of(cover).group) {
    case LandCoverGroup::kPath:
    case LandCoverGroup::kPaved:
    case LandCoverGroup::kRoad:
    case LandCoverGroup::kBuilding:
      return true;
    default:
      return cover == LandCoverClass::kPavedYard || cover == LandCoverClass::kGravelYard ||
             (cover >= LandCoverClass::kYardPath && cover <= LandCoverClass::kAsphaltDrive);
  }
}

std::vector<ground::LandCoverPolygon> walked_ground(std::span<const ground::LandCoverPolygon> surfaces,
                                                    const Box2& box) {
  std::vector<ground::LandCoverPolygon> walked;
  std::ranges::copy_if(surfaces, std::back_inserter(walked), [&](const ground::LandCoverPolygon& polygon) {
    return is_walked(polygon.surface) && ground::box_of(polygon).touches(box);
  });
  return walked;
}

std::vector<Tuft> place_tufts(const TuftGround& land, const Box2& box, double spacing_m) {
  assert(spacing_m > 0 && !box.is_empty());
  const auto first = [&](double from_m) { return static_cast<std::int64_t>(std::floor(from_m / spacing_m)) - 1; };
  std::vector<Tuft> tufts;
  for (std::int64_t column = first(box.min.x); column * spacing_m < box.max.x; ++column)
    for (std::int64_t row = first(box.min.y); row * spacing_m < box.max.y; ++row) {
      const TuftPlace candidate = candidate_of(column, row, spacing_m, land.seed);
      if (!box.contains_half_open(candidate.at)) continue;
      if (const std::optional<Tuft> tuft = tuft_of(land, candidate)) tufts.push_back(*tuft);
    }
  return tufts;
}

}  // namespace citykiln::plants
