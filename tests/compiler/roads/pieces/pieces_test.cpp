#include "compiler/roads/pieces/pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "compiler/geometry/polygons/overlay.h"
#include "compiler/geometry/snap.h"
#include "tests/compiler/roads/made_road.h"

namespace citykiln::roads {
namespace {

// The roads are far from the borders of tiles.
constexpr double kHugeTile_m = 0x1p20;
constexpr Vec2 kAway = {1000, 1000};

Polyline away(Polyline axis) {
  for (Vec2& p : axis) p = p + kAway;
  return axis;
}

double covered_m2(const std::vector<Ring>& rings) {
  std::vector<OwnedSegment> segments;
  for (const Ring& ring : rings) add_ring(segments, ring, 0);
  double area = 0;
  const auto owned = overlay(segments, 1);
  for (const Polygon& polygon : owned[0]) {
    area += area_m2(polygon);
  }
  return area;
}

// Bends of at most `most_rad`, segments of at least `least_m`.
Road random_road(std::mt19937_64& dice, double most_rad, double least_m) {
  const auto draw = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(dice() >> 11) * 0x1p-53;
  };
  Polyline axis = {kAway};
  double heading = draw(0, 6);
  for (int i = 0; i < 8; ++i) {
    heading += draw(-most_rad, most_rad);
    axis.push_back(snapped(axis.back() + Vec2{std::cos(heading), std::sin(heading)} * draw(least_m, 60)));
  }
  return made_road(1, axis, 8, map::LandCoverClass::kPrimaryRoad, 2, 3);
}

RoadPieces pieces_of_whole(const Road& road) {
  return pieces_of(road, {}, stretches_of(road, {}, kHugeTile_m), {}, kHugeTile_m, 0.02);
}

TEST(Pieces, CoverWhatTheStripCovers) {
  std::mt19937_64 dice(1);
  for (int i = 0; i < 200; ++i) {
    // all bends and lengths: joints fill the wedges that no mitre fits
    const Road road = random_road(dice, i % 2 == 0 ? 0.6 : 3, i % 4 < 2 ? 20 : 1);
    std::vector<Ring> pieces, strip = stroke_pavements(road);
    for (const Piece& piece : pieces_of_whole(road).pieces) pieces.push_back(piece.ring);
    const double strip_m2 = covered_m2(strip);
    ASSERT_GT(strip_m2, 0);
    const bool is_smooth = i % 2 == 0;
    // outside sharp bends a joint with three corners replaces a disk
    EXPECT_NEAR(covered_m2(pieces), strip_m2, (is_smooth ? 0.002 : 0.1) * strip_m2) << i;
  }
}

TEST(Pieces, LieBesideAnAxisThatDrifts) {
  Road road = made_road(1, away({{0, 0}, {64, 0}, {128, 16}}), 8, map::LandCoverClass::kPrimaryRoad, 2, 3);
  road.section.axis_offset_m = 1, road.section.axis_drift = 1.0 / 32;
  std::vector<Ring> rings, strip = stroke_pavements(road);
  for (const Piece& piece : pieces_of_whole(road).pieces) {
    rings.push_back(piece.ring);
    if (piece.surface != road.surface) continue;
    // u is 0 at the left kerb, wherever that is
    const PieceFrame& frame = piece.frame;
    const Vec2 left = frame.at + left_of(frame.along) * frame.start.left_m;
    EXPECT_NEAR(uv_at(frame, left + frame.along * frame.start.left_along_m).x, 0, 1e-9);
  }
  const double strip_m2 = covered_m2(strip);
  EXPECT_NEAR(covered_m2(rings), strip_m2, 0.002 * strip_m2);
  for (const Ring& ring : rings) strip.push_back(ring);
  EXPECT_NEAR(covered_m2(strip), strip_m2, 0.002 * strip_m2);
}

TEST(Pieces, MeetEdgeToEdgeOnASmoothRoad) {
  std::mt19937_64 dice(2);
  int compared = 0;
  for (int i = 0; i < 100; ++i) {
    const Road road = random_road(dice, 0.5, 20);
    std::vector<Ring> pieces;
    double sum = 0;
    for (const Piece& piece : pieces_of_whole(road).pieces) {
      pieces.push_back(piece.ring);
      sum += signed_area_m2(piece.ring);
    }
    // a road that crosses itself covers some area twice
    if (covered_m2(stroke_pavements(road)) < 0.98 * 13 * length_m(road.axis)) continue;
    EXPECT_NEAR(covered_m2(pieces), sum, 0.02) << i;
    ++compared;
  }
  EXPECT_GT(compared, 50);
}

TEST(Pieces, CarryMetresAcrossAndAlong) {
  const Road road = made_road(1, away({{0, 0}, {100, 0}, {180, 60}}), 8, map::LandCoverClass::kPrimaryRoad);
  const RoadPieces made = pieces_of_whole(road);
  ASSERT_EQ(made.pieces.size(), 2u);
  const PieceFrame &first = made.pieces[0].frame, &second = made.pieces[1].frame;
  EXPECT_EQ(uv_at(first, kAway + Vec2{0, 4}), (Vec2{0, 0}));
  EXPECT_EQ(uv_at(first, kAway + Vec2{0, -4}), (Vec2{8, 0}));
  EXPECT_EQ(uv_at(first, kAway + Vec2{50, 1}).x, 3);
  EXPECT_NEAR(uv_at(first, kAway + Vec2{50, 0}).y, 50, 1e-9);
  // v is constant along the mitre
  const Vec2 mitre = unit(Vec2{1, 0} + unit(Vec2{80, 60}));
  for (const double offset : {-4.0, -1.0, 2.0, 4.0}) {
    const Vec2 p = kAway + Vec2{100, 0} + left_of(mitre) * (offset / dot(mitre, Vec2{1, 0}));
    EXPECT_NEAR(uv_at(first, p).y, 100, 1e-9);
    EXPECT_NEAR(distance(uv_at(first, p), uv_at(second, p)), 0, 1e-9);
    EXPECT_NEAR(uv_at(first, p).x, 4 - offset, 1e-9);
  }
}

TEST(Pieces, ShareUvAtCommonCorners) {
  std::mt19937_64 dice(3);
  int compared = 0;
  for (int i = 0; i < 50; ++i) {
    const Road road = random_road(dice, 0.7, 15);
    const std::vector<Piece> pieces = pieces_of_whole(road).pieces;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      for (std::size_t q = p + 1; q < pieces.size(); ++q) {
        if (pieces[p].run != pieces[q].run) continue;
        for (const Vec2 corner : pieces[p].ring) {
          if (std::ranges::find(pieces[q].ring, corner) == pieces[q].ring.end()) continue;
          EXPECT_LT(distance(uv_at(pieces[p].frame, corner), uv_at(pieces[q].frame, corner)), 0.01);
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 0);
}

TEST(Pieces, OfARunAreThoseOfTheWholeRoad) {
  const Road whole =
      made_road(1, away({{0, 0}, {50, 0}, {100, 10}, {150, 0}, {200, 20}}), 8, map::LandCoverClass::kPrimaryRoad);
  Road part = whole;
  part.axis = away({{50, 0}, {100, 10}, {150, 0}, {200, 20}}), part.start_along_m = 50;
  const auto all = pieces_of_whole(whole).pieces, some = pieces_of_whole(part).pieces;
  // except the ends, where it is cut
  ASSERT_GT(some.size(), 2u);
  ASSERT_GT(all.size(), some.size());
  for (std::size_t i = 1; i + 1 < some.size(); ++i) {
    EXPECT_EQ(some[i].ring, all[i + 1].ring);
    EXPECT_EQ(some[i].frame.start.v_m, all[i + 1].frame.start.v_m);
  }
}

TEST(Pieces, GiveWayWhereTheRoadDoes) {
  Road road = made_road(1, away({{0, 0}, {100, 0}, {180, 60}}), 8, map::LandCoverClass::kPrimaryRoad, 2, 3);
  const double whole_m2 = covered_m2(stroke_pavements(road));
  road.width_limits.left = {{40, 3, false}};
  std::vector<Ring> pieces;
  for (const Piece& piece : pieces_of_whole(road).pieces) {
    pieces.push_back(piece.ring);
    // u covers the strip from edge to edge at every width
    const Vec2 left = kAway + Vec2{40, 0} + Vec2{0, piece.frame.start.left_m};
    if (piece.frame.start.v_m != 40) continue;
    EXPECT_NEAR(uv_at(piece.frame, left).x, 0, 1e-9);
  }
  EXPECT_LT(covered_m2(pieces), whole_m2 - 10);
  EXPECT_NEAR(covered_m2(pieces), covered_m2(stroke_pavements(road)), 0.2);
}

TEST(Pieces, VergesArePavedWhereACrossingLeadsToThem) {
  Road road = made_road(1, away({{0, 0}, {50, 0}, {100, 0}}), 8, map::LandCoverClass::kPrimaryRoad, 2, 2);
  road.section.lanes.insert(road.section.lanes.begin() + 1,
                            {map::LaneKind::kVerge, map::LaneDirection::kBoth, 1.5, 0, true});
  const auto verges_at = [&](double x) {
    std::size_t count = 0;
    for (const Piece& piece : pieces_of_whole(road).pieces) {
      const Box2 box = box_of(piece.ring);
      count += piece.surface == map::LandCoverClass::kVerge && box.min.x < kAway.x + x && kAway.x + x < box.max.x;
    }
    return count;
  };
  EXPECT_EQ(verges_at(49.5), 1u);
  road.points = {{1, map::TrackPointKind::kZebra, 0}};
  EXPECT_EQ(verges_at(49.5), 0u);
  EXPECT_EQ(verges_at(20), 1u);
}

TEST(Pieces, MarkedStripsHaveAPattern) {
  Road road = made_road(1, away({{0, 0}, {100, 0}}), 3.5, map::LandCoverClass::kPrimaryRoad, 2, 2);
  road.section.lanes.insert(road.section.lanes.begin() + 1, road.section.lanes[1]);
  road.section.axis_offset_m = 3.5;
  road.section.lanes[1].way = map::LaneDirection::kBackward, road.section.lanes[2].way = map::LaneDirection::kForward;
  const RoadPieces made = pieces_of_whole(road);
  ASSERT_EQ(made.layouts.size(), 1u);
  for (const Piece& piece : made.pieces)
    EXPECT_EQ(piece.layout == 0, piece.surface == map::LandCoverClass::kPrimaryRoad);
}

}  // namespace
}  // namespace citykiln::roads
