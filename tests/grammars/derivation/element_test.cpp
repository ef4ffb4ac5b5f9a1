// Elements hold all detail of a part of a wall, and their rectangles stay within the tolerance.
#include "grammars/derivation/element.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/grammars/on_lot.h"
#include "tests/grammars/surfaces.h"

namespace citykiln::grammars {
namespace {

// A wall of windows 14 cm deep in three frames' colours.
constexpr const char* kWindowedHouse = R"(
  attr wall = "#c0b090"
  attr wide = 1.3
  Lot --> color(wall) extrude(6) comp(f) { side : Facade | all : Plain. }
  Facade --> split(x) { 1 : Wall. | { ~1 : Wall. | wide : Column | ~1 : Wall. }* | 1 : Wall. }
  Column --> split(y) { 1 : Wall. | 2 : Window | ~1 : Wall. }
  Window --> extrude(-0.14) reverseNormals() comp(f) { back : NIL | front : alignScopeToGeometry() Pane | all : Reveal. }
  Pane --> color("#ffffff") split(x) { 0.07 : Frame. | ~1 : Glass | 0.07 : Frame. }
  Glass --> 50% : color("#202020") GlassPane. else : color("#404040") GlassPane.
)";

Derivation house_with(const std::string& attribute, const Value& value, double tolerance_m, bool draws = true) {
  DeriveOptions options;
  options.tolerance_m = tolerance_m, options.keep_appearances = options.prune_early = true;
  options.draw_elements = draws;
  if (!attribute.empty()) options.attributes[attribute] = value;
  return derived(kWindowedHouse, 12, 9, options);
}

std::size_t count_of_elements(const Derivation& derivation) {
  return static_cast<std::size_t>(
      std::ranges::count_if(derivation.terminals, [](const Terminal& t) { return t.element != 0; }));
}

TEST(Element, IsOneRectangleWithAllDetailBesideIt) {
  const Derivation house = house_with("", 0.0, 0.15);
  ASSERT_GT(count_of_elements(house), 0u);
  for (const Terminal& terminal : house.terminals) {
    if (terminal.element == 0) continue;
    EXPECT_EQ(terminal.faces.size(), 1u);
    EXPECT_LE(terminal.error_m, 0.15);
    const Element& window = house.elements[terminal.element - 1];
    EXPECT_EQ(window.width_m, 1.25);  // 1.3 on a grid of 1/8 m
    EXPECT_EQ(window.height_m, 2);
    // four reveals, two frames, one pane
    EXPECT_EQ(window.faces.size(), 7u);
  }
}

// Only the pane and its frames lie within the tolerance of their rectangle.
TEST(Element, IsThePaneAloneWhereItsReliefExceedsTheTolerance) {
  const Derivation house = house_with("", 0.0, 0.1);
  ASSERT_GT(count_of_elements(house), 0u);
  for (const Element& pane : house.elements) EXPECT_EQ(pane.faces.size(), 3u);
  for (const Terminal& terminal : house.terminals)
    if (terminal.element != 0) {
      EXPECT_EQ(terminal.error_m, 0);
    }
}

// The colours of the faces that are seen straight on; reveals have the wall's, but are seen edge on.
std::vector<std::array<double, 3>> colours_seen(const Derivation& house) {
  std::vector<std::array<double, 3>> colours;
  for (const Element& element : house.elements)
    for (const ElementFace& each : element.faces) {
      const Appearance& appearance = house.appearances[each.appearance];
      if (normal_of(each.face).z > 0.5) colours.push_back({appearance.red, appearance.green, appearance.blue});
    }
  return colours;
}

TEST(Element, IsTheSameInWallsOfAllColours) {
  const Derivation one = house_with("wall", std::string("#c0b090"), 0.15),
                   other = house_with("wall", std::string("#904030"), 0.15);
  ASSERT_FALSE(colours_seen(one).empty());
  EXPECT_EQ(colours_seen(one), colours_seen(other));
}

TEST(Element, IsTheSameForNearlyEqualSizes) {
  EXPECT_EQ(house_with("wide", 1.21, 0.15).elements.front().width_m,
            house_with("wide", 1.29, 0.15).elements.front().width_m);
}

TEST(Element, IsMadeOnlyIfAskedForAndOnlyWithATolerance) {
  EXPECT_EQ(count_of_elements(house_with("", 0.0, 0.15, false)), 0u);
  EXPECT_EQ(count_of_elements(house_with("", 0.0, 0)), 0u);
  EXPECT_EQ(count_of_elements(house_with("wide", 8.0, 0.15)), 0u) << "wider than an element";
}

TEST(Element, KeepsTheWallWatertight) {
  const Derivation without = house_with("", 0.0, 0.15, false), with = house_with("", 0.0, 0.15);
  const auto area_m2 = [](const Derivation& house) {
    double sum = 0;
    for (const Terminal& terminal : house.terminals)
      for (const Face& face : terminal.faces) sum += grammars::area_m2(face);
    return sum;
  };
  // flush with the wall, all rectangles together are the wall
  EXPECT_NEAR(area_m2(with), area_m2(without), 1e-9);
}

}  // namespace
}  // namespace citykiln::grammars
