// Marks of layouts written as cross-sections, and properties of all layouts.
#include "compiler/roads/markings/markings.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "compiler/materials/coverage.h"
#include "compiler/roads/markings/marking_rules.h"
#include "tests/compiler/roads/markings/marking_layout_text.h"

namespace citykiln::roads {
namespace {

using map::LandCoverClass;

struct Extent {
  Vec2 low, high;
};

Extent extent_of(const Ring& ring) {
  Extent extent{ring.front(), ring.front()};
  for (const Vec2& p : ring) {
    extent.low = {std::min(extent.low.x, p.x), std::min(extent.low.y, p.y)};
    extent.high = {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y)};
  }
  return extent;
}

// ---- lines between lanes

// Lines along the way from left to right: u, then | solid, : broken, doubled where broad.
std::string lines_of(const MarkingLayout& layout) {
  std::map<std::pair<double, double>, double> painted_m;
  for (const Mark& mark : marks_of(layout)) {
    const Extent extent = extent_of(mark.ring);
    const double width_m = extent.high.x - extent.low.x;
    if (mark.ring.size() != 4 || width_m > 0.31 || mark.colour != kWhite) continue;
    const auto rounded = [](double v) { return std::round(v * 1000) / 1000; };
    painted_m[{rounded((extent.low.x + extent.high.x) / 2), rounded(width_m)}] += extent.high.y - extent.low.y;
  }
  std::string text;
  for (const auto& [line, length_m] : painted_m) {
    const std::string kind = std::abs(length_m - kLayoutLength_m) < 1e-9 ? "|" : ":";
    text += fmt::format("{}{:g}{}", text.empty() ? "" : " ", line.first, line.second > 0.2 ? kind + kind : kind);
  }
  return text;
}

struct Section {
  LandCoverClass surface;
  const char* lanes;
  const char *in_town, *in_country;
};
constexpr Section kSections[] = {
    {LandCoverClass::kTertiaryRoad, "dd v^", "3.25:", "3.25:"},
    {LandCoverClass::kSecondaryRoad, "dd v^", "3.25:", "0.25| 3.25: 6.25|"},
    {LandCoverClass::kPrimaryRoad, "dd ^^", "3.25:", "0.25| 3.25: 6.25|"},
    {LandCoverClass::kPrimaryRoad, "ddd v^^", "3.25: 6.5:", "0.25| 3.25: 6.5: 9.5|"},
    {LandCoverClass::kPrimaryRoad, "dddd vv^^", "3.25: 6.38| 6.62| 9.75:", "0.25| 3.25: 6.38| 6.62| 9.75: 12.75|"},
    {LandCoverClass::kPrimaryRoad, "dtd v-^", "3.25| 6.25|", "0.25| 3.25| 6.25| 9.25|"},
    {LandCoverClass::kSecondaryRoad, "cddc vv^^", "1.5|| 4.75: 8||", "1.5|| 4.75: 8||"},
    {LandCoverClass::kSecondaryRoad, "SddS vv^^", "2.5| 5.75: 9|", "2.5| 5.75: 9|"},
    {LandCoverClass::kSecondaryRoad, "bddb vv^^", "3.25|| 6.38| 6.62| 9.75||",
     "0.25| 3.25|| 6.38| 6.62| 9.75|| 12.75|"},
    {LandCoverClass::kMotorwayRoad, "dddS ^^^^", "0.25| 3.25: 6.5: 9.75||", "0.25| 3.25: 6.5: 9.75||"},
    {LandCoverClass::kTertiaryRoad, "p v", "1.94|", "1.94|"},
    {LandCoverClass::kTertiaryRoad, "p ^", "0.06|", "0.06|"},
    {LandCoverClass::kCyclePath, "|c| |^|", "", ""},
    // quiet street: no lines between cars, dense dashes beside cyclists
    {LandCoverClass::kResidentialRoad, "dd v^", "", ""},
    {LandCoverClass::kServiceRoad, "d -", "", ""},
    {LandCoverClass::kResidentialRoad, "pdd vv^", "", ""},
    {LandCoverClass::kResidentialRoad, "cd v^", "1.5:", "1.5:"},
    {LandCoverClass::kPedestrianStreet, "f -", "", ""},
    // unpaved
    {LandCoverClass::kUnpavedRoad, "dd v^", "", ""},
    {LandCoverClass::kPavement, "|s| |-|", "", ""},
};

TEST(Markings, LinesStandWhereTheCrossSectionSays) {
  for (const Section& section : kSections) {
    MarkingLayout strip = layout(section.surface, section.lanes);
    EXPECT_EQ(lines_of(strip), section.in_town) << section.lanes;
    strip.has_kerb_left = strip.has_kerb_right = false;
    EXPECT_EQ(lines_of(strip), section.in_country) << section.lanes;
  }
}

TEST(Markings, QuietAndUnpavedStreetsWithoutKerbsAreNotMarked) {
  const auto needs_column_in_country = [](MarkingLayout strip) {
    strip.has_kerb_left = strip.has_kerb_right = false;
    return needs_column(strip);
  };
  for (const LandCoverClass quiet :
       {LandCoverClass::kResidentialRoad, LandCoverClass::kServiceRoad, LandCoverClass::kPedestrianStreet,
        LandCoverClass::kUnpavedRoad, LandCoverClass::kFarmTrack})
    EXPECT_FALSE(needs_column_in_country(layout(quiet, "dd v^")));
  EXPECT_FALSE(needs_column_in_country(layout(LandCoverClass::kTertiaryRoad, "d -")));
  EXPECT_FALSE(needs_column(MarkingLayout{}));
  EXPECT_TRUE(needs_column(layout(LandCoverClass::kTertiaryRoad, "dd v^")));
  EXPECT_TRUE(needs_column(layout(LandCoverClass::kRailway, "r -")));
  MarkingLayout crossing = layout(LandCoverClass::kResidentialRoad, "dd v^");
  crossing.stretch = StretchKind::kZebra;
  EXPECT_TRUE(needs_column(crossing));
}

TEST(Markings, LinesOfLanesThatLeaveAndMergeAreBroadAndClose) {
  MarkingLayout exit = layout(LandCoverClass::kMotorwayRoad, "ddd ^^^");
  exit.lanes[0].turns = exit.lanes[1].turns = map::kTurnThrough;
  exit.lanes[2].turns = map::kTurnSlightRight;
  EXPECT_EQ(lines_of(exit), "0.25| 3.25: 6.5:: 9.5|");
  MarkingLayout merge = layout(LandCoverClass::kPrimaryRoad, "ddd ^^^");
  merge.lanes[2].turns = map::kTurnMergeToLeft;
  EXPECT_EQ(lines_of(merge), "3.25: 6.5::");
}

TEST(Markings, LinesAreSolidWhereDriversMayHaveToStop) {
  MarkingLayout end = layout(LandCoverClass::kPrimaryRoad, "ddd v^^");
  end.stretch = StretchKind::kEnd;
  EXPECT_EQ(lines_of(end), "3.25: 6.5:");
  end.control = Control::kSignals;
  EXPECT_EQ(lines_of(end), "3.25| 6.5|");
  end.stretch = StretchKind::kStart;
  EXPECT_EQ(lines_of(end), "3.25| 6.5:");
}

// ---- crossings and ends

std::vector<Extent> extents_of(const Marks& marks) {
  std::vector<Extent> extents;
  for (const Mark& mark : marks) extents.push_back(extent_of(mark.ring));
  return extents;
}

TEST(Markings, ZebrasAreBarsOfHalfAMetreInTheMiddle) {
  MarkingLayout strip = layout(LandCoverClass::kTertiaryRoad, "dd v^");
  strip.stretch = StretchKind::kZebra;
  for (const double lane_m : {1.0, 2.75, 3.25, 3.6}) {
    for (map::Lane& lane : strip.lanes) lane.width_m = lane_m;
    const std::vector<Extent> bars = extents_of(marks_of(strip));
    ASSERT_EQ(bars.size(), static_cast<std::size_t>(1 + std::floor(2 * lane_m - 0.5)));
    EXPECT_NEAR(bars.front().low.x, 2 * lane_m - bars.back().high.x, 1e-12);
    for (std::size_t i = 1; i < bars.size(); ++i) EXPECT_NEAR(bars[i].low.x - bars[i - 1].high.x, 0.5, 1e-12);
    for (std::size_t i = 0; i < bars.size(); ++i) {
      EXPECT_NEAR(bars[i].high.x - bars[i].low.x, 0.5, 1e-12);
      EXPECT_EQ(bars[i].low.y, 0);
      EXPECT_EQ(bars[i].high.y, kCrossingLength_m);
    }
  }
}

TEST(Markings, StopLinesCrossTheLanesThatArrive) {
  const auto stop_of = [](MarkingLayout strip) {
    strip.control = Control::kStop;
    for (const Extent& extent : extents_of(marks_of(strip)))
      if (std::abs(extent.high.y - extent.low.y - 0.5) < 1e-9) return extent;
    return Extent{};
  };
  MarkingLayout strip = layout(LandCoverClass::kPrimaryRoad, "dddc v^^^");
  strip.stretch = StretchKind::kEnd;
  EXPECT_EQ(stop_of(strip).low, (Vec2{3.25, 11.5}));
  EXPECT_EQ(stop_of(strip).high, (Vec2{11.25, 12}));
  strip.stretch = StretchKind::kStart;
  EXPECT_EQ(stop_of(strip).low, (Vec2{0, 0}));
  EXPECT_EQ(stop_of(strip).high, (Vec2{3.25, 0.5}));
  // a wide two-way lane: the half in which traffic arrives
  strip = layout(LandCoverClass::kResidentialRoad, "d -");
  strip.lanes[0].width_m = 5;
  strip.stretch = StretchKind::kEnd;
  EXPECT_EQ(stop_of(strip).low.x, 2.5);
  EXPECT_EQ(stop_of(strip).high.x, 5);
  strip.side = map::DrivingSide::kLeft;
  EXPECT_EQ(stop_of(strip).low.x, 0);
  EXPECT_EQ(stop_of(strip).high.x, 2.5);
}

TEST(Markings, TrafficWithPriorityHasNoLineAcross) {
  MarkingLayout strip = layout(LandCoverClass::kTertiaryRoad, "dd v^");
  strip.stretch = StretchKind::kEnd;
  EXPECT_EQ(marks_of(strip).size(), 1u);  // the centre line's dash
  strip.control = Control::kGiveWay;
  EXPECT_EQ(marks_of(strip).size(), 1u + 5u);  // 0.5 m dashes, 0.25 m gaps in a lane of 3.25 m: 4.67
}

TEST(Markings, BaysDivideTheLayout) {
  MarkingLayout strip = layout(LandCoverClass::kParking, "p -");
  for (const auto& [width_m, bays] : std::map<double, std::size_t>{{2, 2}, {3.5, 2}, {4.5, 4}, {5, 5}}) {
    strip.lanes[0].width_m = width_m;
    EXPECT_EQ(marks_of(strip).size(), bays) << width_m;
  }
}

TEST(Markings, RailsStandAtTheirGauge) {
  for (const double gauge_m : {1.0, 1.435, 1.668}) {
    MarkingLayout strip = layout(LandCoverClass::kRailway, "r -");
    strip.gauge_m = gauge_m;
    std::vector<Extent> heads;
    int sleepers = 0;
    for (const Mark& mark : marks_of(strip)) {
      const Extent extent = extent_of(mark.ring);
      sleepers += extent.high.y - extent.low.y < 1;
      if (std::abs(extent.high.x - extent.low.x - 0.07) < 1e-9) heads.push_back(extent);
    }
    EXPECT_EQ(sleepers, 20);
    ASSERT_EQ(heads.size(), 2u);
    EXPECT_NEAR(heads[1].low.x - heads[0].high.x, gauge_m, 1e-9);
    strip.stretch = StretchKind::kLevelCrossing;
    EXPECT_EQ(marks_of(strip).size(), 4u);
    EXPECT_EQ(base_colour_of(strip), base_colour_of(layout(LandCoverClass::kPrimaryRoad, "d ^")));
  }
}

// ---- arrows

// The direction of a single arrow's head: from the middle of its tail to its tip.
Vec2 pointing(MarkingLayout strip, std::uint16_t turns) {
  strip.lanes[0].turns = turns;
  for (const Mark& mark : marks_of(strip)) {
    if (mark.ring.size() != 3) continue;
    const Vec2 tip = mark.ring[1];
    return tip - (mark.ring[0] + mark.ring[2]) * 0.5;
  }
  return {};
}

TEST(Markings, ArrowsPointWhereDriversTurn) {
  struct Claim {
    std::uint16_t turn;
    int right, ahead;  // signs
  };
  const Claim claims[] = {
      {map::kTurnThrough, 0, 1},     {map::kTurnLeft, -1, 0},        {map::kTurnRight, 1, 0},
      {map::kTurnSlightLeft, -1, 1}, {map::kTurnSlightRight, 1, 1},  {map::kTurnSharpLeft, -1, -1},
      {map::kTurnSharpRight, 1, -1}, {map::kTurnMergeToLeft, -1, 1}, {map::kTurnMergeToRight, 1, 1},
      {map::kTurnReverse, 0, -1},
  };
  const auto sign = [](double v) { return v > 1e-9 ? 1 : v < -1e-9 ? -1 : 0; };
  for (const map::DrivingSide side : {map::DrivingSide::kRight, map::DrivingSide::kLeft}) {
    for (const Claim& claim : claims) {
      MarkingLayout strip = layout(LandCoverClass::kPrimaryRoad, "d ^");
      strip.side = side;
      strip.stretch = StretchKind::kEnd;
      const Vec2 forward = pointing(strip, claim.turn);
      EXPECT_EQ(sign(forward.x), claim.right) << claim.turn;
      EXPECT_EQ(sign(forward.y), claim.ahead) << claim.turn;
      // traffic against the way sees the same, so u and v are reversed
      strip.lanes[0].way = map::LaneDirection::kBackward;
      strip.stretch = StretchKind::kStart;
      const Vec2 backward = pointing(strip, claim.turn);
      EXPECT_EQ(sign(backward.x), -claim.right) << claim.turn;
      EXPECT_EQ(sign(backward.y), -claim.ahead) << claim.turn;
      // and none where a lane leaves the junction
      strip.stretch = StretchKind::kEnd;
      EXPECT_EQ(pointing(strip, claim.turn), (Vec2{0, 0})) << claim.turn;
    }
  }
}

TEST(Markings, UTurnsPointToTheOncomingTraffic) {
  for (const map::DrivingSide side : {map::DrivingSide::kRight, map::DrivingSide::kLeft}) {
    MarkingLayout strip = layout(LandCoverClass::kPrimaryRoad, "d ^");
    strip.side = side;
    strip.stretch = StretchKind::kEnd;
    strip.lanes[0].turns = map::kTurnReverse;
    double head_m = 0, tail_m = 0;
    for (const Mark& mark : marks_of(strip)) {
      const Extent extent = extent_of(mark.ring);
      if (mark.ring.size() == 3) head_m = (extent.low.x + extent.high.x) / 2;
      if (extent.low.y == 4.5) tail_m = (extent.low.x + extent.high.x) / 2;
    }
    EXPECT_NE(head_m, 0) << "no head was found";
    EXPECT_NE(tail_m, 0) << "no tail was found";
    EXPECT_EQ(head_m < tail_m, side == map::DrivingSide::kRight);
  }
}

TEST(Markings, EachTurnOfALaneHasAHead) {
  MarkingLayout strip = layout(LandCoverClass::kPrimaryRoad, "d ^");
  strip.stretch = StretchKind::kEnd;
  for (std::uint16_t turns = 0; turns < 128; ++turns) {
    strip.lanes[0].turns = turns;
    int heads = 0, turned = 0;
    for (const Mark& mark : marks_of(strip)) heads += mark.ring.size() == 3;
    for (int bit = 0; bit < 7; ++bit) turned += turns >> bit & 1;
    EXPECT_EQ(heads, turned);
  }
}

// ---- any layout

MarkingLayout random_layout(std::mt19937& random) {
  const auto below = [&](unsigned count) { return std::uniform_int_distribution<unsigned>(0, count - 1)(random); };
  constexpr LandCoverClass kSurfaces[] = {LandCoverClass::kMotorwayRoad,    LandCoverClass::kPrimaryRoad,
                                          LandCoverClass::kSecondaryRoad,   LandCoverClass::kTertiaryRoad,
                                          LandCoverClass::kResidentialRoad, LandCoverClass::kCyclePath,
                                          LandCoverClass::kParking,         LandCoverClass::kUnpavedRoad,
                                          LandCoverClass::kRailway,         LandCoverClass::kTram};
  MarkingLayout strip;
  strip.surface = kSurfaces[below(std::size(kSurfaces))];
  for (unsigned lanes = 1 + below(7); lanes > 0; --lanes) {
    map::Lane lane;
    lane.kind = static_cast<map::LaneKind>(below(11));
    lane.way = static_cast<map::LaneDirection>(below(3));
    lane.width_m = (256 + below(5000)) / 1024.0;
    lane.turns = below(2) ? static_cast<std::uint16_t>(below(1024)) : 0;
    lane.is_raised = below(5) == 0;
    strip.lanes.push_back(lane);
  }
  strip.stretch = static_cast<StretchKind>(below(6));
  strip.control = static_cast<Control>(below(4));
  strip.side = static_cast<map::DrivingSide>(below(2));
  strip.practice = static_cast<MarkingPractice>(below(3));
  strip.has_kerb_left = below(2), strip.has_kerb_right = below(2);
  strip.gauge_m = below(2) ? kStandardGauge_m : 1.0;
  return strip;
}

constexpr std::uint32_t kRows = 60, kColumns = 250;

using Painted =
    std::map<materials::TextureImage::Texel, std::vector<double>>;  // by colour, the covered share of each texel

// u from left_m to right_m in kColumns texels; `flip` transforms the marks.
template <class Flip>
Painted painted(const Marks& marks, double across_m, double texel_m, Flip flip) {
  Painted sums;
  for (const Mark& mark : marks) {
    Ring ring = mark.ring;
    for (Vec2& p : ring) p = flip(p) + Vec2{(kColumns * texel_m - across_m) / 2, 0};
    const materials::Coverage cover = materials::coverage_of(ring, texel_m, kRows, {0, kColumns});
    std::vector<double>& sum = sums.try_emplace(mark.colour, kRows * kColumns).first->second;
    for (std::size_t r = 0; r < cover.rows; ++r)
      for (std::size_t c = 0; c < cover.columns; ++c)
        sum[(cover.first_row + r) % kRows * kColumns + cover.first_column + c] += cover.share[r * cover.columns + c];
  }
  return sums;
}

double difference(const Painted& a, const Painted& b) {
  double worst = a.size() == b.size() ? 0 : 1e9;
  for (const auto& [colour, sum] : a) {
    const auto other = b.find(colour);
    if (other == b.end()) return 1e9;
    for (std::size_t i = 0; i < sum.size(); ++i) worst = std::max(worst, std::abs(sum[i] - other->second[i]));
  }
  return worst;
}

TEST(Markings, ARotatedLayoutHasRotatedMarks) {
  std::mt19937 random(3);
  const double texel_m = kLayoutLength_m / kRows;
  for (int i = 0; i < 2000; ++i) {
    const MarkingLayout strip = random_layout(random), turned = turned_round(strip);
    ASSERT_EQ(turned_round(turned), strip);
    const double across_m = width_m(strip), along_m = length_m(strip);
    const Painted there = painted(marks_of(strip), across_m, texel_m, [](Vec2 p) { return p; });
    const Painted back = painted(marks_of(turned), across_m, texel_m, [&](Vec2 p) {
      return Vec2{across_m, along_m} - p;
    });
    ASSERT_LT(difference(there, back), 1e-9) << i;
  }
}

std::uint16_t mirrored(std::uint16_t turns) {
  std::uint16_t other = turns & (map::kTurnThrough | map::kTurnReverse);
  const std::pair<int, int> sides[] = {{map::kTurnSharpLeft, map::kTurnSharpRight},
                                       {map::kTurnLeft, map::kTurnRight},
                                       {map::kTurnSlightLeft, map::kTurnSlightRight},
                                       {map::kTurnMergeToLeft, map::kTurnMergeToRight}};
  for (const auto& [left, right] : sides)
    other |= static_cast<std::uint16_t>((turns & left ? right : 0) | (turns & right ? left : 0));
  return other;
}

TEST(Markings, TheOtherDrivingSideIsTheMirrorImage) {
  std::mt19937 random(4);
  const double texel_m = kLayoutLength_m / kRows;
  for (int i = 0; i < 2000; ++i) {
    MarkingLayout strip = random_layout(random);
    // letters and bicycles are not mirrored
    const bool has_symbols = strip.stretch == StretchKind::kStart || strip.stretch == StretchKind::kEnd;
    for (map::Lane& lane : strip.lanes)
      if (has_symbols && (lane.kind == map::LaneKind::kCycle || lane.kind == map::LaneKind::kBus))
        lane.kind = map::LaneKind::kDriving;
    MarkingLayout other = strip;
    std::reverse(other.lanes.begin(), other.lanes.end());
    for (map::Lane& lane : other.lanes) lane.turns = mirrored(lane.turns);
    other.side = strip.side == map::DrivingSide::kLeft ? map::DrivingSide::kRight : map::DrivingSide::kLeft;
    std::swap(other.has_kerb_left, other.has_kerb_right);
    const double across_m = width_m(strip);
    const Painted there = painted(marks_of(strip), across_m, texel_m, [](Vec2 p) { return p; });
    const Painted here = painted(marks_of(other), across_m, texel_m, [&](Vec2 p) { return Vec2{across_m - p.x, p.y}; });
    ASSERT_LT(difference(there, here), 1e-9) << i;
  }
}

TEST(Markings, MarksStayOnTheirStrip) {
  std::mt19937 random(5);
  std::size_t marks = 0;
  for (int i = 0; i < 5000; ++i) {
    const MarkingLayout strip = random_layout(random);
    for (const Mark& mark : marks_of(strip)) {
      ++marks;
      ASSERT_GE(mark.ring.size(), 3u);
      const Extent extent = extent_of(mark.ring);
      ASSERT_GE(extent.low.x, -1e-9) << i;
      ASSERT_LE(extent.high.x, width_m(strip) + 1e-9) << i;
      if (length_m(strip) == kLayoutLength_m) continue;
      ASSERT_GE(extent.low.y, 0) << i;
      ASSERT_LE(extent.high.y, kCrossingLength_m) << i;
    }
  }
  EXPECT_GT(marks, 5000u);
}

TEST(Markings, DashesContinueAcrossTheLayoutsEnds) {
  // repeated once, dashes and gaps still alternate: the gap across the end equals the others
  std::size_t compared = 0;
  for (const char* section : {"dd v^", "dd ^^", "cd v^"}) {
    for (const LandCoverClass surface :
         {LandCoverClass::kMotorwayRoad, LandCoverClass::kSecondaryRoad, LandCoverClass::kResidentialRoad}) {
      std::map<double, std::vector<Extent>> lines;
      for (const Mark& mark : marks_of(layout(surface, section)))
        if (mark.colour == kWhite) lines[mark.ring[0].x].push_back(extent_of(mark.ring));
      compared += lines.size();
      for (auto& [u, dashes] : lines) {
        std::set<long> gaps_mm;
        for (std::size_t i = 0; i < dashes.size(); ++i) {
          const Extent& next = dashes[(i + 1) % dashes.size()];
          const double wrap_m = i + 1 == dashes.size() ? kLayoutLength_m : 0;
          gaps_mm.insert(std::lround(1000 * (next.low.y + wrap_m - dashes[i].high.y)));
        }
        EXPECT_EQ(gaps_mm.size(), 1u) << section;
      }
    }
  }
  EXPECT_GT(compared, 0u);
}

TEST(Markings, HatchingContinuesAcrossTheLayoutsEnds) {
  // a stripe that ends at the end continues at the start: shifted by a period the buffer looks the same
  MarkingLayout strip = layout(LandCoverClass::kSecondaryRoad, "d/c ^^^");
  for (const auto& [width_m, period_m] : std::map<double, double>{{0.5, 1.0}, {1.25, 1.5}}) {
    strip.lanes[1].width_m = width_m;
    const double texel_m = kLayoutLength_m / kRows, across_m = roads::width_m(strip), moved_m = period_m;
    const Painted here = painted(marks_of(strip), across_m, texel_m, [](Vec2 p) { return p; });
    const Painted moved = painted(marks_of(strip), across_m, texel_m, [&](Vec2 p) { return p + Vec2{0, moved_m}; });
    EXPECT_LT(difference(here, moved), 1e-9);
  }
}

TEST(MarkingLayout, CanonicalIsTheSameSeenFromEitherEnd) {
  std::mt19937 random(6);
  for (int i = 0; i < 2000; ++i) {
    const MarkingLayout strip = random_layout(random);
    const CanonicalLayout there = canonical_layout(strip), back = canonical_layout(turned_round(strip));
    EXPECT_EQ(there.layout, back.layout);
    EXPECT_EQ(there.is_turned ? turned_round(there.layout) : there.layout, strip);
  }
}

TEST(MarkingLayout, IsOrderedByAllItsMembers) {
  const MarkingLayout strip = layout(LandCoverClass::kPrimaryRoad, "dd v^");
  std::vector<MarkingLayout> others(10, strip);
  others[0].surface = LandCoverClass::kSecondaryRoad;
  others[1].lanes[1].width_m += 1;
  others[2].lanes[1].turns = 1;
  others[3].lanes[1].way = map::LaneDirection::kBoth;
  others[4].lanes.pop_back();
  others[5].stretch = StretchKind::kEnd;
  others[6].control = Control::kStop;
  others[7].side = map::DrivingSide::kLeft;
  others[8].has_kerb_left = false;
  others[9].gauge_m = 1;
  for (const MarkingLayout& other : others) {
    EXPECT_NE(other, strip);
    EXPECT_NE(other < strip, strip < other);
  }
  EXPECT_EQ(strip, layout(LandCoverClass::kPrimaryRoad, "dd v^"));
}

// ---- the practice of countries

MarkingLayout american(MarkingLayout layout) {
  layout.practice = MarkingPractice::kAmerican;
  return layout;
}

std::size_t count_of(const MarkingLayout& layout, materials::TextureImage::Texel colour) {
  const Marks marks = marks_of(layout);
  return static_cast<std::size_t>(std::ranges::count(marks, colour, &Mark::colour));
}

TEST(Markings, AmericanLinesBetweenDirectionsAreYellow) {
  MarkingLayout street = layout(LandCoverClass::kTertiaryRoad, "dd v^");
  EXPECT_EQ(count_of(street, kYellow), 0u);
  EXPECT_EQ(count_of(american(street), kYellow), 2u);
  EXPECT_EQ(count_of(american(street), kWhite), 0u);
  street.has_kerb_left = street.has_kerb_right = false;
  EXPECT_EQ(count_of(american(street), kYellow), 1u);
  EXPECT_EQ(count_of(american(layout(LandCoverClass::kTertiaryRoad, "dd ^^")), kYellow), 0u);
}

TEST(Markings, AnAmericanTurnLaneHasSolidLinesOutside) {
  const MarkingLayout street = american(layout(LandCoverClass::kSecondaryRoad, "dtd v-^"));
  std::vector<double> solid_m, broken_m;
  for (const Mark& mark : marks_of(street)) {
    const Extent extent = extent_of(mark.ring);
    if (mark.colour != kYellow) continue;
    (extent.high.y - extent.low.y > 6 ? solid_m : broken_m).push_back((extent.low.x + extent.high.x) / 2);
  }
  EXPECT_EQ(solid_m.size(), 2u);
  EXPECT_EQ(broken_m.size(), 2u);
  const double middle_m = width_m(street) / 2;
  for (const double solid : solid_m)
    for (const double broken : broken_m) EXPECT_GT(std::abs(solid - middle_m), std::abs(broken - middle_m) - 1e-9);
}

TEST(Markings, AmericansGiveWayAtTrianglesThatPointAtThem) {
  MarkingLayout street = american(layout(LandCoverClass::kTertiaryRoad, "dd v^"));
  street.stretch = StretchKind::kEnd, street.control = Control::kGiveWay;
  int triangles = 0;
  for (const Mark& mark : marks_of(street)) {
    if (mark.ring.size() != 3) continue;
    ++triangles;
    EXPECT_EQ(std::ranges::count(mark.ring, kLayoutLength_m, &Vec2::y), 2);
    EXPECT_GT(extent_of(mark.ring).low.x, width_m(street) / 2 - 1e-9);
  }
  EXPECT_EQ(triangles, 3);
}

TEST(Markings, NarrowJapaneseStreetsWithoutKerbsHaveLinesForWalkers) {
  MarkingLayout street = layout(LandCoverClass::kResidentialRoad, "dd v^");
  street.has_kerb_left = false;
  EXPECT_TRUE(marks_of(street).empty());
  street.practice = MarkingPractice::kJapanese;
  const Marks marks = marks_of(street);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_LT(extent_of(marks.front().ring).high.x, 0.6);
}

TEST(Markings, PracticeFollowsTheCountry) {
  EXPECT_EQ(practice_of(map::CountryGroup::kNorthAmerica), MarkingPractice::kAmerican);
  EXPECT_EQ(practice_of(map::CountryGroup::kCentralEurope), MarkingPractice::kVienna);
  EXPECT_EQ(practice_of(map::CountryGroup::kOceania), MarkingPractice::kVienna);
}

}  // namespace
}  // namespace citykiln::roads
