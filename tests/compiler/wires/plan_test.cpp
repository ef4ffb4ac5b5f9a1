#include "compiler/wires/plan.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/things/facing.h"
#include "compiler/things/plan.h"
#include "compiler/wires/sag.h"
#include "compiler/wires/supports.h"

namespace citykiln::wires {
namespace {

const things::Kinds& shipped_kinds() {
  static const things::Kinds kinds = *things::kinds_of(*things::read_catalogue({}, ""));
  return kinds;
}

// A plain of 2 km at a height of 10 m, with a ridge from south to north if it is higher.
map::Heightfield plain(double ridge_m = 0) {
  map::Heightfield field{{-1024, -1024}, {16, 16}, 129, 129, {}, 0};
  for (int j = 0; j < 129; ++j)
    for (int i = 0; i < 129; ++i)
      field.heights.push_back(
          static_cast<std::int32_t>((10 + (std::abs(i - 64) <= 2 ? ridge_m : 0)) / map::kHeightQuantum_m));
  return field;
}

// A map with one line and supports at its nodes; an empty kind is a node without support.
struct Line {
  map::Features features;
  std::vector<things::Thing> things;
  std::vector<roads::Road> roads;

  Line(const Polyline& axis, const std::vector<std::string>& kinds, map::PowerLineKind kind) {
    features.extent = {{-1024, -1024}, {1024, 1024}};
    map::PowerLine line{.id = {{OsmType::kWay, 1}, 0}, .axis = axis, .corridor_m = 20, .kind = kind};
    for (std::size_t i = 0; i < axis.size(); ++i) {
      line.node_ids.push_back(static_cast<std::int64_t>(10 + i));
      if (!kinds[i].empty()) add_support(axis, i, kinds[i]);
    }
    features.power_lines.push_back(line);
  }

  void add_support(const Polyline& axis, std::size_t i, const std::string& kind) {
    const map::ThingRow& row = shipped_kinds().at(kind).row;
    const ObjectId id{{OsmType::kNode, static_cast<std::int64_t>(10 + i)}, 0};
    const Vec2 before = i > 0 ? unit(axis[i] - axis[i - 1]) : Vec2{},
               after = i + 1 < axis.size() ? unit(axis[i + 1] - axis[i]) : Vec2{};
    features.things.push_back({.id = id, .at = axis[i], .kind = kind, .value = ""});
    things.push_back({.id = id,
                      .at = axis[i],
                      .direction = things::nearest_direction(before + after),
                      .form = {.kind = kind,
                               .width_m = row.width.default_m,
                               .depth_m = row.depth.default_m,
                               .height_m = row.height.default_m}});
  }

