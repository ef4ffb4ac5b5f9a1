#include "compiler/bake/far/bake_surroundings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "compiler/bake/far/far_buildings.h"
#include "compiler/bake/far/far_land.h"
#include "compiler/bake/far/far_ways.h"
#include "compiler/bake/far/far_windows.h"
#include "compiler/bake/far/patchwork.h"
#include "compiler/bake/image_uvs.h"
#include "compiler/bake/merge.h"
#include "compiler/scene/ground_lookup.h"
#include "compiler/surroundings/curvature.h"
#include "compiler/surroundings/generate.h"

namespace citykiln::bake {
namespace {

using surroundings::Patch;

// The open water that goes on beyond a place on the border.
surroundings::Cover cover_on_border(const scene::GroundPlace& ground) {
  if (ground.cover == map::LandCoverClass::kSea) return surroundings::Cover::kSea;
  const bool is_water = map::values_of(ground.cover).group == map::LandCoverGroup::kWater;
  return is_water ? surroundings::Cover::kLake : surroundings::Cover::kLand;
}

// The grid's heights leave those of the tiles' border within this distance.
constexpr double kHeightBlend_m = 320;

// Whole metres, in the middle of the extent.
Vec3 surroundings_origin(const scene::Header& header) {
  const Vec2 middle = header.extent.centre();
  return {std::floor(middle.x), std::floor(middle.y), std::floor(header.sky.ground_m)};
}

double distance_of(const Box2& a, const Box2& b) {
  return length(Vec2{std::max({a.min.x - b.max.x, b.min.x - a.max.x, 0.0}),
                     std::max({a.min.y - b.max.y, b.min.y - a.max.y, 0.0})});
}

// The tiles of a scene's chunks.
struct Tiles {
  std::vector<Box2> boxes;   // all
  std::vector<Box2> beside;  // those with a side that is no other tile's
  double border_m = 0;       // the length of these sides
};

Tiles tiles_in(const scene::Scene& scene, const scene::GroundLookup& lookup) {
  Tiles tiles;
  for (const scene::Chunk& chunk : scene.chunks) {
    const Box2 box = scene::box_of(scene.header, chunk.tile);
    tiles.boxes.push_back(box);
    const Vec2 middle = box.centre();
    const double before_m = tiles.border_m;
    const auto is_free = [&](Vec2 outside) { return !lookup.is_in_tile(outside); };
    if (is_free({box.min.x - 1, middle.y})) tiles.border_m += box.height();
    if (is_free({box.max.x + 1, middle.y})) tiles.border_m += box.height();
    if (is_free({middle.x, box.min.y - 1})) tiles.border_m += box.width();
    if (is_free({middle.x, box.max.y + 1})) tiles.border_m += box.width();
    if (tiles.border_m > before_m) tiles.beside.push_back(box);
  }
  return tiles;
}

double distance_to(const Tiles& tiles, const Box2& box) {
  double least_m = distance_of(tiles.beside.front(), box);
  for (const Box2& tile : tiles.beside) least_m = std::min(least_m, distance_of(tile, box));
  return least_m;
}

// Finer cells where the border is short, so that all scenes have about as many.
std::int32_t finest_cell_m(double border_m) { return border_m <= 16000 ? 32 : border_m <= 48000 ? 64 : 128; }

Vec2 nearest_in(const Box2& box, Vec2 p) {
  return {std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y)};
}

// The height of the land: that of the grid, and beside the tiles of what lies on their border.
double land_height_m(const scene::GroundLookup& lookup, const Tiles& tiles, const surroundings::Surroundings& grid,
                     Vec2 place) {
  const double height_m = surroundings::height_m_at(grid, place);
  const Box2 point{place, place};
  const Box2* nearest = &tiles.beside.front();
  for (const Box2& tile : tiles.beside)
    if (distance_of(tile, point) < distance_of(*nearest, point)) nearest = &tile;
  const double away_m = distance_of(*nearest, point);
  if (away_m >= kHeightBlend_m) return height_m;
  const Vec2 on_border = nearest_in(*nearest, place);
  const double left = 1 - away_m / kHeightBlend_m,
               step_m = lookup.at(on_border).height_m - surroundings::height_m_at(grid, on_border);
  return height_m + step_m * left * left * (3 - 2 * left);
}

// Adds meshes to a tile.
void add(std::vector<materials::MaterialMesh>&& meshes, Layer layer, Vec3 origin, PrimitiveMap& merged) {
  for (materials::MaterialMesh& mesh : meshes) {
    const bool is_water = materials::is_water(mesh.material);
    merge(merged, {std::move(mesh), is_water ? Layer::kWater : layer}, origin, 0);
  }
}

}  // namespace

