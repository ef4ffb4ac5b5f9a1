#include "compiler/ground/road_field.h"

#include <gtest/gtest.h>

#include "compiler/contract/draw.h"

namespace citykiln::ground {
namespace {

roads::Road random_road(const Draw& draw, std::uint32_t r) {
  roads::Road road;
  road.id = {{OsmType::kWay, static_cast<std::int64_t>(r) + 1}, 0};
  road.surface = map::SurfaceClass::kResidentialRoad;
  road.section = {{{map::LaneKind::kDriving, map::LaneWay::kBoth, draw.between(2, 12, 64 * r)}}, 1};
  for (std::uint32_t i = 0; i < 4; ++i)
    road.axis.push_back({draw.between(-200, 200, 64 * r + 2 * i + 1), draw.between(-200, 200, 64 * r + 2 * i + 2)});
  road.profile = {{0, draw.between(0, 20, 64 * r + 20), 0}, {200, 10, 0.0625}};
  return road;
}

// Straight from the definition: every segment is asked.
std::size_t segments_within(const RoadField& field, Vec2 p) {
  return static_cast<std::size_t>(std::ranges::count_if(field.segments, [&](const GradedSegment& s) {
    const Vec2 along = s.to - s.from;
    const double t = std::clamp(dot(p - s.from, along) / dot(along, along), 0.0, 1.0);
    const double half_m = cross(along, p - s.from) >= 0 ? s.left_m : s.right_m;
    return distance(p, s.from + along * t) - half_m < kCarve_m;
  }));
}

TEST(RoadField, StrandsAreAllThatAreNear) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Draw draw(seed, StableId{33}, "roads");
    std::vector<roads::Road> roads;
    for (std::uint32_t r = 0; r < seed; ++r) roads.push_back(random_road(draw, r));
    const RoadField field = field_of(roads, false);
    for (std::uint32_t i = 0; i < 4000; ++i) {
      const Vec2 p{draw.between(-240, 240, 100000 + 2 * i), draw.between(-240, 240, 100001 + 2 * i)};
      EXPECT_EQ(strands_at(field, p, 0, std::pmr::get_default_resource()).size(), segments_within(field, p));
    }
  }
}

}  // namespace
}  // namespace citykiln::ground