  std::vector<WireSpan> planned(Report& report, double ridge_m = 0) const {
    const ground::GradedTerrain ground{plain(ridge_m)};
    return plan(features,
                {.mapped = features.things,
                 .things = things,
                 .beyond = {},
                 .kinds = shipped_kinds(),
                 .roads = roads,
                 .bridges = {},
                 .ground = ground,
                 .seed = 1},
                report);
  }
  std::vector<WireSpan> planned(double ridge_m = 0) const {
    Report report;
    return planned(report, ridge_m);
  }
};

Line towers(const Polyline& axis) {
  return {axis, std::vector<std::string>(axis.size(), "power_tower"), map::PowerLineKind::kLine};
}

std::size_t count_of(const WireSpan& span, WireKind kind) {
  return static_cast<std::size_t>(std::ranges::count(span.wires, kind, &Wire::kind));
}

std::size_t times(const Report& report, Code code) {
  return static_cast<std::size_t>(std::ranges::count(report.diagnoses(), code, &Diagnosis::code));
}

TEST(PlanWires, JoinsSupportsThatFollowEachOther) {
  const std::vector<WireSpan> spans = towers({{-600, 0}, {-300, 0}, {0, 0}, {300, 60}}).planned();
  ASSERT_EQ(spans.size(), 3u);
  for (const WireSpan& span : spans) {
    EXPECT_EQ(count_of(span, WireKind::kConductor), 6u);
    EXPECT_EQ(count_of(span, WireKind::kEarthWire), 1u);
  }
}

TEST(PlanWires, MeetsTheInsulatorsOfTheSupport) {
  const Line line = towers({{-300, 0}, {0, 0}, {280, 150}});
  const std::vector<WireSpan> spans = line.planned();
  ASSERT_EQ(spans.size(), 2u);
  Supports supports;
  add_supports(supports, line.things, shipped_kinds(), 1, ground::GradedTerrain{plain()});
  for (const WireSpan& span : spans)
    for (const Wire& wire : span.wires)
      for (const Vec3 end : {wire.from, wire.to}) {
        double least_m = 1e9;
        for (const auto& [node, support] : supports)
          for (const things::WireHold& hold : support.holds) least_m = std::min(least_m, length(hold.at - end));
        EXPECT_LE(least_m, kWireQuantum_m);
      }
  // wires of both spans end at the same places of the tower in the middle
  for (std::size_t i = 0; i < spans[0].wires.size(); ++i) EXPECT_EQ(spans[0].wires[i].to, spans[1].wires[i].from);
}

TEST(PlanWires, DoNotCross) {
  for (const WireSpan& span : towers({{-300, 0}, {0, 0}, {100, 280}}).planned())
    for (const Wire& a : span.wires)
      for (const Wire& b : span.wires) {
        const Vec2 along = unit(in_plan(span.wires[0].to - span.wires[0].from));
        const double before = cross(along, in_plan(b.from - a.from)), after = cross(along, in_plan(b.to - a.to));
        if (std::abs(before) > 1 && std::abs(after) > 1) {
          EXPECT_GT(before * after, 0);
        }
      }
}

TEST(PlanWires, HangsNothingOnNodesWithoutSupport) {
  const Line line({{-300, 0}, {-100, 2}, {0, 0}, {300, 0}}, {"power_tower", "", "power_tower", ""},
                  map::PowerLineKind::kLine);
  const std::vector<WireSpan> spans = line.planned();
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_NEAR(middle_of(spans[0]).x, -150, 1);
}

TEST(PlanWires, EndsAtAMappedSupportThatIsNotBuilt) {
  Line line = towers({{-300, 0}, {0, 0}, {300, 0}});
  std::erase_if(line.things, [](const auto& thing) { return thing.id.osm.id == 11; });
  EXPECT_TRUE(line.planned().empty());
}

TEST(PlanWires, HasAsManyConductorsAsAreTagged) {
  Line line = towers({{-300, 0}, {0, 0}});
  line.features.power_lines[0].cables = 3;
  const std::vector<WireSpan> spans = line.planned();
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_EQ(count_of(spans[0], WireKind::kConductor), 3u);
  for (const Wire& wire : spans[0].wires)
    if (wire.kind == WireKind::kConductor) {
      EXPECT_LT(wire.from.y, 0) << "on the right of the line";
    }
}

TEST(PlanWires, PolesHoldThreeWires) {
  const Line line({{0, 0}, {60, 0}, {120, 0}}, {"power_pole", "power_pole", "power_pole"},
                  map::PowerLineKind::kMinorLine);
  const std::vector<WireSpan> spans = line.planned();
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_EQ(spans[0].wires.size(), 3u);
  EXPECT_NEAR(spans[0].wires[0].sag_m, 60 * 60 / (8 * 600.0), kWireQuantum_m);
}

TEST(PlanWires, SagWithTheirSpanAndKeepTheirClearance) {
  const Line line = towers({{-300, 0}, {300, 0}});
  const double sag_m = line.planned()[0].wires[0].sag_m;
  // 600² / (8 · 1225) is 36.7 m, more than 6 m above the ground allow
  EXPECT_LT(sag_m, 36.7);
  for (const double ridge_m : {0.0, 12.0}) {
    const std::vector<WireSpan> spans = line.planned(ridge_m);
    ASSERT_EQ(spans.size(), 1u);
    const ground::GradedTerrain ground{plain(ridge_m)};
    for (const Wire& wire : spans[0].wires)
      for (int i = 0; i <= 100; ++i) {
        const Vec3 p = place_on(wire, i / 100.0);
        EXPECT_GE(p.z - land_m(ground, in_plan(p)), 6 - 0.2);
      }
  }
}

TEST(PlanWires, DropsWiresThatWouldTouchTheGround) {
  Report report;
  EXPECT_TRUE(towers({{-300, 0}, {300, 0}}).planned(report, 40).empty());
  EXPECT_EQ(times(report, Code::kWireTooLow), 1u);
}

TEST(PlanWires, DropsWiresThatWouldBeLowOverARoad) {
  Line line({{-30, 0}, {30, 0}}, {"power_pole", "power_pole"}, map::PowerLineKind::kMinorLine);
  for (things::Thing& thing : line.things) thing.form.height_m = 5.5;
  EXPECT_EQ(line.planned().size(), 1u);
  roads::Road road;
  road.axis = {{0, -50}, {0, 50}}, road.surface = map::LandCoverClass::kResidentialRoad;
  line.roads.push_back(road);
  Report report;
  EXPECT_TRUE(line.planned(report).empty());
  EXPECT_EQ(times(report, Code::kWireTooLow), 1u);
}

TEST(PlanWires, DropsSpansBeyondTheLongest) {
  Report report;
  EXPECT_EQ(towers({{-500, 0}, {kLongestSpan_m - 501, 0}}).planned(report).size(), 1u);
  EXPECT_TRUE(towers({{-500, 0}, {kLongestSpan_m - 499, 0}}).planned(report).empty());
  EXPECT_EQ(times(report, Code::kSpanTooLong), 1u);
}

TEST(PlanWires, TwoSupportsHaveOneSpan) {
  Line line = towers({{-300, 0}, {0, 0}});
  map::PowerLine second = line.features.power_lines[0];
  second.id.osm.id = 2;
  std::ranges::reverse(second.axis), std::ranges::reverse(second.node_ids);
  line.features.power_lines.push_back(second);
  EXPECT_EQ(line.planned().size(), 1u);
}

TEST(PlanWires, AerialwaysHaveACableOnEachSide) {
  const Line line({{0, 0}, {150, 0}}, {"aerialway_pylon", "aerialway_pylon"}, map::PowerLineKind::kAerialway);
  const std::vector<WireSpan> spans = line.planned();
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_EQ(count_of(spans[0], WireKind::kCable), 2u);
}

TEST(Sag, IsTautWhereSupportsAreLow) {
  const std::vector<Wire> wires = {{{0, 0, 6}, {100, 0, 6}, 0, 15, WireKind::kConductor}};
  const std::vector<std::vector<Below>> below = {{{0.5, 1, false}}};
  EXPECT_NEAR(sag_m_of(wires, below, 100, kLineSag), 0.5, kWireQuantum_m);
  EXPECT_NEAR(sag_m_of(wires, {{std::vector<Below>{{0.5, -1, false}}}}, 100, kLineSag), 1, kWireQuantum_m);
}

}  // namespace
}  // namespace citykiln::wires
