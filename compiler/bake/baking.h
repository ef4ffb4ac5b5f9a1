// A tile while it is being fired: meshes that wait to be merged, and what they stray at most.
#pragma once

#include <algorithm>
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

/// What a tile becomes, while it is being fired.
struct Baking {
  const scene::Header& header;
  const scene::Chunk& chunk;
  double tolerance_m;
  BakedTile& tile;
  const TilePart* part = nullptr;  // null: all of the tile
  std::vector<MaterialMesh> meshes{};
  std::set<OsmId> features{OsmId{}};

  bool holds(const Bounds& bounds) const { return !part || is_in(*part, bounds); }
  // of sheets and textures, which all parts of a view share
  double texel_m() const { return part ? part->levels.finest_m : tolerance_m; }

  void take(std::vector<MaterialMesh>&& more) {
    for (MaterialMesh& mesh : more) {
      features.insert(mesh.feature);
      meshes.push_back(std::move(mesh));
    }
  }
  void certify(double error_m, const Bounds& bounds) {
    tile.error_m = std::max(tile.error_m, error_m);
    if (!part) return;
    double& largest_px = tile.viewpoint->pixel_error;
    largest_px = std::max(largest_px, pixels_of(part->levels.view, error_m, bounds));
  }
};

/// Expands every object of one kind; an object of which nothing is left counts as dropped by the tolerance.
template <typename Object, typename BoundsOf, typename Expand>
void bake_each(Baking& baking, const std::vector<Object>& objects, const char* kind, Report& report, BoundsOf bounds_of,
               Expand generate) {
  Account account;
  for (const Object& object : objects) {
    const Bounds bounds = bounds_of(object);
    if (!baking.holds(bounds)) continue;
    ++account.in;
    auto expanded = generate(object);
    baking.certify(expanded.error_m, bounds);
    if (expanded.meshes.empty()) {
      report.drop(account, Code::kBelowTolerance, object.id.osm, expanded.error_m);
      continue;
    }
    ++account.out;
    baking.take(std::move(expanded.meshes));
  }
  report.account("bake", kind) = account;
}

/// The feature's place in the tile's list.
std::uint32_t number_of(const BakedTile& tile, OsmId feature);

}  // namespace citykiln::bake
