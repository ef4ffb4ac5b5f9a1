#include "compiler/bake/far/bend.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/bake/far/split_edges.h"
#include "compiler/geometry/snap.h"

namespace citykiln::bake {
namespace {

/// The data for bending all parts of a tile.
struct Bending {
  const map::Globe& globe;
  const map::Geoid& geoid;
  Vec3 from;          ///< The tile's origin in the plane.
  Vec3 to;            ///< Its origin in the globe's frame.
  double high_m = 0;  ///< The largest height above the ellipsoid so far.

  map::GlobePoint at(const Float3& offset) {
    const Vec3 p = from + widened(offset);
    const double height = p.z + map::height_m(geoid, in_plan(p));
    high_m = std::max(high_m, height);
    return globe.at({p.x, p.y, height});
  }
};

void bend(Primitive& p, Bending& by) {
  const bool is_on_grid = is_terrain(p);
  for (std::size_t i = 0; i < p.positions.size(); ++i) {
    const map::GlobePoint there = by.at(p.positions[i]);
    p.positions[i] = narrowed((is_on_grid ? snapped(there.at) : there.at) - by.to);
    const Vec3 n = widened(p.normals[i]);
    p.normals[i] = narrowed(unit(there.east * n.x + there.north * n.y + there.up * n.z));
  }
}

// The turn from the frame's axes to those at a place; about the origin it is nearly none, so that w is far from 0.
Float4 turn_of(const map::GlobePoint& there) {
  const double w = std::sqrt(std::max(0.0, 1 + there.east.x + there.north.y + there.up.z)) / 2;
  assert(w > 0.1);
  return {static_cast<float>((there.north.z - there.up.y) / (4 * w)),
          static_cast<float>((there.up.x - there.east.z) / (4 * w)),
          static_cast<float>((there.east.y - there.north.x) / (4 * w)), static_cast<float>(w)};
}

// The rotation b, then a.
Float4 product(const Float4& a, const Float4& b) {
  const Vec3 u{a[0], a[1], a[2]}, v{b[0], b[1], b[2]};
  const Vec3 w = cross(u, v) + u * b[3] + v * a[3];
  return {static_cast<float>(w.x), static_cast<float>(w.y), static_cast<float>(w.z),
          static_cast<float>(double{a[3]} * b[3] - dot(u, v))};
}

void bend(InstancedMesh& instanced, Bending& by) {
  for (std::size_t i = 0; i < instanced.translations.size(); ++i) {
    const map::GlobePoint there = by.at(instanced.translations[i]);
    instanced.translations[i] = narrowed(there.at - by.to);
    instanced.rotations[i] = product(turn_of(there), instanced.rotations[i]);
  }
}

// A bound of the rounding of positions to single precision, over that of kQuantum_m.
double rounding_m(const BakedTile& tile) {
  float reach_m = 0;
  for (const Primitive& p : tile.primitives)
    for (const Float3& at : p.positions)
      for (const float c : at) reach_m = std::max(reach_m, std::abs(c));
  constexpr double kDiagonal = 1.7320508075688773;  // of a cube
  return double{reach_m} > kExactReach_m ? kDiagonal * 0x1p-24 * double{reach_m} : 0;
}

// How far the geoid over an edge is from the line between its ends.
double geoid_error_m(const BakedTile& tile, const map::Geoid& geoid) {
  double farthest_m = 0;
  if (geoid.heights_m.size() == 1) return farthest_m;
  const auto at = [&](const Float3& p) { return in_plan(tile.origin + widened(p)); };
  for (const Primitive& p : tile.primitives)
    for (const auto& t : p.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 a = at(p.positions[t[i]]), b = at(p.positions[t[(i + 1) % 3]]);
        const double line_m = (map::height_m(geoid, a) + map::height_m(geoid, b)) / 2;
        farthest_m = std::max(farthest_m, std::abs(map::height_m(geoid, (a + b) * 0.5) - line_m));
      }
  return farthest_m;
}

}  // namespace

BakedTile bent(BakedTile tile, const map::Globe& globe, const map::Geoid& geoid) {
  constexpr double kHalfDiagonal = 0.8660254037844386;  // of a cube
  const double sag_m = kSagShare * tile.tolerance_m;
  for (Primitive& p : tile.primitives) split_long_edges(p, map::length_with_sag_m(sag_m));
  tile.error_m += geoid_error_m(tile, geoid);

  const Vec3 place =
      globe.at({tile.origin.x, tile.origin.y, tile.origin.z + map::height_m(geoid, in_plan(tile.origin))}).at;
  Bending by{globe, geoid, tile.origin, {std::floor(place.x), std::floor(place.y), std::floor(place.z)}};
  for (Primitive& p : tile.primitives) bend(p, by);
  for (InstancedMesh& instanced : tile.instanced) bend(instanced, by);
  tile.origin = by.to;
  const double stretch = 1 + by.high_m / map::kLeastRadius_m;
  tile.error_m = tile.error_m * stretch + sag_m + kHalfDiagonal * kQuantum_m + rounding_m(tile);
  tile.plant_error_m *= stretch;
  return tile;
}

}  // namespace citykiln::bake
