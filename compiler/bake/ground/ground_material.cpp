#include "compiler/bake/ground/ground_material.h"

#include "compiler/bake/ground/dry_ground.h"
#include "compiler/bake/ground/wild_cover.h"
#include "compiler/materials/noise.h"

namespace citykiln::bake {
namespace {

using map::LandCoverGroup;
using materials::Material;

bool is_town(LandCoverGroup group) {
  return group == LandCoverGroup::kTown || group == LandCoverGroup::kIndustry || group == LandCoverGroup::kGarden;
}

// Noise of two wavelengths keeps the snow line from running level, or in waves of one size.
bool is_above(Vec3 at, double snow_line_m, std::uint64_t seed) {
  const double sway =
      0.6 * materials::noise_at(in_plan(at), 260, seed) + 0.4 * materials::noise_at(in_plan(at), 70, seed);
  return at.z >= snow_line_m + kSnowLineSway_m * sway;
}

}  // namespace

bool is_land(LandCoverGroup group) {
  switch (group) {
    case LandCoverGroup::kUnknown:
    case LandCoverGroup::kForest:
    case LandCoverGroup::kGrassland:
    case LandCoverGroup::kFarm:
    case LandCoverGroup::kGarden:
    case LandCoverGroup::kScrubland:
    case LandCoverGroup::kWetland:
    case LandCoverGroup::kBare:
    case LandCoverGroup::kTown:
    case LandCoverGroup::kIndustry:
      return true;
    default:
      return false;
  }
}

Material material_of(const GroundFace& face, const std::optional<double>& snow_line_m, std::uint64_t seed) {
  const auto& values = values_of(face.surface);
  if (!is_land(values.group)) return values.material;
  if (face.is_vertical) return Material::kStone;
  const bool is_snowed = snow_line_m && face.normal.z >= kSnowCosine && is_above(face.centre, *snow_line_m, seed);
  if (is_snowed) return Material::kSnow;
  const bool may_be_wild = face.wild && face.surface == map::LandCoverClass::kUnknown && !face.is_beside_road;
  if (face.normal.z >= kSteepCosine && may_be_wild && is_wild(face.normal, face.centre, seed))
    return is_bare_rock(face.normal, face.centre, seed) ? Material::kRock : *face.wild;
  if (face.normal.z >= kSteepCosine) return dry_material_of(face.surface, face.dry);
  return is_town(values.group) || face.is_beside_road ? Material::kStone : Material::kRock;
}

}  // namespace citykiln::bake
