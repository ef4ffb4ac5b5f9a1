#include "compiler/bake/ground/ground_uvs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "compiler/materials/texture.h"

namespace citykiln::bake {
namespace {

using materials::kTextureCoordinateStep_m;
using materials::kTexturePeriod_m;
using materials::Material;

ObjectId field(std::int64_t id) { return {{OsmType::kWay, id}, 0}; }

TEST(TextureDirection, RowsOfFieldsRunEachTheirOwnWay) {
  std::set<double> directions;
  for (int id = 0; id < 50; ++id) {
    const Vec2 d = texture_direction(field(id), Material::kFarmland, 1);
    EXPECT_NEAR(length(d), 1, 1e-12);
    directions.insert(d.x);
  }
  EXPECT_EQ(directions.size(), 50u);
  EXPECT_EQ(texture_direction(field(1), Material::kGrass, 1), (Vec2{1, 0}));
}

bool is_whole(double v, double of) { return std::floor(v / of) * of == v; }

// A point on the border of two cells has the same uv from both, of one tile or of two: the same texel, to
// the last bit of single precision.
TEST(GroundUvs, CellsThatMeetShowOnePicture) {
  for (int id = 0; id < 50; ++id)
    for (const double border_m : {-1024.0, 0.0, 128.0, 50048.0}) {
      const Vec2 d = texture_direction(field(id), id % 2 ? Material::kFarmland : Material::kGrass, 1);
      const Vec2 at{border_m, 71.3125 + 13 * id};
      const Vec2 place = uv_on_land(at, d);
      const Vec2 west = place - periods_below_cell(at - Vec2{1, 0}, d),
                 east = place - periods_below_cell(at + Vec2{1, 0}, d);
      for (const double difference : {west.x - east.x, west.y - east.y})
        EXPECT_TRUE(is_whole(difference, kTexturePeriod_m)) << difference;
      for (const double v : {west.x, west.y, east.x, east.y}) EXPECT_EQ(static_cast<double>(static_cast<float>(v)), v);
    }
}

TEST(GroundUvs, OfACellFits16Bits) {
  for (int id = 0; id < 100; ++id) {
    const Vec2 d = texture_direction(field(id), Material::kFarmland, 1);
    const Vec2 corner{-128.0 * id, 640.0 - 128 * id}, inside = corner + Vec2{60, 70};
    for (const double x : {0.0, 57.0, 128.0})
      for (const double y : {0.0, 99.5, 128.0}) {
        const Vec2 place = uv_on_land(corner + Vec2{x, y}, d) - periods_below_cell(inside, d);
        for (const double v : {place.x, place.y}) {
          EXPECT_GE(v, 0);
          EXPECT_LE(v, 65535 * kTextureCoordinateStep_m);
          EXPECT_TRUE(is_whole(v, kTextureCoordinateStep_m));
        }
      }
  }
}

TEST(GroundUvs, KeepsDistances) {
  const Vec2 d = texture_direction(field(3), Material::kFarmland, 1);
  const Vec2 a{10, 20}, b{47, -3};
  EXPECT_NEAR(distance(uv_on_land(a, d), uv_on_land(b, d)), distance(a, b), 2 * kTextureCoordinateStep_m);
}

TEST(GroundUvs, OnAWallRunsAlongItAndUp) {
  EXPECT_EQ(uv_on_wall({5, 7, 30}, {0.9, 0.1, 0.2}), (Vec2{7, 30}));
  EXPECT_EQ(uv_on_wall({5, 7, 30}, {0.1, -0.9, 0.2}), (Vec2{5, 30}));
}

TEST(GroundUvs, WholePeriodsAreTakenOffATriangle) {
  const Vec2 off = periods_below({Vec2{130, -1}, Vec2{190, 63}, Vec2{140, 5}});
  EXPECT_EQ(off, (Vec2{128, -64}));
}

}  // namespace
}  // namespace citykiln::bake
