// The state of a tile while it is baked: meshes that are not merged yet, and their largest error. To bake a tile is to
// generate its meshes from recipes at a tolerance.
#pragma once

#include <algorithm>
#include <cassert>
#include <set>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/bake/bounds.h"
#include "compiler/bake/view/view_levels.h"
#include "compiler/contract/derived_id.h"
#include "compiler/contract/findings/report.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

using materials::MaterialMesh;

struct CellBaking;

/// A whole tile while it is baked, or one part of it. For a viewpoint, a tile is baked in parts: each consists of the
/// objects and the cells (128 m squares of ground) that have one tolerance.
struct Baking {
  const scene::Header& header;
  const scene::Chunk& chunk;
  double tolerance_m;
  BakedTile& tile;                    ///< The result; receives errors and features.
  const TilePart* part = nullptr;     ///< The part of a tile for a viewpoint; null: the whole tile.
  const CellBaking* cell = nullptr;   ///< Data for baking a single cell (baked_cell.h); null: a whole tile or part.
  std::vector<LayeredMesh> meshes{};  ///< Meshes that are not merged yet.
  std::set<OsmId> features{OsmId{}};  ///< The map elements of these meshes, and none.

  /// True if an object with these bounds belongs to the part, or the whole tile is baked.
  bool holds(const Bounds& bounds) const { return !part || is_in_part(*part, bounds); }
  /// The texel size of marking atlas and textures, in metres. All parts of a tile for a viewpoint share one.
  double texel_m() const { return part ? tolerance_m_of(part->levels.view, part->levels.finest) : tolerance_m; }

  /// Adds meshes and their features.
  void take(std::vector<LayeredMesh>&& more) {
    for (LayeredMesh& each : more) {
      features.insert(each.mesh.feature);
      meshes.push_back(std::move(each));
    }
  }
  void take(std::vector<MaterialMesh>&& more, Layer layer) {
    for (MaterialMesh& mesh : more) {
      features.insert(mesh.feature);
      meshes.push_back({std::move(mesh), layer});
    }
  }
  /// Raises the stated errors of the tile to the error of one object: in metres and, for a viewpoint, in pixels.
  /// @param bounds  Bounds of the object; its nearest point decides the error in pixels.
  void certify(double error_m, const Bounds& bounds) {
    tile.object_error_m = std::max(tile.object_error_m, error_m);
    certify_terrain(error_m, bounds);
  }
  /// Raises them to the error of a piece of terrain.
  void certify_terrain(double error_m, const Bounds& bounds) {
    tile.error_m = std::max(tile.error_m, error_m);
    if (!part) return;
    double& largest_px = tile.viewpoint->pixel_error;
    largest_px = std::max(largest_px, pixels_of(part->levels.view, error_m, bounds));
  }
};

/// Generates every object of one kind that belongs to the baked part, adds its meshes to a layer and its error to the
/// tile. An object that gives no mesh at this tolerance is dropped, kBelowTolerance; if it is derived from another one,
/// such as a fence of a yard, it is only counted.
/// @param kind                 The objects are counted in the account "bake/<kind>" of the report's ledger.
/// @param bounds_of, generate  Functions of an object; generate() returns meshes and error_m.
template <typename Object, typename BoundsOf, typename Generate>
void bake_each(Baking& baking, Layer layer, const std::vector<Object>& objects, const char* kind, Report& report,
               BoundsOf bounds_of, Generate generate) {
  Account account;
  for (const Object& object : objects) {
    const Bounds bounds = bounds_of(object);
    if (!baking.holds(bounds)) continue;
    ++account.in;
    auto generated = generate(object);
    baking.certify(generated.error_m, bounds);
    if (generated.meshes.empty()) {
      if (is_derived(object.id))
        ++account.dropped[Code::kBelowTolerance];
      else
        report.drop(account, Code::kBelowTolerance, object.id.osm, generated.error_m);
      continue;
    }
    ++account.out;
    baking.take(std::move(generated.meshes), layer);
  }
  report.account("bake", kind) = account;
}

/// The index of a feature in tile.features, which must contain it.
inline std::uint32_t feature_index(const BakedTile& tile, OsmId feature) {
  const auto found = std::ranges::lower_bound(tile.features, feature);
  assert(found != tile.features.end() && *found == feature);
  return static_cast<std::uint32_t>(found - tile.features.begin());
}

}  // namespace citykiln::bake
