#include "compiler/map/lanes/transitions.h"

#include <gtest/gtest.h>

#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

constexpr double kLane_m = 3.5;

// A primary road of three ways: 0 to 60 m, the transition up to 90 m, and 90 to 150 m.
std::vector<Track> three_ways(const std::string& before, const std::string& transition, const std::string& after) {
  const std::string road = " highway=primary oneway=yes ";
  return features_of("w1 0:0 0:60" + road + before + "\nw2 0:60 0:90 placement=transition" + road + transition +
                     "\nw3 0:90 0:150" + road + after)
      .tracks;
}

double length_of(const Track& track) { return length_m(track.axis); }

// The distances from the axis to both edges at the first and at the last point.
struct Ends {
  double first_left_m, first_right_m, last_left_m, last_right_m;
};
Ends ends_of(const Track& track) {
  const double left_m = track.section.axis_offset_m, right_m = carriageway_width_m(track.section) - left_m;
  const double drift_m = track.section.axis_drift * length_of(track);
  return {left_m, right_m, left_m + drift_m, right_m - drift_m};
}

TEST(Transitions, LanesAddedOnTheRightLeaveTheLeftEdgeStraight) {
  for (const char* lanes : {"lanes=1", "lanes=2"}) {
    const auto ways = three_ways("lanes=1 placement=right_of:1", lanes, "lanes=2 placement=right_of:1");
    ASSERT_EQ(ways.size(), 3u);
    EXPECT_EQ(ways[1].section.axis_offset_m, ways[0].section.axis_offset_m) << lanes;
    EXPECT_EQ(ways[1].section.axis_drift, 0) << lanes;
    EXPECT_EQ(ways[2].section.axis_offset_m, ways[0].section.axis_offset_m) << lanes;
  }
}

TEST(Transitions, LanesAddedOnTheLeftLeaveTheRightEdgeStraight) {
  for (const char* lanes : {"lanes=1", "lanes=2"}) {
    const auto ways = three_ways("lanes=1 placement=left_of:1", lanes, "lanes=2 placement=left_of:2");
    ASSERT_EQ(ways.size(), 3u);
    for (const Track& way : ways) {
      EXPECT_NEAR(ends_of(way).first_right_m, ends_of(ways[0]).first_right_m, 0x1p-10) << lanes;
      EXPECT_EQ(way.section.axis_drift, 0) << lanes;
    }
  }
}

TEST(Transitions, TheAxisGoesOverLinearly) {
  const auto ways = three_ways("lanes=2 placement=right_of:1", "lanes=2", "lanes=2 placement=left_of:1");
  ASSERT_EQ(ways.size(), 3u);
  const Ends ends = ends_of(ways[1]);
  EXPECT_NEAR(ends.first_left_m, kLane_m, 0.01);
  EXPECT_NEAR(ends.last_left_m, 0, 0.01);
  EXPECT_GE(ends.last_left_m, -0x1p-10);
  EXPECT_NEAR(ways[1].section.axis_drift, -kLane_m / 30, 0.001);
  EXPECT_EQ(ways[0].section.axis_drift, 0);
  EXPECT_EQ(ways[2].section.axis_drift, 0);
}

TEST(Transitions, AWayWithoutPlacementHasItsAxisInTheMiddle) {
  const auto ways = three_ways("lanes=2", "lanes=3", "lanes=3 placement=right_of:2");
  ASSERT_EQ(ways.size(), 3u);
  // the left edges meet where it begins, or the right ones: these need no movement
  const Ends ends = ends_of(ways[1]);
  EXPECT_NEAR(ends.first_right_m, kLane_m, 0.01);
  EXPECT_NEAR(ends.last_left_m, 2 * kLane_m, 0.01);
  EXPECT_EQ(ways[1].section.axis_drift, 0);
}

