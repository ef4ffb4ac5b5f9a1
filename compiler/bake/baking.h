// The state of a tile while it is baked: meshes that are not merged yet, and their largest error.
#pragma once

#include <algorithm>
#include <cassert>
#include <set>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/bake/bounds.h"
#include "compiler/bake/view_levels.h"
#include "compiler/contract/report.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

using materials::MaterialMesh;

struct CellBaking;

/// A tile, or one part of a tile or cell for a view, while it is baked.
struct Baking {
  const scene::Header& header;
  const scene::Chunk& chunk;
  double tolerance_m;
  BakedTile& tile;
  const TilePart* part = nullptr;    ///< The part of a view; null: the whole tile.
  const CellBaking* cell = nullptr;  ///< Data for a cell (baked_cell.h); null: a whole tile or part.
  std::vector<LayeredMesh> meshes{};
  std::set<OsmId> features{OsmId{}};

  /// True if an object belongs to the baked part of the tile.
  bool holds(const Bounds& bounds) const { return !part || is_in_part(*part, bounds); }
  /// The texel size of marking atlas and textures, which all parts of a view share.
  double texel_m() const { return part ? tolerance_m_of(part->levels.view, part->levels.finest) : tolerance_m; }

  /// Adds meshes.
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
  /// Raises the tile's error_m, and for views its error in pixels, to the error of an object.
  void certify(double error_m, const Bounds& bounds) {
    tile.error_m = std::max(tile.error_m, error_m);
    if (!part) return;
    double& largest_px = tile.viewpoint->pixel_error;
    largest_px = std::max(largest_px, pixels_of(part->levels.view, error_m, bounds));
  }
};

/// Generates every object of one kind and adds its meshes to a layer. An object without meshes is dropped,
/// kBelowTolerance.
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
      report.drop(account, Code::kBelowTolerance, object.id.osm, generated.error_m);
      continue;
    }
    ++account.out;
    baking.take(std::move(generated.meshes), layer);
  }
  report.account("bake", kind) = account;
}

/// The index of a feature, which must be one of the tile's features.
inline std::uint32_t number_of(const BakedTile& tile, OsmId feature) {
  const auto found = std::ranges::lower_bound(tile.features, feature);
  assert(found != tile.features.end() && *found == feature);
  return static_cast<std::uint32_t>(found - tile.features.begin());
}

}  // namespace citykiln::bake
