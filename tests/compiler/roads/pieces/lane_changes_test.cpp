#include "compiler/roads/pieces/lane_changes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/geometry/polygons/overlay.h"
#include "compiler/roads/pieces/pieces.h"
#include "tests/compiler/roads/made_road.h"

namespace citykiln::roads {
namespace {

using map::Lane;
using map::LaneDirection;
using map::LaneKind;

constexpr double kLaneChangeWidth_m = 3.5, kFarTile_m = 0x1p20;
constexpr Vec2 kNode = {1100, 1000};

// A road with a lane for each letter: ^ forward, v backward, < forward for turning left.
Road lanes_road(std::int64_t id, Polyline axis, const std::string& lanes, double axis_offset_m) {
  Road road = made_road(id, std::move(axis), 1, map::LandCoverClass::kPrimaryRoad);
  road.section.lanes.clear();
  for (const char c : lanes)
    road.section.lanes.push_back({LaneKind::kDriving, c == 'v' ? LaneDirection::kBackward : LaneDirection::kForward,
                                  kLaneChangeWidth_m,
                                  c == '<' ? static_cast<std::uint16_t>(map::kTurnLeft) : std::uint16_t{0}});
  road.section.axis_offset_m = axis_offset_m;
  return road;
}

// Two roads that meet at kNode, the first from the west and the second towards the east.
std::vector<Road> meeting_lanes(const std::string& west, double west_offset_m, const std::string& east,
                                double east_offset_m) {
  return {lanes_road(1, {kNode - Vec2{100, 0}, kNode}, west, west_offset_m),
          lanes_road(2, {kNode, kNode + Vec2{100, 0}}, east, east_offset_m)};
}

std::vector<Road> in_middle(const std::string& west, const std::string& east) {
  const auto half_m = [](const std::string& lanes) {
    return static_cast<double>(lanes.size()) * kLaneChangeWidth_m / 2;
  };
  return meeting_lanes(west, half_m(west), east, half_m(east));
}

std::vector<std::vector<LaneChange>> changes_of(const std::vector<Road>& roads) {
  Report report;
  return lane_changes_of(roads, plan_junctions(roads, report));
}

std::vector<double> at_node(const std::vector<std::vector<LaneChange>>& changes, std::size_t road) {
  EXPECT_EQ(changes[road].size(), 1u);
  return changes[road].empty() ? std::vector<double>{} : changes[road][0].offsets_m;
}

bool holds(const std::vector<double>& edges_m, double edge_m) {
  return std::ranges::any_of(edges_m, [&](double m) { return std::abs(m - edge_m) < 1e-9; });
}

TEST(LaneChanges, LinesOfLanesThatGoOnMeetAtTheNode) {
  const struct {
    const char *west, *east;
  } cases[] = {{"^^", "^^^"}, {"^^^", "^^"}, {"v^", "v^^"}, {"vv^", "vv^^^"}, {"^^", "^^^^"}, {"vv^^", "v^"}};
  for (const auto& c : cases) {
    const auto changes = changes_of(in_middle(c.west, c.east));
    const bool is_west_less = std::string(c.west).size() < std::string(c.east).size();
    const std::vector<double> few = at_node(changes, is_west_less ? 0 : 1),
                              many = at_node(changes, is_west_less ? 1 : 0);
    ASSERT_FALSE(few.empty() || many.empty());
    for (const double edge_m : few) EXPECT_TRUE(holds(many, edge_m)) << c.west << " " << c.east << " " << edge_m;
    EXPECT_EQ(few.front(), many.front());
    EXPECT_EQ(few.back(), many.back());
    EXPECT_TRUE(std::ranges::is_sorted(few, std::greater()));
  }
}

TEST(LaneChanges, ALaneAddedOnTheRightMovesNoLine) {
  const double lane = kLaneChangeWidth_m;
  const auto changes = changes_of(meeting_lanes("^^", lane, "^^^", lane));
  EXPECT_EQ(at_node(changes, 0), (std::vector<double>{lane, 0, -2 * lane}));
  EXPECT_EQ(at_node(changes, 1), (std::vector<double>{lane, 0, -lane, -2 * lane}));
}

TEST(LaneChanges, ALaneAddedOnTheLeftMovesNoLine) {
  const double lane = kLaneChangeWidth_m;
  const auto changes = changes_of(meeting_lanes("^^", lane, "^^^", 2 * lane));
  EXPECT_EQ(at_node(changes, 0), (std::vector<double>{2 * lane, 0, -lane}));
}

TEST(LaneChanges, TheLineBetweenDirectionsGoesOnAsOne) {
  const double lane = kLaneChangeWidth_m;
  // a lane for turning left is added in the middle; the axis is left of the lane ahead
  const auto changes = changes_of(meeting_lanes("v^", lane, "v<^", 2 * lane));
  EXPECT_EQ(at_node(changes, 0), (std::vector<double>{2 * lane, lane, -lane}));
}

TEST(LaneChanges, OfWaysDrawnTheOtherWayAreTheSame) {
  const double lane = kLaneChangeWidth_m;
  std::vector<Road> roads = meeting_lanes("^^", lane, "^^^", lane);
  std::ranges::reverse(roads[1].axis);
  for (Lane& l : roads[1].section.lanes) l.way = LaneDirection::kBackward;
  roads[1].section.axis_offset_m = 2 * lane;
  const auto changes = changes_of(roads);
  EXPECT_EQ(at_node(changes, 0), (std::vector<double>{lane, 0, -2 * lane}));
  EXPECT_EQ(at_node(changes, 1), (std::vector<double>{2 * lane, lane, 0, -lane}));
}

TEST(LaneChanges, AreOnlyWhereOneStreetGoesOn) {
  std::vector<Road> roads = in_middle("^^", "^^^");
  roads.push_back(lanes_road(3, {kNode, kNode + Vec2{0, 80}}, "v^", kLaneChangeWidth_m));
  for (const auto& changes : changes_of(roads)) EXPECT_TRUE(changes.empty());
  for (const auto& changes : changes_of(in_middle("^^", "^^"))) EXPECT_TRUE(changes.empty());
}

TEST(LaneChanges, EndAtTheCuts) {
  const auto changes = changes_of(in_middle("^^", "^^^"));
  const LaneChange& change = changes[0][0];
  EXPECT_EQ(change.node_m, 100);
  EXPECT_LT(change.cut_m, 95);
  EXPECT_EQ(change.share_at(change.node_m), 1);
  EXPECT_EQ(change.share_at(change.cut_m), 0);
  EXPECT_EQ(change.share_at(0), 0);
}

std::vector<RoadPieces> pieces_of_all(const std::vector<Road>& roads) {
  Report report;
  const auto junctions = plan_junctions(roads, report);
  const auto changes = lane_changes_of(roads, junctions);
  const auto intervals = junction_intervals_of(roads, junctions);
  const auto ends = ends_of(roads);
  std::vector<RoadPieces> all;
  for (std::size_t r = 0; r < roads.size(); ++r)
    all.push_back(
        pieces_of(roads[r], ends[r], stretches_of(roads[r], intervals[r], kFarTile_m), changes[r], kFarTile_m, 0.02));
  return all;
}

double overlaid_m2(const std::vector<Ring>& rings) {
  std::vector<OwnedSegment> segments;
  for (const Ring& ring : rings) add_ring(segments, ring, 0);
  double area = 0;
  const auto layers = overlay(segments, 1);
  for (const Polygon& polygon : layers[0]) area += area_m2(polygon);
  return area;
}

TEST(LaneChangePieces, CoverTheTaperWithoutOverlaps) {
  for (const auto& roads : {in_middle("^^", "^^^"), in_middle("v^", "vv^^"), in_middle("^^^", "^")}) {
    Report report;
    const auto junctions = plan_junctions(roads, report);
    ASSERT_EQ(junctions.size(), 1u);
    std::vector<Ring> rings;
    double sum = 0;
    for (const RoadPieces& made : pieces_of_all(roads))
      for (const Piece& piece : made.pieces) rings.push_back(piece.ring), sum += signed_area_m2(piece.ring);
    const double pieces_m2 = overlaid_m2(rings);
    EXPECT_NEAR(pieces_m2, sum, 0.05);
    for (const Ring& ring : stroke(junctions[0], roads, arms_of(junctions, roads)[0])) rings.push_back(ring);
    EXPECT_NEAR(overlaid_m2(rings), pieces_m2, 0.1);
  }
}

// Where u of the line between the first two lanes lies: the offset of the nearest place to the north of the axis.
double offset_of_u(const RoadPieces& made, double x, double u_m) {
  double best = 1e9, offset = 0;
  for (const Piece& piece : made.pieces) {
    const double from = piece.frame.at.x + piece.frame.start.left_along_m,
                 to = piece.frame.at.x + piece.frame.end.left_along_m;
    if (x < from || x > to) continue;
    const double passed = (x - from) / (to - from);
    const double left = piece.frame.start.left_m + (piece.frame.end.left_m - piece.frame.start.left_m) * passed,
                 right = piece.frame.start.right_m + (piece.frame.end.right_m - piece.frame.start.right_m) * passed;
    for (double y = right; y <= left; y += 1.0 / 64) {
      const double off = std::abs(uv_at(piece.frame, {x, kNode.y + y}).x - u_m);
      if (off < best) best = off, offset = y;
    }
  }
  return offset;
}

TEST(LaneChangePieces, LinesGoOnThroughTheTaper) {
  const double lane = kLaneChangeWidth_m;
  const auto straight = pieces_of_all(meeting_lanes("^^", lane, "^^^", lane));
  for (const double x : {5.0, 80.0, 92.0, 97.0, 99.5})
    EXPECT_NEAR(offset_of_u(straight[0], kNode.x - 100 + x, lane), 0, 0.05) << x;
  for (const double x : {0.2, 0.5, 3.0, 60.0}) EXPECT_NEAR(offset_of_u(straight[1], kNode.x + x, lane), 0, 0.05) << x;
  // in the middle of both roads, the line leads from 0 to that of the wider one, without a jump
  const auto led = pieces_of_all(in_middle("^^", "^^^"));
  EXPECT_NEAR(offset_of_u(led[0], kNode.x - 30, lane), 0, 0.05);
  EXPECT_NEAR(offset_of_u(led[0], kNode.x - 0.01, lane), lane / 2, 0.05);
  EXPECT_NEAR(offset_of_u(led[1], kNode.x + 0.01, lane), lane / 2, 0.05);
}

TEST(LaneChangePieces, MarginsOfALaneThatWidensKeepTheirWidth) {
  const double lane = kLaneChangeWidth_m;
  const auto made = pieces_of_all(meeting_lanes("^^", lane, "^^^", lane));
  const double kerb = offset_of_u(made[0], kNode.x - 0.01, 2 * lane),
               inside = offset_of_u(made[0], kNode.x - 0.01, 2 * lane - 0.25);
  EXPECT_NEAR(kerb, -2 * lane, 0.05);
  EXPECT_NEAR(inside, -2 * lane + 0.25, 0.05);
}

}  // namespace
}  // namespace citykiln::roads
