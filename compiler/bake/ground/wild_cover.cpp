#include "compiler/bake/ground/wild_cover.h"

#include <algorithm>

#include "compiler/materials/noise.h"
#include "compiler/plants/tree_line.h"

namespace citykiln::bake {
namespace {

using materials::Material;

// Slopes on which rock begins to show and has a half: 35° and kSteepCosine's 48°, from where on all is rock.
constexpr double kRockBeginsCosine = 0.819, kRockHalvesCosine = 0.669;

bool is_ice(climate::ClimateClass climate) { return climate == climate::ClimateClass::kEF; }

}  // namespace

std::optional<Material> wild_material(const climate::ClimateMix& climate, double belt_m) {
  const double bare = climate.mean([](auto each) { return is_ice(each) ? 1.0 : climate::bare_share(each); });
  if (bare >= 0.5) return std::nullopt;
  return belt_m < plants::kTreeLine_m ? Material::kScrub : Material::kMeadow;
}

bool is_wild(Vec3 normal, Vec3 centre, std::uint64_t seed) {
  constexpr double kFray = 0.03;
  return normal.z < kWildSlopeCosine + kFray * materials::noise_at(in_plan(centre), 40, seed + 200);
}

bool is_bare_rock(Vec3 normal, Vec3 centre, std::uint64_t seed) {
  const double steep = (kRockBeginsCosine - normal.z) / (kRockBeginsCosine - kRockHalvesCosine);
  return 0.5 * steep > 0.5 + 0.5 * materials::noise_at(in_plan(centre), 15, seed + 201);
}

}  // namespace citykiln::bake
