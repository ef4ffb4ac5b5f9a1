#include "compiler/structures/span_ends.h"

#include <gtest/gtest.h>

namespace citykiln::structures {
namespace {

using map::Passage;

map::Track track_with_nodes(std::int64_t id, Passage passage, Polyline axis, std::vector<std::int64_t> nodes) {
  map::Track t;
  t.id = {{OsmType::kWay, id}, 0};
  t.axis = std::move(axis), t.node_ids = std::move(nodes);
  t.surface = map::LandCoverClass::kResidentialRoad;
  t.section = {{{map::LaneKind::kDriving, map::LaneDirection::kBoth, 6}}, 3};
  t.passage = passage;
  return t;
}

map::Features with(std::vector<map::Track> tracks) {
  map::Features f;
  f.tracks = std::move(tracks);
  return f;
}

const map::Track kBridge = track_with_nodes(1, Passage::kBridge, {{0, 0}, {30, 0}}, {1, 2});

TEST(SpanEnds, AreSquareToTheRoadThatContinues) {
  const auto ends = find_ends(with({kBridge, track_with_nodes(2, Passage::kGround, {{30, 0}, {60, 10}}, {2, 3})}));
  EXPECT_EQ(ends[0].to, (SpanEnd{EndKind::kGround, {60, 10}, 0}));
  EXPECT_EQ(ends[0].from.kind, EndKind::kFree);
}

TEST(SpanEnds, AreCutAtTheEdgeOfARoadThatPasses) {
  const auto ends =
      find_ends(with({kBridge, track_with_nodes(2, Passage::kGround, {{30, -20}, {30, 0}, {30, 20}}, {3, 2, 4})}));
  EXPECT_EQ(ends[0].to, (SpanEnd{EndKind::kBesideRoad, {}, 3}));
}

TEST(SpanEnds, JoinTheOneSpanThatContinues) {
  const auto ends = find_ends(with({kBridge, track_with_nodes(2, Passage::kBridge, {{60, 10}, {30, 0}}, {3, 2})}));
  EXPECT_EQ(ends[0].to, (SpanEnd{EndKind::kJoint, {60, 10}, 0}));
  EXPECT_EQ(ends[1].to, (SpanEnd{EndKind::kJoint, {0, 0}, 0}));
}

TEST(SpanEnds, DoNotJoinOtherPassagesOrFamilies) {
  map::Track path = track_with_nodes(2, Passage::kBridge, {{30, 0}, {60, 0}}, {2, 3});
  path.surface = map::LandCoverClass::kFootPath;
  EXPECT_EQ(find_ends(with({kBridge, path}))[0].to.kind, EndKind::kFree);
  EXPECT_EQ(find_ends(with({kBridge, track_with_nodes(2, Passage::kTunnel, {{30, 0}, {60, 0}}, {2, 3})}))[0].to.kind,
            EndKind::kFree);
}

}  // namespace
}  // namespace citykiln::structures