TEST(Transitions, OfWaysDrawnTheOtherWayAreTheSame) {
  const std::string road = " highway=primary lanes=3 oneway=";
  const auto ways = features_of("w1 0:60 0:0 placement=right_of:1" + road + "-1\nw2 0:60 0:90 placement=transition" +
                                road + "yes\nw3 0:90 0:150 placement=left_of:1" + road + "yes")
                        .tracks;
  ASSERT_EQ(ways.size(), 3u);
  const Ends ends = ends_of(ways[1]), before = ends_of(ways[0]);
  EXPECT_NEAR(ends.first_left_m, before.first_right_m, 0.01);
  EXPECT_NEAR(ends.first_right_m, before.first_left_m, 0.01);
  EXPECT_NEAR(ends.last_left_m, 0, 0.01);
}

TEST(Transitions, WithOneNeighbourHaveItsPlacement) {
  const std::string road = " highway=primary oneway=yes lanes=3 ";
  const auto ways =
      features_of("w1 0:0 0:60 placement=left_of:1" + road + "\nw2 0:60 0:90 placement=transition" + road).tracks;
  ASSERT_EQ(ways.size(), 2u);
  EXPECT_EQ(ways[1].section.axis_offset_m, 0);
  EXPECT_EQ(ways[1].section.axis_drift, 0);
}

TEST(Transitions, WithoutNeighboursAreInTheMiddle) {
  const auto ways = features_of("w2 0:60 0:90 placement=transition highway=primary oneway=yes lanes=3").tracks;
  ASSERT_EQ(ways.size(), 1u);
  EXPECT_EQ(ways[0].section.axis_offset_m, 1.5 * kLane_m);
}

TEST(Transitions, FollowTheWayOfTheirKindAtAFork) {
  const std::string tags = " oneway=yes lanes=2 ";
  const auto ways = features_of("w1 0:0 0:60 placement=right_of:1 highway=primary" + tags +
                                "\nw2 0:60 0:90 placement=transition highway=primary" + tags +
                                "\nw3 0:90 0:150 placement=right_of:1 highway=primary" + tags +
                                "\nw4 0:90 0:151 placement=left_of:1 highway=primary_link" + tags)
                        .tracks;
  ASSERT_EQ(ways.size(), 4u);
  EXPECT_EQ(ways[1].section.axis_drift, 0);
  EXPECT_NEAR(ways[1].section.axis_offset_m, kLane_m, 0.01);
}

TEST(Transitions, OfABridgeAreInTheMeanPlace) {
  const auto ways =
      three_ways("lanes=2 placement=right_of:2", "lanes=2 bridge=yes layer=1", "lanes=2 placement=left_of:1");
  ASSERT_EQ(ways.size(), 3u);
  EXPECT_EQ(ways[1].section.axis_drift, 0);
  EXPECT_EQ(ways[1].section.axis_offset_m, kLane_m);
}

TEST(Transitions, LongerThanTheirReachStayInTheMiddle) {
  const std::string road = " highway=primary oneway=yes lanes=2 ";
  const auto ways =
      features_of("w1 0:0 0:60 placement=left_of:1" + road + "\nw2 0:60 0:600 placement=transition" + road).tracks;
  ASSERT_EQ(ways.size(), 2u);
  EXPECT_EQ(ways[1].section.axis_offset_m, kLane_m);
}

TEST(Transitions, KeepTheAxisInTheCarriageway) {
  for (const char* before : {"lanes=1", "lanes=4 placement=left_of:1", "lanes=3 placement=right_of:3"})
    for (const char* lanes : {"lanes=1", "lanes=2", "lanes=5"})
      for (const char* after : {"lanes=2", "lanes=4 placement=left_of:1", "lanes=3 placement=right_of:3"}) {
        const auto ways = three_ways(before, lanes, after);
        ASSERT_EQ(ways.size(), 3u);
        const Ends ends = ends_of(ways[1]);
        for (const double m : {ends.first_left_m, ends.first_right_m, ends.last_left_m, ends.last_right_m})
          EXPECT_GE(m, -0.01) << before << ", " << lanes << ", " << after;
      }
}

}  // namespace
}  // namespace citykiln::map
