#include "compiler/pitches/panels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "compiler/geometry/trig.h"
#include "compiler/pitches/pitch_lines.h"
#include "compiler/pitches/pitch_rules.h"
#include "compiler/roads/markings/markings.h"

namespace citykiln::pitches {
namespace {

constexpr map::LandCoverClass kGrass = map::LandCoverClass::kPitch;

Pitch turned_pitch(PitchKind kind, double scale = 1, double turns = 0.083) {
  const PitchRules& rules = rules_of(kind);
  const Vec2 middle{120.5, -33}, along = direction_of(turns);
  const double half_m = std::max(rules.length.least_m, scale * rules.length.usual_m) / 2;
  return {{},
          kind,
          middle - along * half_m,
          middle + along * half_m,
          std::max(rules.width.least_m, scale * rules.width.usual_m)};
}

bool is_in(const Panel& panel, Vec2 p) { return winding_number(panel.ring, p) > 0; }

// True if the layout of a panel is painted at a place of the plane.
bool is_painted(const Panel& panel, Vec2 p) {
  const Vec2 uv = roads::uv_at(panel.frame, p);
  return std::ranges::any_of(roads::marks_of(panel.layout), [&](const roads::Mark& mark) {
    Vec2 at = uv;
    if (mark.ring.size() == 4) at.y = std::clamp(at.y, 0.01, roads::kLayoutLength_m - 0.01);
    return winding_number(mark.ring, at) != 0;
  });
}

// Places in the middle of unbroken lines, away from their ends.
std::vector<Vec2> places_on_lines(const Pitch& pitch) {
  std::vector<Vec2> places;
  for (const PitchLine& line : lines_of(pitch))
    for (std::size_t i = 0; line.dash_m == 0 && !line.is_disc && i + 1 < line.path.size(); ++i)
      for (const double share : {0.05, 0.31, 0.5, 0.77})
        places.push_back(frame_of(pitch).in_plane(line.path[i] + (line.path[i + 1] - line.path[i]) * share));
  return places;
}

TEST(Panels, EveryPlaceOfALineIsPaintedOnAllPanelsAboutIt) {
  for (const PitchKind kind :
       {PitchKind::kSoccer, PitchKind::kTennis, PitchKind::kBasketball, PitchKind::kHandball, PitchKind::kHockey})
    for (const double tolerance_m : {0.03, 0.1}) {
      const Pitch pitch = turned_pitch(kind);
      const std::vector<Panel> panels = panels_of(pitch, kGrass, tolerance_m);
      for (const Vec2 place : places_on_lines(pitch)) {
        int about = 0;
        for (const Panel& panel : panels) {
          if (!is_in(panel, place)) continue;
          ++about;
          EXPECT_TRUE(is_painted(panel, place)) << rules_of(kind).name;
        }
        EXPECT_GT(about, 0) << rules_of(kind).name;
      }
    }
}

TEST(Panels, PitchesOfOtherSizesShareLayouts) {
  std::set<roads::MarkingLayout> layouts;
  std::size_t of_first = 0;
  for (const double scale : {1.0, 0.97, 0.93, 0.9}) {
    for (const Panel& panel : panels_of(turned_pitch(PitchKind::kSoccer, scale), kGrass, 0.03))
      layouts.insert(roads::canonical_layout(panel.layout).layout);
    if (of_first == 0) of_first = layouts.size();
  }
  EXPECT_LT(of_first, 40u);
  EXPECT_LT(layouts.size(), of_first + of_first / 2);
}

TEST(Panels, ArcsShareOneLayout) {
  const std::vector<Panel> panels = panels_of(turned_pitch(PitchKind::kSoccer), kGrass, 0.03);
  std::set<roads::MarkingLayout> layouts;
  for (const Panel& panel : panels) layouts.insert(panel.layout);
  EXPECT_LT(layouts.size(), panels.size() / 2);
}

TEST(Panels, ACrossingPanelIsNoLongerThanALayout) {
  for (std::size_t i = 0; i < pitch_rules().size(); ++i)
    for (const Panel& panel : panels_of(turned_pitch(static_cast<PitchKind>(i)), kGrass, 0.1)) {
      if (panel.layout.panel.size() == 1 && panel.layout.panel.front().ring.size() == 4) continue;
      EXPECT_LE(panel.frame.end.left_along_m, roads::kLayoutLength_m) << pitch_rules()[i].name;
    }
}

TEST(Panels, PanelsAreClippedToTheirArea) {
  const Pitch pitch = turned_pitch(PitchKind::kTennis, 1, 0);
  const Panel panel = panels_of(pitch, kGrass, 0.1).front();
  const Box2 box = box_of(panel.ring);
  const Vec2 middle = box.centre();
  const Ring around = {{-900, -900}, {900, -900}, {900, 900}, {-900, 900}};
  EXPECT_EQ(rings_within(panel, {around}), std::vector<Ring>{panel.ring});
  const Ring half = {{-900, -900}, {middle.x, -900}, {middle.x, 900}, {-900, 900}};
  const std::vector<Ring> left = rings_within(panel, {half});
  ASSERT_EQ(left.size(), 1u);
  EXPECT_NEAR(signed_area_m2(left[0]), signed_area_m2(panel.ring) / 2, 0.02);
  EXPECT_TRUE(rings_within(panel, {{{-900, -900}, {-800, -900}, {-800, -800}}}).empty());
}

}  // namespace
}  // namespace citykiln::pitches
