// Simple solids as baked tiles, for which light can be computed by hand.
#pragma once

#include <initializer_list>
#include <vector>

#include "compiler/bake/baked_tile.h"

namespace citykiln::preview {

inline bake::Float3 narrowed(Vec3 v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// Adds a flat quadrilateral, corners counter-clockwise from outside; each corner has the plane's own normal.
inline void add_quad(bake::Primitive& primitive, Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const auto first = static_cast<std::uint32_t>(primitive.positions.size());
  const Vec3 normal = unit(cross(b - a, d - a));
  for (const Vec3& corner : {a, b, c, d}) {
    primitive.positions.push_back(narrowed(corner));
    primitive.normals.push_back(narrowed(normal));
    primitive.colours.push_back(materials::kNoTint);
    primitive.features.push_back(0);
  }
  primitive.triangles.push_back({first, first + 1, first + 2});
  primitive.triangles.push_back({first, first + 2, first + 3});
}

/// A level rectangle seen from above.
inline bake::Primitive floor(Vec3 low, Vec3 high, materials::Material material) {
  bake::Primitive primitive{material, {}, {}, {}, {}, {}};
  add_quad(primitive, low, {high.x, low.y, low.z}, {high.x, high.y, low.z}, {low.x, high.y, low.z});
  return primitive;
}

/// A closed box seen from outside.
inline bake::Primitive box(Vec3 low, Vec3 high, materials::Material material) {
  bake::Primitive primitive{material, {}, {}, {}, {}, {}};
  const auto at = [&](int x, int y, int z) {
    return Vec3{x != 0 ? high.x : low.x, y != 0 ? high.y : low.y, z != 0 ? high.z : low.z};
  };
  add_quad(primitive, at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
  add_quad(primitive, at(0, 1, 0), at(1, 1, 0), at(1, 0, 0), at(0, 0, 0));
  add_quad(primitive, at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));
  add_quad(primitive, at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1));
  add_quad(primitive, at(1, 1, 0), at(0, 1, 0), at(0, 1, 1), at(1, 1, 1));
  add_quad(primitive, at(0, 1, 0), at(0, 0, 0), at(0, 0, 1), at(0, 1, 1));
  return primitive;
}

inline bake::BakedTile tile(Vec3 origin, std::vector<bake::Primitive> primitives) {
  bake::BakedTile tile;
  tile.origin = origin;
  tile.features = {OsmId{}};
  tile.primitives = std::move(primitives);
  return tile;
}

}  // namespace citykiln::preview
