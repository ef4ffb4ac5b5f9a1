#include "compiler/roads/markings/drainage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "compiler/geometry/box.h"
#include "tests/compiler/roads/markings/marking_layout_text.h"

namespace citykiln::roads {
namespace {

using map::LandCoverClass;
using DrainageBoxes = std::vector<std::tuple<int, int, int, int, materials::TextureImage::Texel>>;

constexpr StretchKind kStretches[] = {StretchKind::kAlong, StretchKind::kStart, StretchKind::kEnd, StretchKind::kZebra};
constexpr const char* kStrips[] = {"dd v^", "cdd -v^", "d -", "p ^", "bddd vv^^"};

std::vector<MarkingLayout> some_layouts() {
  std::vector<MarkingLayout> layouts;
  for (const char* lanes : kStrips)
    for (const StretchKind stretch : kStretches)
      for (const MarkingPractice practice : {MarkingPractice::kVienna, MarkingPractice::kAmerican})
        for (const int kerbs : {1, 2, 3}) {
          layouts.push_back(layout(LandCoverClass::kResidentialRoad, lanes));
          layouts.back().stretch = stretch, layouts.back().practice = practice;
          layouts.back().has_kerb_left = (kerbs & 1) != 0, layouts.back().has_kerb_right = (kerbs & 2) != 0;
        }
  return layouts;
}

// The boxes of marks in millimetres, and their colours.
DrainageBoxes drainage_boxes(const Marks& marks) {
  DrainageBoxes extents;
  const auto mm = [](double metres) { return static_cast<int>(std::lround(metres * 1000)); };
  for (const Mark& mark : marks) {
    const Box2 box = box_of(mark.ring);
    extents.emplace_back(mm(box.min.x), mm(box.min.y), mm(box.max.x), mm(box.max.y), mark.colour);
  }
  std::ranges::sort(extents);
  return extents;
}

TEST(Drainage, StaysOnItsStrip) {
  for (const MarkingLayout& strip : some_layouts()) {
    const Marks marks = drainage_of(strip);
    EXPECT_FALSE(marks.empty());
    for (const Mark& mark : marks) {
      EXPECT_GE(box_of(mark.ring).min.x, 0);
      EXPECT_LE(box_of(mark.ring).max.x, width_m(strip) + 1e-9);
      EXPECT_GE(box_of(mark.ring).min.y, 0);
      EXPECT_LE(box_of(mark.ring).max.y, length_m(strip) + 1e-9);
    }
  }
}

TEST(Drainage, OfARotatedLayoutIsRotated) {
  for (const MarkingLayout& strip : some_layouts())
    EXPECT_EQ(drainage_boxes(drainage_of(turned_round(strip))),
              drainage_boxes(turned_round(drainage_of(strip), width_m(strip), length_m(strip))));
}

TEST(Drainage, LiesAtKerbsAlone) {
  MarkingLayout strip = layout(LandCoverClass::kResidentialRoad, "dd v^");
  strip.has_kerb_right = false;
  for (const Mark& mark : drainage_of(strip)) EXPECT_LE(box_of(mark.ring).max.x, 0.3);
  strip.practice = MarkingPractice::kAmerican;
  for (const Mark& mark : drainage_of(strip)) EXPECT_LE(box_of(mark.ring).max.x, 0.45);
  strip.has_kerb_left = false;
  EXPECT_TRUE(drainage_of(strip).empty());
}

TEST(Drainage, NeedsHardCarriageways) {
  EXPECT_TRUE(drainage_of(layout(LandCoverClass::kUnpavedRoad, "dd v^")).empty());
  EXPECT_TRUE(drainage_of(layout(LandCoverClass::kPavement, "|s| |-|")).empty());
  EXPECT_TRUE(drainage_of(layout(LandCoverClass::kRailway, "r -")).empty());
  EXPECT_TRUE(drainage_of(MarkingLayout{}).empty());
}

TEST(Drainage, HasCoversBeforeJunctionsAlone) {
  MarkingLayout strip = layout(LandCoverClass::kResidentialRoad, "dd v^");
  const std::size_t along = drainage_of(strip).size();
  strip.stretch = StretchKind::kEnd;
  EXPECT_EQ(drainage_of(strip).size(), along + 4);
}

}  // namespace
}  // namespace citykiln::roads
