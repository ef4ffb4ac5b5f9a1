#include "compiler/plants/prototypes/crown_average.h"

#include <cmath>

#include "compiler/geometry/mathematics.h"
#include "compiler/materials/material.h"
#include "compiler/plants/appearance.h"

namespace citykiln::plants {
namespace {

using Colour = std::array<double, 3>;

// About the number of trees in a cell of the canopy.
constexpr int kTrees = 3;

// A wood this near counts, so that paths have the canopy of their wood.
constexpr double kBeside_m = 6;

// Brightness of closed crowns and of the ground below them, as shares of the reflectance of a leaf and the ground:
// crowns shadow each other and the ground. Bare twigs shadow less. Measured as in prototype_mesh.cpp.
constexpr double kCrownShade = 0.15, kTwigsShade = 0.4, kGroundShade = 0.57;

// Tint of ground with fallen leaves.
constexpr Colour kLitter = {1, 0.73, 0.86};

// Random brightness: gaps between crowns are darker than treetops.
constexpr double kDarkest = 0.7, kLightest = 1.1;

// Tint of light transmitted by leaves.
constexpr Colour kThrough = {1, 1.1, 1.03};

std::uint32_t wood_near(const WoodIndex& woods, Vec2 p) {
  for (const Vec2 off : {Vec2{}, Vec2{kBeside_m, 0}, Vec2{0, kBeside_m}, Vec2{-kBeside_m, 0}, Vec2{0, -kBeside_m}})
    if (const std::uint32_t wood = wood_at(woods, p + off); wood != ground::kNoLandCover) return wood;
  return ground::kNoLandCover;
}

Colour colour_of(const Appearance& appearance) {
  const double shade = std::lerp(kTwigsShade, kCrownShade, appearance.leaf_share);
  const auto& base = values_of(appearance.leaf_material).base_colour;
  Colour colour;
  for (std::size_t c = 0; c < 3; ++c) colour[c] = shade * appearance.leaf[c] / 255 * static_cast<double>(base[c]);
  return colour;
}

// Share of the ground that randomly placed trees of this size hide from above.
double hidden_share(const Wood& wood, const SpeciesValues& species, double height_m, double leaf_share) {
  constexpr double kHectare_m2 = 10000, kQuarterPi = 0.78539816339745, kTwigs = 0.5;
  const double wide_m = species.crown_share * height_m;
  const double layers = kQuarterPi * wide_m * wide_m * wood.trees_per_ha / kHectare_m2;
  return std::lerp(kTwigs, 1.0, leaf_share) * layers / (1 + layers);
}

void add_tree(CrownAverage& mix, const Wood& wood, const Habitat& habitat, const PlacingContext& context,
              const RandomSequence& draw, Month month, const Colour& ground) {
  const SpeciesValues& species =
      context.species[draw_species(context.species, wood.species_mix, habitat, context.seed, draw.unit(kSpeciesDraw))];
  const auto variant = static_cast<std::uint8_t>(draw.unit(kVariantDraw) * kVariants);
  const double height_m = height_in_wood_m(wood, species, habitat, draw);
  const Appearance appearance = appearance_of(species, variant, month);
  const double hidden = hidden_share(wood, species, height_m, appearance.leaf_share);
  const Colour leaves = colour_of(appearance);
  mix.height_m += height_m / kTrees;
  const double seen = kGroundShade * (1 - hidden) * (1 - hidden);
  for (std::size_t c = 0; c < 3; ++c) {
    const double below = ground[c] * std::lerp(kLitter[c], 1.0, appearance.leaf_share);
    mix.colour[c] += kThrough[c] * (hidden * leaves[c] + seen * below) / kTrees;
  }
}

Colour ground_of(const WoodIndex& woods, const Wood& wood) {
  const auto surface =
      std::ranges::lower_bound(woods.context.surfaces.surfaces, wood.surface, {}, &ground::LandCoverPolygon::id);
  const auto& base = values_of(map::values_of(surface->surface).material).base_colour;
  return {base[0], base[1], base[2]};
}

StableId id_of_place(Vec2 p) {
  const auto whole = [](double v) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(v))); };
  return stable_id(StableId{whole(p.x) << 32 ^ (whole(p.y) & 0xffffffffu)}, "canopy", 0);
}

}  // namespace

CrownAverage crown_average_at(const WoodIndex& woods, Vec2 p, Month month) {
  CrownAverage mix;
  mix.wood = wood_near(woods, p);
  if (mix.wood == ground::kNoLandCover) return mix;
  const PlacingContext& context = woods.context;
  const Wood& wood = woods.woods[mix.wood];
  const map::Heightfield& terrain = context.ground.terrain;
  const Habitat habitat = habitat_at(climate_mix_at(context.climate, p), context.latitude_deg, p,
                                     height_m_at(terrain, p), normal_at(terrain, p), false);
  const Colour ground = ground_of(woods, wood);
  const RandomSequence draw(context.seed, id_of_place(p), "canopy");
  mix.uniform = draw.unit(0);
  for (std::uint32_t i = 0; i < kTrees; ++i)
    add_tree(mix, wood, habitat, context, RandomSequence(context.seed, stable_id(id_of_place(p), "tree", i), "canopy"),
             month, ground);
  const double light = draw.between(kDarkest, kLightest, 1);
  for (double& c : mix.colour) c *= light;
  return mix;
}

}  // namespace citykiln::plants
