// The fired form: meshes and instances of one tile at one tolerance, in single precision about the tile's origin, ready
// to be written or looked at.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/materials/material.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

using Float3 = std::array<float, 3>;
using Float4 = std::array<float, 4>;

/// All triangles of one material. Frame: x east, y north, z up, metres from the tile's origin (archetypes: from their
/// own). Vertices are shared.
struct Primitive {
  materials::Material material{};
  std::vector<Float3> positions;
  std::vector<Float3> normals;           ///< One a position, unit length.
  std::vector<materials::Tint> colours;  ///< One a position.
  std::vector<std::uint32_t> features;   ///< One a position: index into BakedTile::features.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool operator==(const Primitive&) const = default;
};

/// A mesh that stands in many places.
struct Instanced {
  std::string name;                   ///< "BroadLeaved".
  std::vector<Primitive> primitives;  ///< `features` empty: the instances have them.
  std::vector<Float3> translations;
  std::vector<Float4> rotations;  ///< Unit quaternions x, y, z, w.
  std::vector<float> scales;
  std::vector<std::uint32_t> features;
  bool operator==(const Instanced&) const = default;
};

struct BakedTile {
  scene::TileKey tile;
  Vec3 origin;                        ///< Plane metres, whole numbers; z too.
  double tolerance_m = 0;             ///< Asked for.
  double error_m = 0;                 ///< Certified: Hausdorff, both ways, to the full-detail shape.
  std::vector<OsmId> features;        ///< Sorted; index 0 is always the none feature.
  std::vector<Primitive> primitives;  ///< Sorted by material, at most one each.
  std::vector<Instanced> instanced;
  bool operator==(const BakedTile&) const = default;
};

}  // namespace citykiln::bake