std::optional<BakedTile> bake_surroundings(const scene::Scene& scene, EarthCurve curve) {
  const surroundings::Surroundings& grid = scene.header.around;
  if (grid.is_empty() || scene.chunks.empty()) return std::nullopt;
  const scene::GroundLookup lookup(scene);
  const FarLand land = far_land_of(lookup, scene.header);
  const Patchwork patchwork(lookup, scene.header);
  const Tiles tiles = tiles_in(scene, lookup);
  const bool is_curved = curve == EarthCurve::kAsSeen;
  const auto away_m = [&](Vec2 p) { return distance_to(tiles, {p, p}); };
  // heights above sea level, from those in the mesh
  const auto above_sea = [&](Vec3 at) {
    const double drop_m = is_curved ? surroundings::drop_m(surroundings::away_m(scene.header.extent, in_plan(at))) : 0;
    return at + Vec3{0, 0, drop_m};
  };
  const surroundings::Neighbourhood neighbourhood{
      .is_curved = is_curved,
      .extent = scene.header.extent,
      .finest_m = finest_cell_m(tiles.border_m),
      .away_m = [&](const Box2& box) { return distance_to(tiles, box); },
      .is_in_tile = [&](Vec2 place) { return lookup.is_in_tile(place); },
      .on_border =
          [&](Vec2 place) {
            const scene::GroundPlace ground = lookup.at(place);
            return surroundings::BorderGround{ground.height_m, cover_on_border(ground)};
          },
      .height_m_at = [&](Vec2 place) { return land_height_m(lookup, tiles, grid, place); },
      .patch_of =
          [&](const surroundings::Cell& cell) { return patchwork.patch_of(cell, distance_to(tiles, cell.box())); },
      .patch_on_border = [&](Vec2 place) { return patchwork.patch_on_border(place); },
      .material_at = [&](const Patch& patch, Vec3 at,
                         Vec3 normal) { return material_of(land, patch, above_sea(at), normal, away_m(in_plan(at))); },
      .tint_at =
          [&](const Patch& patch, materials::Material material, Vec3 at, Vec3 normal) {
            return tint_of(land, patch, material, above_sea(at), normal, away_m(in_plan(at)));
          }};
  const surroundings::AroundSurface surface(grid, neighbourhood);
  const double error_m = grid.error_m + surface.distance_from_grid_m();
  BakedTile tile{.tile = kSurroundingsTile,
                 .origin = surroundings_origin(scene.header),
                 .tolerance_m = std::max(error_m, 1.0),
                 .error_m = error_m,
                 .features = {OsmId{}}};
  PrimitiveMap merged;
  add(surface.meshes(), Layer::kGround, tile.origin, merged);
  add(far_ways(scene, land, surface), Layer::kRoads, tile.origin, merged);
  add(far_buildings(scene, patchwork, surface), Layer::kBuildings, tile.origin, merged);
  tile.primitives = primitives_of(std::move(merged));
  const auto shows_windows = [](const Primitive& primitive) {
    return primitive.colour_source == materials::ColourSource::kByAtlas;
  };
  if (std::ranges::any_of(tile.primitives, shows_windows)) tile.facade_atlas = far_windows();
  snap_image_uvs(tile);
  return tile;
}

}  // namespace citykiln::bake
