#include "compiler/bake/far/bend.h"

#include <gtest/gtest.h>

#include <GeographicLib/LocalCartesian.hpp>
#include <algorithm>
#include <cmath>
#include <set>

#include "compiler/bake/far/split_edges.h"
#include "compiler/geometry/snap.h"

namespace citykiln::bake {
namespace {

const LonLat kOrigin{1.52, 42.5};

/// A quadrilateral of two triangles with heights, in a tile.
Primitive quad(float x0, float x1, float y0, float y1, Layer layer = Layer::kGround) {
  Primitive p;
  p.layer = layer;
  p.positions = {{x0, y0, 3}, {x1, y0, 5}, {x1, y1, 8}, {x0, y1, 2}};
  p.normals.assign(4, {0, 0, 1});
  p.colours.assign(4, materials::kNoTint);
  p.features.assign(4, 0);
  p.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  p.triangles = {{0, 1, 2}, {0, 2, 3}};
  return p;
}

BakedTile tile_with(Vec3 origin, std::vector<Primitive> primitives, double tolerance_m = 0.5) {
  BakedTile tile;
  tile.origin = origin, tile.tolerance_m = tolerance_m, tile.error_m = 0.4;
  tile.features = {OsmId{}};
  tile.primitives = std::move(primitives);
  return tile;
}

/// By GeographicLib: a place of the plane at a height above the ellipsoid, in the frame of the run.
Vec3 expected_at(Vec3 p) {
  const LonLat place = map::Plane(kOrigin).backward(in_plan(p));
  Vec3 at;
  GeographicLib::LocalCartesian(kOrigin.lat_deg, kOrigin.lon_deg, 0)
      .Forward(place.lat_deg, place.lon_deg, p.z, at.x, at.y, at.z);
  return at;
}

std::set<Vec3> corners_of(const BakedTile& tile) {
  std::set<Vec3> corners;
  for (const Primitive& p : tile.primitives)
    for (const Float3& at : p.positions) corners.insert(tile.origin + widened(at));
  return corners;
}

TEST(Bend, VerticesAreWithinACentimetreOfGeographicLibWithTheGeoidsHeight) {
  const map::Geoid geoid{.low = {}, .heights_m = {51.25}};
  for (const Vec3 origin : {Vec3{0, 0, 1000}, Vec3{-21504, 15360, 2400}, Vec3{9216, -30720, 40}}) {
    const BakedTile tile = tile_with(origin, {quad(10, 300, 20, 250), quad(400, 480, 8, 90, Layer::kBuildings)});
    const BakedTile bent_tile = bent(tile, map::Globe(kOrigin), geoid);
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t v = 0; v < 4; ++v) {
        const Vec3 there = expected_at(origin + widened(tile.primitives[i].positions[v]) + Vec3{0, 0, 51.25});
        EXPECT_LT(length(bent_tile.origin + widened(bent_tile.primitives[i].positions[v]) - there), 0.002);
      }
  }
}

TEST(Bend, TheGeoidIsLinearBetweenItsPoints) {
  const map::Geoid geoid{.low = {0, 0}, .step_m = 1000, .columns = 2, .heights_m = {10, 20, 30, 60}};
  EXPECT_EQ(map::height_m(geoid, {500, 0}), 15);
  EXPECT_EQ(map::height_m(geoid, {500, 500}), 30);
  EXPECT_EQ(map::height_m(geoid, {-7, 2000}), 30);
  const BakedTile out = bent(tile_with({0, 0, 0}, {quad(0, 1000, 0, 1000)}, 12.5), map::Globe(kOrigin), geoid);
  // the diagonal is 40 / 2 - 30 = 5 m from the geoid in its middle, which the error states
  EXPECT_GT(out.error_m, 5.4);
}

TEST(Bend, TilesApartMeetOnTheirBorder) {
  const map::Globe globe(kOrigin);
  // 2 km long edges are halved; the tiles have different origins
  const BakedTile west = bent(tile_with({4096, 5120, 700}, {quad(0, 1024, 0, 2048)}, 0.02), globe, {});
  const BakedTile east = bent(tile_with({5120, 5120, 1900}, {}, 0.02), globe, {});
  BakedTile right = tile_with({5120, 5120, 0}, {quad(0, 512, 0, 2048)}, 0.02);
  right.primitives[0].positions = {{0, 0, 705}, {512, 0, 10}, {512, 2048, 20}, {0, 2048, 708}};
  const BakedTile bent_right = bent(right, globe, {});
  std::set<Vec3> common;
  const std::set<Vec3> a = corners_of(west), b = corners_of(bent_right);
  std::ranges::set_intersection(a, b, std::inserter(common, common.end()));
  EXPECT_GE(common.size(), 17u);  // 2 km in edges of less than 130 m
  EXPECT_TRUE(corners_of(east).empty());
}

TEST(Bend, LongEdgesAreHalvedUntilTheirSagIsAShareOfTheTolerance) {
  for (const double tolerance_m : {0.02, 0.1, 2.5}) {
    BakedTile tile = tile_with({0, 0, 0}, {quad(0, 1000, 0, 900)}, tolerance_m);
    const BakedTile out = bent(tile, map::Globe(kOrigin), {});
    const Primitive& p = out.primitives[0];
    EXPECT_EQ(p.triangles.size() > 2, tolerance_m < 1);
    double area_m2 = 0;
    for (const auto& t : p.triangles) {
      const Vec3 a = widened(p.positions[t[0]]), b = widened(p.positions[t[1]]), c = widened(p.positions[t[2]]);
      for (const double side_m : {length(b - a), length(c - b), length(a - c)})
        EXPECT_LE(map::sag_m(side_m), kSagShare * tolerance_m * 1.001);
      EXPECT_GT(cross(b - a, c - a).z, 0);
      area_m2 += cross(in_plan(b - a), in_plan(c - a)) / 2;
    }
    EXPECT_NEAR(area_m2, 900000, 30);
    EXPECT_GE(out.error_m, tile.error_m + kSagShare * tolerance_m);
    EXPECT_EQ(p.uvs.size(), p.positions.size());
    EXPECT_EQ(p.features.size(), p.positions.size());
  }
}

TEST(Bend, InstancesStandUprightAtTheirPlace) {
  BakedTile tile = tile_with({-40960, 51200, 300}, {});
  InstancedMesh& trees = tile.instanced.emplace_back();
  trees.primitives = {quad(-1, 1, -1, 1, Layer::kPlants)};
  trees.translations = {{12, 7, 3}}, trees.rotations = {{0, 0, 0.6f, 0.8f}}, trees.scales = {8}, trees.features = {0};
  const map::Globe globe(kOrigin);
  const BakedTile out = bent(tile, globe, {});
  const InstancedMesh& there = out.instanced[0];
  const auto turned = [](const Float4& q, Vec3 v) {
    const Vec3 u{q[0], q[1], q[2]}, t = cross(u, v) * 2;
    return v + t * q[3] + cross(u, t);
  };
  const Vec3 foot = tile.origin + widened(trees.translations[0]);
  for (const Vec3 part : {Vec3{0, 0, 20}, Vec3{6, 0, 3}, Vec3{-2, 5, 9}}) {
    const Vec3 found = out.origin + widened(there.translations[0]) + turned(there.rotations[0], part);
    EXPECT_LT(length(found - expected_at(foot + turned(trees.rotations[0], part))), 0.005);
  }
}

// ---- inside of a cylinder ----

const map::Cylinder kDrum{400};

/// The distance between points of a bent tile's triangles and the image of the plane through the given quad's corners.
double farthest_m(const Primitive& bent_mesh, Vec3 to, double z_m) {
  double farthest = 0;
  for (const auto& t : bent_mesh.triangles)
    for (int i = 0; i <= 8; ++i)
      for (int j = 0; i + j <= 8; ++j) {
        const Vec3 p = to + (widened(bent_mesh.positions[t[0]]) * i + widened(bent_mesh.positions[t[1]]) * j +
                             widened(bent_mesh.positions[t[2]]) * (8 - i - j)) *
                                0.125;
        farthest = std::max(farthest, std::abs(map::flattened(kDrum, p).z - z_m));
      }
  return farthest;
}

TEST(BendIntoCylinder, LongEdgesStayWithinTheToleranceOfTheBentSurface) {
  for (const double tolerance_m : {0.1, 0.5, 2.5}) {
    BakedTile tile = tile_with({0, -512, 0}, {quad(0, 900, 0, 1024)}, tolerance_m);
    for (Float3& at : tile.primitives[0].positions) at[2] = 12;
    const BakedTile out = bent(tile, kDrum);
    const double off_m = farthest_m(out.primitives[0], out.origin, 12);
    EXPECT_LE(off_m, kCylinderSagShare * tolerance_m + kQuantum_m);
    EXPECT_GE(out.error_m, tile.error_m + off_m - kQuantum_m);
    EXPECT_LE(out.error_m, tile.error_m + 2 * kCylinderSagShare * tolerance_m);
    ASSERT_TRUE(out.cylinder.has_value());
    EXPECT_EQ(out.cylinder->radius_m, 400);
    EXPECT_EQ(out.cylinder->middle_y_m, 0);
  }
}

TEST(BendIntoCylinder, EdgesAlongTheAxisAreNotHalved) {
  const BakedTile out = bent(tile_with({0, 0, 0}, {quad(0, 1024, 0, 1)}, 0.1), kDrum);
  EXPECT_EQ(out.primitives[0].positions.size(), 4u);
}

TEST(BendIntoCylinder, NormalsAreThoseOfTheBentSurface) {
  // a slope along y at a height where lengths along y are three quarters
  Primitive slope = quad(0, 10, 0, 10);
  slope.positions = {{0, 0, 100}, {10, 0, 100}, {10, 10, 106}, {0, 10, 106}};
  slope.normals.assign(4, narrowed(unit(Vec3{0, -0.6, 1})));
  const BakedTile out = bent(tile_with({0, 700, 0}, {slope}), kDrum);
  const Primitive& p = out.primitives[0];
  const Vec3 along = unit(widened(p.positions[3]) - widened(p.positions[0]));
  EXPECT_NEAR(dot(widened(p.normals[0]), along), 0, 0.02);  // the chord leaves the tangent by half of 10 / 400
  EXPECT_NEAR(dot(widened(p.normals[3]), along), 0, 0.02);
  EXPECT_NEAR(length(widened(p.normals[0])), 1, 1e-6);
}

TEST(BendIntoCylinder, TilesApartMeetOnTheirBorder) {
  const BakedTile south = bent(tile_with({0, -512, 0}, {quad(0, 512, 0, 512)}, 0.1), kDrum);
  BakedTile north = tile_with({0, 0, 0}, {quad(0, 512, 0, 512)}, 0.1);
  north.primitives[0].positions = {{0, 0, 2}, {512, 0, 8}, {512, 512, 20}, {0, 512, 1}};
  std::set<Vec3> common;
  const std::set<Vec3> a = corners_of(south), b = corners_of(bent(north, kDrum));
  std::ranges::set_intersection(a, b, std::inserter(common, common.end()));
  EXPECT_GE(common.size(), 2u);
  for (const Vec3& corner : a)
    if (std::abs(corner.y) < 1e-9) {
      EXPECT_TRUE(common.contains(corner));
    }
}

TEST(BendIntoCylinder, InstancesStandUprightAllAroundAndTheirRigidityIsBounded) {
  for (const double y : {0.0, 600.0, -628.0, 1256.6, 2000.0}) {
    BakedTile tile = tile_with({0, std::floor(y), 10}, {});
    tile.error_m = 0;
    InstancedMesh& lamps = tile.instanced.emplace_back();
    lamps.primitives = {quad(-1, 1, -1, 1, Layer::kProps)};
    lamps.translations = {{12, 7, 3}}, lamps.rotations = {{0, 0, 0.6f, 0.8f}}, lamps.scales = {2}, lamps.features = {0};
    const BakedTile out = bent(tile, kDrum);
    const Vec3 foot = tile.origin + Vec3{12, 7, 3};
    const auto turned = [](const Float4& q, Vec3 v) {
      const Vec3 u{q[0], q[1], q[2]}, t = cross(u, v) * 2;
      return v + t * q[3] + cross(u, t);
    };
    const Vec3 at = out.origin + widened(out.instanced[0].translations[0]);
    EXPECT_LT(length(at - map::at(kDrum, foot).at), 1e-4);
    EXPECT_LT(length(turned(out.instanced[0].rotations[0], {0, 0, 1}) - map::at(kDrum, foot).up), 1e-6);
    double farthest = 0;
    for (const Float3& p : lamps.primitives[0].positions) {
      const Vec3 part = widened(p) * 2, rigid = at + turned(out.instanced[0].rotations[0], part);
      const Vec3 exact = map::at(kDrum, foot + turned({0, 0, 0.6f, 0.8f}, part)).at;
      farthest = std::max(farthest, length(rigid - exact));
    }
    EXPECT_GT(farthest, 0.02);
    EXPECT_LE(farthest, out.error_m);
  }
}

TEST(BendIntoCylinder, FlattenedTilesAreThoseOfThePlane) {
  BakedTile tile = tile_with({-2048, 1024, 7}, {quad(0, 40, 0, 40), quad(3, 9, 3, 9, Layer::kBuildings)}, 2.5);
  tile.primitives[1].positions[2][2] = 70;
  const BakedTile back = flattened(bent(tile, kDrum));
  EXPECT_FALSE(back.cylinder.has_value());
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t v = 0; v < 4; ++v)
      EXPECT_LT(length(back.origin + widened(back.primitives[i].positions[v]) - tile.origin -
                       widened(tile.primitives[i].positions[v])),
                2 * kQuantum_m);
}

}  // namespace
}  // namespace citykiln::bake
