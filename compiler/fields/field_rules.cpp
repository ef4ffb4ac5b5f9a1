#include "compiler/fields/field_rules.h"

#include <algorithm>
#include <array>
#include <vector>

#include "compiler/geometry/polygon.h"

namespace citykiln::fields {
namespace {

using map::LandCoverClass;

constexpr double kHectare_m2 = 1e4;
constexpr std::size_t kCrops = 9;

struct FieldRegion {
  FieldRule rule;
  Ring ring;  // degrees
};

FieldRule field_rule(double area_ha, double aspect, FieldBorder border, double border_share, bool is_grid) {
  return {area_ha * kHectare_m2, aspect, border, border_share, is_grid};
}

// The last row is the one of squares of half a mile.
const std::vector<FieldRegion>& field_regions() {
  static const std::vector<FieldRegion> kRegions = [] {
    std::vector<FieldRegion> regions = {
#define FIELD_REGION(area_ha, aspect, border, share, ...) \
  {field_rule(area_ha, aspect, FieldBorder::border, share, false), Ring{__VA_ARGS__}},
#include "compiler/fields/field_rules.inc"
#undef FIELD_REGION
    };
    regions.back().rule.is_grid = true;
    return regions;
  }();
  return kRegions;
}

struct FieldGroup {
  map::CountryGroup group;
  FieldRule rule;
};
const std::array<FieldGroup, static_cast<std::size_t>(map::CountryGroup::kCount)> kFieldGroups = {{
#define FIELD_GROUP(group, area_ha, aspect, border, share) \
  {map::CountryGroup::group, field_rule(area_ha, aspect, FieldBorder::border, share, false)},
#include "compiler/fields/field_rules.inc"
#undef FIELD_GROUP
}};

using CropShares = std::array<double, kCrops>;

struct GroupCrops {
  map::CountryGroup group;
  CropShares shares;
};
constexpr GroupCrops kGroupCrops[] = {
#define CROPS(name, ...) {map::CountryGroup::name, {__VA_ARGS__}},
#define CLIMATE_CROPS(name, ...)
#include "compiler/fields/crops.inc"
};

struct ClimateCrops {
  climate::ClimateClass climate;
  CropShares shares;
};
constexpr ClimateCrops kClimateCrops[] = {
#define CROPS(name, ...)
#define CLIMATE_CROPS(name, ...) {climate::ClimateClass::name, {__VA_ARGS__}},
#include "compiler/fields/crops.inc"
};

const CropShares& crop_shares(const CropConditions& place) {
  const auto by_climate = std::ranges::find(kClimateCrops, place.climate, &ClimateCrops::climate);
  if (by_climate != std::end(kClimateCrops)) return by_climate->shares;
  return std::ranges::find(kGroupCrops, place.country, &GroupCrops::group)->shares;
}

}  // namespace

FieldRule field_rule_at(LonLat place) {
  for (const FieldRegion& region : field_regions())
    if (winding_number(region.ring, {place.lon_deg, place.lat_deg}) != 0) return region.rule;
  return std::ranges::find(kFieldGroups, map::country_group_at(place), &FieldGroup::group)->rule;
}

map::LandCoverClass crop_at(const CropConditions& place, double draw) {
  constexpr std::array<LandCoverClass, kCrops> kClasses = {
      LandCoverClass::kCereals,   LandCoverClass::kMaize,    LandCoverClass::kRape,
      LandCoverClass::kBeets,     LandCoverClass::kPotatoes, LandCoverClass::kSunflowers,
      LandCoverClass::kRicePaddy, LandCoverClass::kLey,      LandCoverClass::kFallow};
  const CropShares& shares = crop_shares(place);
  double sum = 0;
  for (const double share : shares) sum += share;
  double left = draw * sum;
  for (std::size_t i = 0; i < kCrops; ++i)
    if ((left -= shares[i]) < 0) return kClasses[i];
  return LandCoverClass::kCereals;
}

}  // namespace citykiln::fields
