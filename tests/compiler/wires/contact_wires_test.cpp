#include "compiler/wires/contact_wires.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace citykiln::wires {
namespace {

ground::GradedTerrain land_below_tracks() {
  map::Heightfield field{{-1024, -1024}, {16, 16}, 129, 129, {}, 0};
  field.heights.assign(129 * 129, static_cast<std::int32_t>(10 / map::kHeightQuantum_m));
  return ground::GradedTerrain(std::move(field));
}

map::Track electrified(std::int64_t id, Polyline axis, std::vector<std::int64_t> nodes) {
  map::Track track;
  track.id = {{OsmType::kWay, id}, 0};
  track.axis = std::move(axis), track.node_ids = std::move(nodes);
  track.surface = map::LandCoverClass::kRailway, track.is_rail = true, track.has_contact_line = true;
  return track;
}

std::vector<WireSpan> spans_of(std::vector<map::Track> tracks) {
  static const ground::GradedTerrain land = land_below_tracks();
  map::Features features;
  features.extent = {{-1024, -1024}, {1024, 1024}};
  features.tracks = std::move(tracks);
  Report report;
  const things::ContactLines lines =
      things::plan_contact_lines(features, {.cover = {}, .roads = {}, .bridges = {}, .ground = land}, report);
  return contact_spans(lines, land, report);
}

TEST(ContactWires, HangBetweenTheMastsOfATrack) {
  const std::vector<WireSpan> spans = spans_of({electrified(1, {{0, 0}, {600, 0}}, {1, 2})});
  ASSERT_EQ(spans.size(), 9u);
  for (const WireSpan& span : spans) {
    ASSERT_EQ(span.wires.size(), 2u);
    const Wire &contact = span.wires[0], &messenger = span.wires[1];
    EXPECT_EQ(contact.kind, WireKind::kContactWire);
    for (const double t : {0.0, 0.5, 1.0}) {
      const double above_m = place_on(contact, t).z - 10;
      EXPECT_TRUE(above_m > 5 && above_m < 5.5);
      EXPECT_GT(place_on(messenger, t).z, place_on(contact, t).z + 0.5);
    }
    EXPECT_GT(messenger.sag_m, 5 * contact.sag_m);
    EXPECT_GE(span.above_m, 6.7);
  }
}

TEST(ContactWires, GoOnAcrossWaysAndSwitches) {
  // the second way continues the first; the third leaves it
  const std::vector<WireSpan> spans =
      spans_of({electrified(1, {{0, 0}, {300, 0}}, {1, 2}), electrified(2, {{300, 0}, {500, 0}, {720, 0}}, {2, 3, 4}),
                electrified(3, {{500, 0}, {800, 60}}, {3, 5})});
  const auto joins = [&](double from, double to, double y) {
    return std::ranges::any_of(spans, [&](const WireSpan& span) {
      const auto [a, b] = std::minmax(span.wires[0].from.x, span.wires[0].to.x);
      return a < from && b > to && std::max(span.wires[0].from.y, span.wires[0].to.y) > y;
    });
  };
  EXPECT_TRUE(joins(299, 301, -1));
  EXPECT_TRUE(joins(499, 501, 1)) << "the wire of the branch begins on the line";
  for (const WireSpan& span : spans)
    EXPECT_LE(std::abs(span.wires[0].to.x - span.wires[0].from.x), things::kLongestContactSpan_m);
}

TEST(ContactWires, EndWhereTheContactLineEnds) {
  std::vector<map::Track> tracks = {electrified(1, {{0, 0}, {300, 0}}, {1, 2}),
                                    electrified(2, {{300, 0}, {700, 0}}, {2, 4})};
  tracks[1].has_contact_line = false;
  for (const WireSpan& span : spans_of(tracks)) EXPECT_LT(std::max(span.wires[0].from.x, span.wires[0].to.x), 300);
}

}  // namespace
}  // namespace citykiln::wires
