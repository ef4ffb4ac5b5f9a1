#include "compiler/bake/far/bend.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "compiler/bake/far/split_edges.h"
#include "compiler/geometry/snap.h"

namespace citykiln::bake {
namespace {

/// The data for bending all parts of a tile.
struct Bending {
  std::function<map::BentPoint(Vec3)> curve;  ///< Maps a point of the plane.
  Vec3 from;                                  ///< The tile's origin in the plane.
  Vec3 to{};                                  ///< Its origin in the frame of the curve, in whole metres.

  map::BentPoint at(const Float3& offset) const { return curve(from + widened(offset)); }
};

Bending bending_of(const BakedTile& tile, std::function<map::BentPoint(Vec3)> curve) {
  const Vec3 place = curve(tile.origin).at;
  return {std::move(curve), tile.origin, {std::floor(place.x), std::floor(place.y), std::floor(place.z)}};
}

void bend(Primitive& p, const Bending& by) {
  const bool is_on_grid = is_terrain(p);
  for (std::size_t i = 0; i < p.positions.size(); ++i) {
    const map::BentPoint there = by.at(p.positions[i]);
    p.positions[i] = narrowed((is_on_grid ? snapped(there.at) : there.at) - by.to);
    const Vec3 n = widened(p.normals[i]);
    p.normals[i] = narrowed(unit(there.east * n.x + there.north * (n.y / there.along_north) + there.up * n.z));
  }
}

/// A turn as a unit quaternion, in double precision.
struct Turn {
  Vec3 axis;  ///< Times the sine of half of the angle.
  double w;
};

// The turn from the frame's axes to those at a place: from the largest of its four components (Shepperd 1978), since
// inside of a cylinder it may be half a turn.
Turn turn_of(const map::BentPoint& there) {
  const Vec3 &e = there.east, &n = there.north, &u = there.up;
  const double w4 = 1 + e.x + n.y + u.z, x4 = 1 + e.x - n.y - u.z;
  if (w4 >= 1) {
    const double w = std::sqrt(w4) / 2;
    return {Vec3{n.z - u.y, u.x - e.z, e.y - n.x} * (1 / (4 * w)), w};
  }
  // on the far side of a cylinder, whose axis is x
  assert(x4 >= 1);
  const double x = std::sqrt(x4) / 2;
  return {{x, (n.x + e.y) / (4 * x), (u.x + e.z) / (4 * x)}, (n.z - u.y) / (4 * x)};
}

// The rotation b, then a.
Float4 product(const Turn& a, const Float4& b) {
  const Vec3 v{b[0], b[1], b[2]};
  const Vec3 w = cross(a.axis, v) + a.axis * b[3] + v * a.w;
  return {static_cast<float>(w.x), static_cast<float>(w.y), static_cast<float>(w.z),
          static_cast<float>(a.w * b[3] - dot(a.axis, v))};
}

void bend(InstancedMesh& instanced, const Bending& by) {
  for (std::size_t i = 0; i < instanced.translations.size(); ++i) {
    const map::BentPoint there = by.at(instanced.translations[i]);
    instanced.translations[i] = narrowed(there.at - by.to);
    instanced.rotations[i] = product(turn_of(there), instanced.rotations[i]);
  }
}

void bend(BakedTile& tile, const Bending& by) {
  for (Primitive& p : tile.primitives) bend(p, by);
  for (InstancedMesh& instanced : tile.instanced) bend(instanced, by);
  tile.origin = by.to;
}

/// A range of numbers; the default is empty.
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void grow(double v) { low = std::min(low, v), high = std::max(high, v); }
  double extent() const { return high - low; }
};

// The heights of a tile's vertices and instances, plane metres, z = 0 included.
Range heights_of(const BakedTile& tile) {
  Range heights{0, 0};
  for (const Primitive& p : tile.primitives)
    for (const Float3& at : p.positions) heights.grow(tile.origin.z + at[2]);
  for (const InstancedMesh& mesh : tile.instanced)
    for (const Float3& at : mesh.translations) heights.grow(tile.origin.z + at[2]);
  return heights;
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

constexpr double kHalfDiagonal = 0.8660254037844386;  // of a cube

// The largest sag of a tile's triangles inside of a cylinder.
double largest_sag_m(const BakedTile& tile, const map::Cylinder& cylinder, double stretch) {
  double largest_m = 0;
  for (const Primitive& p : tile.primitives)
    for (const auto& triangle : p.triangles) {
      Range y, z;
      for (const std::uint32_t i : triangle) y.grow(p.positions[i][1]), z.grow(p.positions[i][2]);
      largest_m = std::max(largest_m, map::sag_m(cylinder, y.extent(), z.extent(), stretch));
    }
  return largest_m;
}

InstanceSize size_of(const InstancedMesh& mesh) {
  InstanceSize size;
  for (const Primitive& p : mesh.primitives)
    for (const Float3& at : p.positions) {
      size.across_m = std::max(size.across_m, length(in_plan(widened(at))));
      size.high_m = std::max(size.high_m, std::abs(double{at[2]}));
    }
  return size;
}

// A bound of the distance between an instance, which keeps its shape, and the bent one: the factor of lengths along y
// at its height, and half of the second derivative of map::at().
double rigidity_m(const InstanceSize& size, double z_m, const map::Cylinder& cylinder, double stretch) {
  return size.across_m * std::abs(z_m) / cylinder.radius_m +
         4 * map::sag_m(cylinder, size.across_m, size.high_m, stretch);
}

// The largest of those of a mesh.
double rigidity_m(const InstancedMesh& mesh, double origin_z_m, const map::Cylinder& cylinder, double stretch) {
  const InstanceSize size = size_of(mesh);
  double largest_m = 0;
  for (std::size_t i = 0; i < mesh.translations.size(); ++i) {
    const bool is_upright = mesh.rotations[i][0] == 0 && mesh.rotations[i][1] == 0;
    const double most_m = length(Vec2{size.across_m, size.high_m});
    const InstanceSize copy{mesh.scales[i] * (is_upright ? size.across_m : most_m),
                            mesh.scales[i] * (is_upright ? size.high_m : most_m)};
    largest_m = std::max(largest_m, rigidity_m(copy, origin_z_m + mesh.translations[i][2], cylinder, stretch));
  }
  return largest_m;
}

double middle_y_m(const BakedTile& tile) {
  Range y;
  for (const Primitive& p : tile.primitives)
    for (const Float3& at : p.positions) y.grow(tile.origin.y + at[1]);
  for (const InstancedMesh& mesh : tile.instanced)
    for (const Float3& at : mesh.translations) y.grow(tile.origin.y + at[1]);
  return y.low <= y.high ? (y.low + y.high) / 2 : tile.origin.y;
}

}  // namespace

BakedTile bent(BakedTile tile, const map::Globe& globe, const map::Geoid& geoid) {
  const double sag_m = kSagShare * tile.tolerance_m, longest_m = map::length_with_sag_m(sag_m);
  const auto is_long = [&](Vec3 along) { return dot(along, along) > longest_m * longest_m; };
  for (Primitive& p : tile.primitives) split_long_edges(p, is_long);
  tile.error_m += geoid_error_m(tile, geoid);
  double high_m = 0;  // above the ellipsoid
  bend(tile, bending_of(tile, [&](Vec3 p) {
         p.z += map::height_m(geoid, in_plan(p));
         high_m = std::max(high_m, p.z);
         return globe.at(p);
       }));
  const double stretch = 1 + high_m / map::kLeastRadius_m;
  tile.error_m = tile.error_m * stretch + sag_m + kHalfDiagonal * kQuantum_m + rounding_m(tile);
  tile.object_error_m = tile.error_m;
  tile.plant_error_m *= stretch;
  return tile;
}

BakedTile bent(BakedTile tile, const map::Cylinder& cylinder) {
  const double most_sag_m = kCylinderSagShare * tile.tolerance_m;
  const auto is_long = [&](Vec3 along) {
    return map::sag_m(cylinder, std::abs(along.y), std::abs(along.z)) > most_sag_m;
  };
  for (Primitive& p : tile.primitives) split_long_edges(p, is_long);
  const double stretch = map::stretch(cylinder, heights_of(tile).low);
  double rigid_m = 0, rigid_plants_m = 0;
  for (const InstancedMesh& mesh : tile.instanced) {
    double& of_layer = layer_of(mesh) == Layer::kPlants ? rigid_plants_m : rigid_m;
    of_layer = std::max(of_layer, rigidity_m(mesh, tile.origin.z, cylinder, stretch));
  }
  const double sag_m = largest_sag_m(tile, cylinder, stretch);
  tile.cylinder = CylinderFrame{cylinder.radius_m, middle_y_m(tile)};
  bend(tile, bending_of(tile, [&](Vec3 p) { return map::at(cylinder, p); }));
  tile.error_m = tile.error_m * stretch + std::max(sag_m, rigid_m) + kHalfDiagonal * kQuantum_m + rounding_m(tile);
  tile.object_error_m = tile.error_m;
  tile.plant_error_m = tile.plant_error_m * stretch + rigid_plants_m;
  return tile;
}

namespace {

// A bound of rounding_m() for a tile that reaches from one side of the bounds to the other.
double rounding_bound_m(const Bounds& bounds) {
  const double reach_m = bounds.plan.width() + bounds.plan.height() + bounds.high_m - bounds.low_m;
  return kHalfDiagonal * kQuantum_m + 0x1p-23 * reach_m;
}

// Half of the range of the geoid's heights near a box.
double geoid_error_bound_m(const Box2& box, const map::Geoid& geoid) {
  if (geoid.heights_m.size() == 1) return 0;
  Range heights;
  for (double y = box.min.y; y < box.max.y + geoid.step_m; y += geoid.step_m)
    for (double x = box.min.x; x < box.max.x + geoid.step_m; x += geoid.step_m)
      heights.grow(map::height_m(geoid, {std::min(x, box.max.x), std::min(y, box.max.y)}));
  return heights.extent();
}

}  // namespace

double bent_error_bound_m(double shape_m, double tolerance_m, const Bounds& bounds, const map::Geoid& geoid) {
  const double high_m = std::max(0.0, bounds.high_m + std::ranges::max(geoid.heights_m));
  return (shape_m + geoid_error_bound_m(bounds.plan, geoid)) * (1 + high_m / map::kLeastRadius_m) +
         kSagShare * tolerance_m + rounding_bound_m(bounds);
}

double bent_error_bound_m(double shape_m, double tolerance_m, const Bounds& bounds, const map::Cylinder& cylinder,
                          const InstanceSize& largest) {
  // extents of a triangle along y and z may be those of two of its edges, of which each keeps the limit
  constexpr double kOfTwoEdges = 4;
  const double stretch = map::stretch(cylinder, std::min(0.0, bounds.low_m));
  const double farthest_m = std::max(std::abs(bounds.low_m), std::abs(bounds.high_m));
  const double most_m = length(Vec2{largest.across_m, largest.high_m});
  const double rigid_m = rigidity_m(InstanceSize{most_m, most_m}, farthest_m, cylinder, stretch);
  return shape_m * stretch + std::max(kOfTwoEdges * kCylinderSagShare * tolerance_m * stretch, rigid_m) +
         rounding_bound_m(bounds);
}

BakedTile in_world(BakedTile tile, const scene::Header& header) {
  const auto cylinder = scene::cylinder_of(header);
  if (cylinder) return bent(std::move(tile), *cylinder);
  return tile;
}

std::vector<PlacedLamp> in_world(std::vector<PlacedLamp> lamps, const scene::Header& header) {
  const auto cylinder = scene::cylinder_of(header);
  if (!cylinder) return lamps;
  for (PlacedLamp& lamp : lamps) {
    const Vec3 glass = props::glass_of(lamp.placement, lamp.kind);
    const map::BentPoint there = map::at(*cylinder, glass);
    lamp.placement.at = lamp.placement.at + there.at - glass, lamp.up = there.up;
  }
  return lamps;
}

BakedTile flattened(BakedTile tile) {
  if (!tile.cylinder) return tile;
  const auto [radius_m, middle_y_m] = *tile.cylinder;
  const map::Cylinder cylinder{radius_m};
  const Vec3 from = tile.origin, to{from.x, std::floor(middle_y_m), 0};
  const auto in_plane = [&, y_m = middle_y_m](const Float3& p) {
    return map::flattened(cylinder, from + widened(p), y_m);
  };
  for (Primitive& p : tile.primitives)
    for (std::size_t i = 0; i < p.positions.size(); ++i) {
      const Vec3 there = in_plane(p.positions[i]), n = widened(p.normals[i]);
      const map::BentPoint axes = map::at(cylinder, there);
      p.positions[i] = narrowed(there - to);
      p.normals[i] = narrowed(unit(Vec3{dot(n, axes.east), dot(n, axes.north) * axes.along_north, dot(n, axes.up)}));
    }
  for (InstancedMesh& mesh : tile.instanced)
    for (std::size_t i = 0; i < mesh.translations.size(); ++i) {
      const Vec3 there = in_plane(mesh.translations[i]);
      const Turn turn = turn_of(map::at(cylinder, there));
      mesh.translations[i] = narrowed(there - to);
      mesh.rotations[i] = product({turn.axis * -1, turn.w}, mesh.rotations[i]);
    }
  tile.origin = to;
  tile.cylinder.reset();
  return tile;
}

}  // namespace citykiln::bake
