#include "compiler/bake/parts/bake_tufts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/bake/ground/dry_ground.h"
#include "compiler/bake/ground/ground_material.h"
#include "compiler/bake/ground/ground_tint.h"
#include "compiler/bake/merge.h"
#include "compiler/bake/parts/bake_instances.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/geometry/segment.h"
#include "compiler/plants/tufts/place_tufts.h"
#include "compiler/plants/tufts/tuft_mesh.h"

namespace citykiln::bake {
namespace {

using materials::Material;
using plants::Tuft;

// Tufts are placed in squares of this side, so that a view places only those near the eye.
constexpr double kTuftSquare_m = 4;
// In a view the viewer walks on lawns too, so tufts near the eye do not end beside paths.
constexpr double kViewFarShare = 0.5;
// Room for tufts and for the slope of a square, up and down.
constexpr double kTuftRoom_m = 2;

// Half of the height of the tallest tuft: tufts keep this far from walls.
constexpr double kBesideWall_m = 0.5;

// Steps of colours: few, so that many tufts share a mesh.
constexpr double kColourSteps = 256, kColourStep = 4;

// Between blades light is lost: so much brighter leaves make tufts as light as the ground, as measured in pictures.
constexpr double kLeafGain = 1.25;

bool is_grassy(Material material) {
  return material == Material::kGrass || material == Material::kMeadow || material == Material::kDryGrass ||
         material == Material::kScrub || material == Material::kOrchard;
}

// The squares of a cell in which the level has tufts.
std::vector<Box2> tuft_squares(const Baking& baking, const Box2& cell, const ground::GradedTerrain& graded) {
  std::vector<Box2> squares;
  for (double y = cell.min.y; y < cell.max.y; y += kTuftSquare_m)
    for (double x = cell.min.x; x < cell.max.x; x += kTuftSquare_m) {
      const Box2 square{{x, y}, {x + kTuftSquare_m, y + kTuftSquare_m}};
      if (!baking.part) {
        squares.push_back(square);
        continue;
      }
      const double z = map::height_m_at(graded.terrain, square.centre());
      const View& view = baking.part->levels.view;
      const int level = level_for(view, {square, z - kTuftRoom_m, z + kTuftRoom_m});
      if (has_detail(Detail::kGrassTufts, tolerance_m_of(view, level))) squares.push_back(square);
    }
  return squares;
}

Box2 box_around(const std::vector<Box2>& squares) {
  Box2 all;
  for (const Box2& square : squares) all.grow(square.min), all.grow(square.max);
  return all;
}

// The tint of the ground at a tuft, as in its mesh; nothing where the ground is no grass.
std::optional<TintFactor> ground_colour(const scene::Header& header, const ground::LandCoverPolygon& polygon, Vec3 at,
                                        Vec3 normal) {
  const ground::DryShares dry =
      ground::dry_shares(polygon.surface, climate_mix_at(header.climate, in_plan(at)), local_month_of(header));
  const Material material = material_of({.surface = polygon.surface, .normal = normal, .centre = at, .dry = dry},
                                        header.snow_line_m, header.seed);
  if (!is_grassy(material)) return std::nullopt;
  TintFactor tint = times(surface_tint(polygon, material, header.seed, month_of(header)),
                          place_tint(in_plan(at), material, header.seed));
  if (material == Material::kDryGrass) tint = times(tint, dry_tint(polygon.surface, dry));
  const auto& base = materials::values_of(material).base_colour;
  return times(tint, {base[0], base[1], base[2]});
}

std::array<std::uint8_t, 3> stepped_colour(const TintFactor& colour, double brightness) {
  const auto step = [brightness](double c) {
    const double steps = std::floor(c * brightness * kColourSteps / kColourStep + 0.5) * kColourStep;
    return static_cast<std::uint8_t>(std::clamp(steps, 0.0, 255.0));
  };
  return {step(colour.red), step(colour.green), step(colour.blue)};
}

// Neighbours differ a little. The heading is as random as any number.
double brightness_of(const Placement& placement) {
  if (std::abs(placement.cos_yaw) < 0.5) return 1;
  return placement.cos_yaw > 0 ? 1.15 : 0.85;
}

bool is_solid(map::BarrierKind kind) {
  using enum map::BarrierKind;
  return kind == kWall || kind == kCityWall || kind == kRetainingWall || kind == kHedge;
}

// The pieces of walls and hedges in a box.
std::vector<plants::TuftObstacle> obstacles_in(std::span<const props::Barrier> barriers, const Box2& box) {
  std::vector<plants::TuftObstacle> obstacles;
  for (const props::Barrier& barrier : barriers)
    for (std::size_t i = 0; is_solid(barrier.kind) && i + 1 < barrier.axis.size(); ++i) {
      const Vec2 from = barrier.axis[i], to = barrier.axis[i + 1];
      if (box_of_segment(from, to).widened(barrier.width_m / 2).touches(box))
        obstacles.push_back({from, to, barrier.width_m / 2});
    }
  return obstacles;
}

void add_tufts(BakedTufts& baked, const Baking& baking, plants::TuftGround land, const Box2& square,
               std::span<const props::Barrier> barriers) {
  const std::vector<plants::TuftObstacle> obstacles = obstacles_in(barriers, square.widened(kBesideWall_m));
  land.obstacles = obstacles;
  const double spacing_m = baking.part ? kViewTuftSpacing_m : kTileTuftSpacing_m;
  for (const Tuft& tuft : place_tufts(land, square, spacing_m)) {
    const Vec3 at = tuft.placement.at, normal = normal_at(land.graded.terrain, in_plan(at));
    const auto colour = ground_colour(baking.header, land.cover.surfaces[tuft.surface], at, normal);
    if (!colour) continue;
    baked[{tuft.form, tuft.variant, stepped_colour(*colour, brightness_of(tuft.placement))}].push_back(tuft.placement);
  }
}

void add_tufts_of_cell(BakedTufts& baked, const Baking& baking, const TileLevel& level, const Box2& cell) {
  const ground::GradedTerrain& graded = *level.shared->graded;
  const std::vector<Box2> squares = tuft_squares(baking, cell, graded);
  if (squares.empty()) return;
  const Box2 box = box_around(squares), wide = box.widened(plants::kTuftReach_m + kTuftSquare_m);
  const std::vector<ground::LandCoverPolygon> walked = plants::walked_ground(level.cover->surfaces, wide);
  const ground::LandCoverIndex cover_index = ground::index_land_cover(level.cover->surfaces, box.widened(1)),
                               walked_index = ground::index_land_cover(walked, wide);
  const plants::TuftGround land{.cover = cover_index,
                                .walked = walked_index,
                                .graded = graded,
                                .climate = baking.header.climate,
                                .local_month = local_month_of(baking.header),
                                .month = month_of(baking.header),
                                .seed = baking.header.seed,
                                .far_share = baking.part ? kViewFarShare : 0};
  constexpr double kNear_m = plants::kTuftReach_m + kTuftSquare_m;
  for (const Box2& square : squares)
    if (land.far_share > 0 || clearance_m(walked_index, square.centre(), 0, kNear_m) < kNear_m)
      add_tufts(baked, baking, land, square, level.barriers);
}

std::string name_of_tufts(const TuftKind& kind) {
  constexpr const char* kNames[] = {"grass", "tall_grass", "daisy", "dandelion", "clover", "buttercup"};
  static_assert(std::size(kNames) == static_cast<std::size_t>(plants::TuftForm::kCount));
  const auto& [red, green, blue] = kind.colour;
  return fmt::format("tuft_of_{}_{}_{:02x}{:02x}{:02x}", kNames[static_cast<std::size_t>(kind.form)], kind.variant, red,
                     green, blue);
}

plants::LeafColour leaf_colour_of(const TuftKind& kind) {
  const auto brighter = [](std::uint8_t c) { return c / kColourSteps * kLeafGain; };
  return {brighter(kind.colour[0]), brighter(kind.colour[1]), brighter(kind.colour[2])};
}

}  // namespace

BakedTufts tufts_on(const Baking& baking, const TileLevel& level) {
  BakedTufts baked;
  if (!has_detail(Detail::kGrassTufts, baking.tolerance_m)) return baked;
  for (const ViewCell& cell : level.seen) add_tufts_of_cell(baked, baking, level, cell.level.cell);
  return baked;
}

void bake_tufts(Baking& baking, const BakedTufts& tufts) {
  for (const auto& [kind, placements] : tufts) {
    InstancedMesh instanced = instances_of(baking, name_of_tufts(kind), placements, 1);
    instanced.primitives =
        instanced_primitives(plants::tuft_mesh(kind.form, kind.variant, leaf_colour_of(kind)), Layer::kPlants);
    baking.tile.instanced.push_back(std::move(instanced));
  }
}

}  // namespace citykiln::bake
