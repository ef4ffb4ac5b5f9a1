#include "compiler/bake/ground/ground_tint.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include "compiler/contract/random_sequence.h"
#include "compiler/materials/noise.h"

namespace citykiln::bake {
namespace {

using ground::LandCoverPolygon;
using map::LandCoverGroup;
using materials::Material;

// The kinds of undivided farmland, by their letters in June: stubble, ploughed, sown, green, turning, ripe.
constexpr std::string_view kCropLetters = "bpogtr";

struct CropColour {
  char letter;
  TintFactor colour;  // linear
};
constexpr CropColour kCropColours[] = {
#define CROP_COLOUR(letter, red, green, blue) {letter, {red, green, blue}},
#define CROP(surface, letters)
#include "compiler/bake/ground/crop_colours.inc"
#undef CROP_COLOUR
#undef CROP
};

struct CropYear {
  map::LandCoverClass crop;
  std::string_view letters;
};
constexpr CropYear kCropYears[] = {
#define CROP_COLOUR(letter, red, green, blue)
#define CROP(surface, letters) {map::LandCoverClass::surface, letters},
#include "compiler/bake/ground/crop_colours.inc"
#undef CROP_COLOUR
#undef CROP
};
// The share of fields that are a month behind.
constexpr double kLateFields = 0.3;
// Grazed meadows are darker, and mown ones lighter and yellower.
constexpr TintFactor kGrazed{0.78, 0.92, 0.8}, kMown{1, 0.97, 0.8};

struct SeasonalTint {
  char letter;
  TintFactor factor;
};
constexpr SeasonalTint kSeasonalTints[] = {
#define TINT(letter, red, green, blue) {letter, {red, green, blue}},
#define MONTHS(material, months)
#define CROPS(month, crops)
#include "compiler/bake/ground/seasonal_tints.inc"
#undef TINT
#undef MONTHS
#undef CROPS
};

struct Months {
  Material material;
  std::string_view months;
};
constexpr Months kMonths[] = {
#define TINT(letter, red, green, blue)
#define MONTHS(material, months) {Material::material, months},
#define CROPS(month, crops)
#include "compiler/bake/ground/seasonal_tints.inc"
#undef TINT
#undef MONTHS
#undef CROPS
};

constexpr std::string_view kCropsOfMonths[] = {
#define TINT(letter, red, green, blue)
#define MONTHS(material, months)
#define CROPS(month, crops) crops,
#include "compiler/bake/ground/seasonal_tints.inc"
#undef TINT
#undef MONTHS
#undef CROPS
};
static_assert(std::size(kCropsOfMonths) == 12 && kCropsOfMonths[5] == kCropLetters);

std::size_t index_of(plants::Month month) { return (static_cast<std::size_t>(month) + 11) % 12; }

// The colour of a crop as a share of the material's.
TintFactor crop_tint(char letter) {
  const TintFactor colour = std::ranges::find(kCropColours, letter, &CropColour::letter)->colour;
  const auto& base = values_of(Material::kFarmland).base_colour;
  return {colour.red / base[0], colour.green / base[1], colour.blue / base[2]};
}

// The letter of a surface of farmland in a month: by its crop, else one of six kinds.
char crop_letter(map::LandCoverClass surface, plants::Month month, const RandomSequence& draw) {
  const auto year = std::ranges::find(kCropYears, surface, &CropYear::crop);
  if (year == std::end(kCropYears))
    return kCropsOfMonths[index_of(month)][draw.below(static_cast<std::uint32_t>(kCropLetters.size()), 1)];
  const std::size_t late = draw.unit(2) < kLateFields ? 11 : 0;
  return year->letters[(index_of(month) + late) % 12];
}

TintFactor meadow_tint(map::LandCoverClass surface) {
  if (surface == map::LandCoverClass::kPasture) return kGrazed;
  return surface == map::LandCoverClass::kHayMeadow ? kMown : TintFactor{};
}

bool is_green(Material material) {
  switch (material) {
    case Material::kUnknownGround:
    case Material::kGrass:
    case Material::kMeadow:
    case Material::kFarmland:
    case Material::kOrchard:
    case Material::kForestFloor:
    case Material::kScrub:
    case Material::kHeath:
    case Material::kWetland:
      return true;
    default:
      return false;
  }
}

// @param dryness  -1: bluish green; 1: yellowish.
TintFactor dried(double dryness) {
  if (dryness > 0) return {1, 1 - 0.07 * dryness, 1 - 0.30 * dryness};
  return {1 + 0.24 * dryness, 1 + 0.04 * dryness, 1 + 0.06 * dryness};
}

}  // namespace

TintFactor times(TintFactor a, TintFactor b) { return {a.red * b.red, a.green * b.green, a.blue * b.blue}; }

bool is_paved(map::LandCoverClass surface) {
  const LandCoverGroup group = map::values_of(surface).group;
  return group == LandCoverGroup::kRoad || group == LandCoverGroup::kPath || group == LandCoverGroup::kRail ||
         group == LandCoverGroup::kPaved;
}

bool has_soft_border(map::LandCoverClass surface) {
  const LandCoverGroup group = map::values_of(surface).group;
  return group == LandCoverGroup::kForest || group == LandCoverGroup::kGrassland ||
         group == LandCoverGroup::kScrubland || group == LandCoverGroup::kWetland || group == LandCoverGroup::kBare;
}

TintFactor seasonal_tint(plants::Month month, Material material) {
  const auto year = std::ranges::find(kMonths, material, &Months::material);
  if (year == std::end(kMonths)) return {};
  return std::ranges::find(kSeasonalTints, year->months[index_of(month)], &SeasonalTint::letter)->factor;
}

TintFactor surface_tint(const LandCoverPolygon& surface, Material material, std::uint64_t seed, plants::Month month) {
  if (is_paved(surface.surface)) return {};
  const RandomSequence draw(seed, stable_id(surface.id), "ground tint");
  const double level = 1 - values_of(material).variation * draw.unit(0);
  const TintFactor plain{level, level, level};
  if (material == Material::kFarmland) return times(plain, crop_tint(crop_letter(surface.surface, month, draw)));
  if (!is_green(material)) return plain;
  const TintFactor use = meadow_tint(surface.surface);
  return times(times(plain, use), times(dried(0.8 * (2 * draw.unit(1) - 1)), seasonal_tint(month, material)));
}

TintFactor place_tint(Vec2 place_m, Material material, std::uint64_t seed) {
  const double variation = values_of(material).variation;
  if (variation == 0) return {};
  struct Wave {
    double length_m, share;
  };
  constexpr Wave kLight[] = {{300, 0.45}, {110, 0.33}, {35, 0.22}}, kDry[] = {{230, 0.6}, {70, 0.4}};
  const auto sum = [&](const auto& waves, std::uint64_t key) {
    double noise = 0;
    for (const Wave& wave : waves) noise += wave.share * materials::noise_at(place_m, wave.length_m, key++);
    return noise;
  };
  const bool grows = is_green(material);
  const double depth = grows ? 0.10 + variation : variation;
  const double level = 1 - depth * std::clamp(0.5 + 0.9 * sum(kLight, seed), 0.0, 1.0);
  const TintFactor light{level, level, level};
  // a field is sown at once, so it dries evenly
  const double spread = material == Material::kFarmland ? 0.5 : 1.3;
  return grows ? times(light, dried(std::clamp(spread * sum(kDry, seed + 100), -1.0, 1.0))) : light;
}

materials::Tint tint_of(TintFactor surface, TintFactor place) {
  const auto byte = [](double v) { return static_cast<std::uint8_t>(255 * std::clamp(v, 0.0, 1.0) + 0.5); };
  const TintFactor both = times(surface, place);
  return {byte(both.red), byte(both.green), byte(both.blue), 255};
}

}  // namespace citykiln::bake
