#include "compiler/ground/grading/road_influence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compiler/contract/random_sequence.h"

namespace citykiln::ground {
namespace {

roads::Road random_road(const RandomSequence& draw, std::uint32_t r) {
  roads::Road road;
  road.id = {{OsmType::kWay, static_cast<std::int64_t>(r) + 1}, 0};
  road.surface = map::LandCoverClass::kResidentialRoad;
  road.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, draw.between(2, 12, 64 * r)}}, 1};
  for (std::uint32_t i = 0; i < 4; ++i)
    road.axis.push_back({draw.between(-200, 200, 64 * r + 2 * i + 1), draw.between(-200, 200, 64 * r + 2 * i + 2)});
  road.profile = {{0, draw.between(0, 20, 64 * r + 20), 0}, {200, 10, 0.0625}};
  return road;
}

// By definition: looks at every segment.
std::size_t segments_within(const RoadInfluenceIndex& field, Vec2 p) {
  return static_cast<std::size_t>(std::ranges::count_if(field.segments, [&](const GradedSegment& s) {
    const Vec2 along = s.to - s.from;
    const double t = std::clamp(dot(p - s.from, along) / dot(along, along), 0.0, 1.0);
    const double half_m = cross(along, p - s.from) >= 0 ? s.left_m : s.right_m;
    return distance(p, s.from + along * t) - half_m < kGrading_m;
  }));
}

TEST(RoadInfluenceIndex, FindsEverySegmentThatIsNear) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const RandomSequence draw(seed, StableId{33}, "roads");
    std::vector<roads::Road> roads;
    for (std::uint32_t r = 0; r < seed; ++r) roads.push_back(random_road(draw, r));
    const RoadInfluenceIndex field = index_road_influence(roads, false);
    std::size_t found = 0;
    for (std::uint32_t i = 0; i < 4000; ++i) {
      const Vec2 p{draw.between(-240, 240, 100000 + 2 * i), draw.between(-240, 240, 100001 + 2 * i)};
      const auto influences = road_influences_at(field, p, 0, std::pmr::get_default_resource());
      EXPECT_EQ(influences.size(), segments_within(field, p));
      found += influences.size();
    }
    EXPECT_EQ(found > 0, seed > 0);
  }
}

TEST(RoadInfluenceIndex, ARoadsInfluenceDoesNotDependOnOthers) {
  const auto memory = std::pmr::get_default_resource();
  const RandomSequence draw(1, StableId{34}, "crowd");
  std::vector<roads::Road> roads;
  for (std::uint32_t r = 0; r < 100; ++r) roads.push_back(random_road(draw, r));
  const RoadInfluenceIndex field = index_road_influence(roads, true);
  std::size_t most = 0;
  for (std::uint32_t i = 0; i < 150; ++i) {
    const Vec2 p{draw.between(-100, 100, 100000 + 2 * i), draw.between(-100, 100, 100001 + 2 * i)};
    std::vector<RoadInfluence> alone;
    for (const roads::Road& road : roads)
      for (const RoadInfluence& influence :
           road_influences_at(index_road_influence(std::span(&road, 1), true), p, 7, memory))
        alone.push_back(influence);
    const auto together = road_influences_at(field, p, 7, memory);
    ASSERT_EQ(together.size(), alone.size());
    most = std::max(most, alone.size());
    for (std::size_t k = 0; k < alone.size(); ++k) EXPECT_EQ(together[k], alone[k]);
  }
  EXPECT_GT(most, 40u);
}

// Two straight streets beside each other, 8 m wide each; the left one's axis is x = 0.
struct Terrace {
  double gap_m, rise_m;
  RoadInfluenceIndex field;

  Terrace(double gap, double rise) : gap_m(gap), rise_m(rise) {
    std::vector<roads::Road> roads(2);
    for (std::uint32_t r = 0; r < 2; ++r) {
      const double x = r * (8 + gap_m), z_m = r == 0 ? rise_m : 0;
      roads[r].id = {{OsmType::kWay, r + 1}, 0};
      roads[r].surface = map::LandCoverClass::kResidentialRoad;
      roads[r].section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 8}}, 4};
      roads[r].axis = {{x, -100}, {x, 100}};
      roads[r].profile = {{0, z_m, 0}, {200, z_m, 0}};
    }
    field = index_road_influence(roads, false);
  }

  double height_m(double x) const {
    const auto influences = road_influences_at(field, {x, 0}, 0, std::pmr::get_default_resource());
    return blend(influences).z_m;
  }
};

TEST(RoadInfluenceIndex, HigherRoadsKeepTheirHeightToTheEdge) {
  for (const double gap_m : {0.0, 0.25, 1.0})
    for (const double rise_m : {1.5, 4.0, 9.0}) {
      const Terrace terrace(gap_m, rise_m);
      for (double x = -4; x <= 4; x += 0.125) EXPECT_NEAR(terrace.height_m(x), rise_m, 0.1) << x;
      for (double x = 4 + kWallFoot_m + gap_m; x <= 12 + gap_m; x += 0.125)
        EXPECT_NEAR(terrace.height_m(x), 0, 0.1) << x;
    }
}

TEST(RoadInfluenceIndex, RoadsOfAboutOneHeightAreBlended) {
  const Terrace terrace(0, 0.0625);
  EXPECT_NEAR(terrace.height_m(4), 0.03125, 1e-9);
  EXPECT_GT(terrace.height_m(4.5), 0.01);
}

TEST(RoadInfluenceIndex, HeightsAreContinuous) {
  for (const double rise_m : {0.125, 0.25, 0.5, 1.0, 8.0}) {
    const Terrace terrace(0.25, rise_m);
    for (double x = -6; x < 16; x += 0x1p-10)
      EXPECT_LE(std::abs(terrace.height_m(x + 0x1p-10) - terrace.height_m(x)), 0.01 * rise_m) << x;
  }
}

}  // namespace
}  // namespace citykiln::ground
