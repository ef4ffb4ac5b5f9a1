#include "compiler/bake/far/bake_surroundings.h"

#include <algorithm>
#include <cmath>

#include "compiler/bake/far/far_land.h"
#include "compiler/bake/merge.h"
#include "compiler/scene/ground_lookup.h"
#include "compiler/surroundings/curvature.h"
#include "compiler/surroundings/generate.h"

namespace citykiln::bake {
namespace {

// Whole metres, in the middle of the extent.
Vec3 surroundings_origin(const scene::Header& header) {
  const Vec2 middle = header.extent.centre();
  return {std::floor(middle.x), std::floor(middle.y), std::floor(header.sky.ground_m)};
}

std::vector<materials::MaterialMesh> meshes_of(const scene::Scene& scene, bool is_curved) {
  const scene::GroundLookup lookup(scene);
  const FarLand land = far_land_of(lookup, scene.header);
  const Box2& extent = scene.header.extent;
  return surroundings::generate(
      scene.header.around,
      {.is_curved = is_curved,
       .extent = extent,
       .is_in_tile = [&](Vec2 place) { return lookup.is_in_tile(place); },
       .on_border =
           [&](Vec2 place) {
             const scene::GroundPlace ground = lookup.at(place);
             return surroundings::BorderGround{ground.height_m, ground.cover == map::LandCoverClass::kSea};
           },
       .land_at =
           [&](Vec3 at, Vec3 normal) {
             const double drop_m = is_curved ? surroundings::drop_m(surroundings::away_m(extent, in_plan(at))) : 0;
             return far_material_of(land, at + Vec3{0, 0, drop_m}, normal);
           }});
}

}  // namespace

std::optional<BakedTile> bake_surroundings(const scene::Scene& scene, EarthCurve curve) {
  if (scene.header.around.is_empty() || scene.chunks.empty()) return std::nullopt;
  const double error_m = scene.header.around.error_m;
  BakedTile tile{.tile = kSurroundingsTile,
                 .origin = surroundings_origin(scene.header),
                 .tolerance_m = std::max(error_m, 1.0),
                 .error_m = error_m,
                 .features = {OsmId{}}};
  PrimitiveMap merged;
  for (materials::MaterialMesh& mesh : meshes_of(scene, curve == EarthCurve::kAsSeen)) {
    const Layer layer = mesh.material == materials::Material::kSea ? Layer::kWater : Layer::kGround;
    merge(merged, {std::move(mesh), layer}, tile.origin, 0);
  }
  tile.primitives = primitives_of(std::move(merged));
  return tile;
}

}  // namespace citykiln::bake
