#include "compiler/buildings/lit_windows.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "compiler/map/buildings/building_classes.h"

namespace citykiln::buildings {
namespace {

// A slab of flats or offices, with a window every 2.4 m on both of its long sides.
Building slab(Use use, std::int64_t id) {
  Building b;
  b.id = {{OsmType::kWay, id}, 0};
  b.footprint = {{{0, 0}, {60, 0}, {60, 12}, {0, 12}}, {}};
  b.top_m = 18, b.levels = 6;
  b.style = use == Use::kHome ? Style::kPanelBlock : Style::kOfficeSlab;
  return b;
}

grammars::Shape window_at(Vec3 middle) {
  grammars::Shape shape;
  shape.scope.size_m = {1.2, 1.4, 0};
  shape.scope.axis = {Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, -1, 0}};
  shape.scope.origin = middle - Vec3{0.6, 0, 0.7};
  return shape;
}

std::vector<grammars::Shape> windows() {
  std::vector<grammars::Shape> all;
  for (int storey = 0; storey < 6; ++storey)
    for (int i = 0; i < 25; ++i)
      for (const double y : {0.0, 12.0}) all.push_back(window_at({1.2 + 2.4 * i, y, 3.0 * storey + 1.6}));
  return all;
}

constexpr WeekTime wednesday(double hour) { return {48 + hour}; }

double lit_of_many(Use use, WeekTime time) {
  const std::vector<grammars::Shape> all = windows();
  double lit = 0;
  constexpr int kBuildings = 60;
  for (std::int64_t id = 1; id <= kBuildings; ++id) {
    const Building building = slab(use, id);
    EXPECT_EQ(use_of(building), use);
    const grammars::AnswerContextQuery is_lit = lit_windows(building, time, 5);
    for (const grammars::Shape& window : all) lit += is_lit(grammars::ContextQuery::kIsLit, window);
  }
  return lit / static_cast<double>(kBuildings * all.size());
}

TEST(LitWindows, AreTheShareOfTheTable) {
  for (const Use use : {Use::kHome, Use::kOffice})
    for (const double hour : {1.0, 18.0, 21.0}) {
      // habits smooth the curve
      double share = 0;
      for (int i = -5; i <= 5; ++i) share += lit_window_share(use, wednesday(hour + 0.15 * i)) / 11;
      EXPECT_NEAR(lit_of_many(use, wednesday(hour)), share, 0.03) << static_cast<int>(use) << " at " << hour;
    }
}

TEST(LitWindows, OfFlatsThinOutOverTheEveningAndOfOfficesBefore) {
  const double flats[] = {lit_of_many(Use::kHome, wednesday(18)), lit_of_many(Use::kHome, wednesday(22.5)),
                          lit_of_many(Use::kHome, wednesday(25))};
  EXPECT_GT(flats[0], 0.3);
  EXPECT_LT(flats[1], 0.85 * flats[0]);
  EXPECT_LT(flats[2], 0.3 * flats[0]);
  EXPECT_LT(lit_of_many(Use::kOffice, wednesday(21)), 0.5 * lit_of_many(Use::kOffice, wednesday(17)));
  // on Sunday they are dark
  EXPECT_LT(lit_of_many(Use::kOffice, {6 * 24 + 17}), 0.25 * lit_of_many(Use::kOffice, wednesday(17)));
}

// The minutes after 17:00 at which windows change.
std::vector<std::vector<int>> changes(const Building& building, int minutes) {
  const std::vector<grammars::Shape> all = windows();
  std::vector<std::vector<int>> changed(all.size());
  std::vector<bool> before(all.size());
  for (int minute = 0; minute <= minutes; ++minute) {
    const grammars::AnswerContextQuery is_lit = lit_windows(building, wednesday(17 + minute / 60.0), 5);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool now = is_lit(grammars::ContextQuery::kIsLit, all[i]);
      if (minute > 0 && now != before[i]) changed[i].push_back(minute);
      before[i] = now;
    }
  }
  return changed;
}

// From 17:00 to 2:00 the share rises once and falls once.
TEST(LitWindows, HaveOneHistoryOverAnEvening) {
  std::size_t switched = 0;
  for (std::int64_t id = 1; id <= 5; ++id)
    for (const std::vector<int>& of_window : changes(slab(Use::kHome, id), 540)) {
      EXPECT_LE(of_window.size(), 2u);
      switched += !of_window.empty();
    }
  EXPECT_GT(switched, 400u);
}

TEST(LitWindows, OfOneFlatSwitchTogether) {
  const Building building = slab(Use::kHome, 3);
  std::map<std::vector<int>, int> histories;
  int windows = 0;
  for (const std::vector<int>& of_window : changes(building, 540))
    if (!of_window.empty()) ++histories[of_window], ++windows;
  // 60 m by 12 m by 6 storeys are at most 8 by 3 by 6 flats; a flat has up to eight windows, of which half are lit
  EXPECT_GT(windows, 60);
  EXPECT_LT(histories.size(), 100u);
  EXPECT_GT(windows, 1.5 * static_cast<double>(histories.size()));
}

TEST(LitShare, IsContinuousOverTheWeekAndTheSameAWeekLater) {
  for (int use = 0; use < static_cast<int>(Use::kCount); ++use)
    for (double hours = 0; hours < 168; hours += 0.05) {
      const double share = lit_share(static_cast<Use>(use), {hours});
      EXPECT_TRUE(share >= 0 && share <= 1);
      EXPECT_LT(std::abs(lit_share(static_cast<Use>(use), {hours + 0.05}) - share), 0.05) << use << " at " << hours;
      EXPECT_NEAR(lit_share(static_cast<Use>(use), {hours + 168}), share, 1e-9);
    }
}

TEST(LitWindows, HotelsAndSchoolsFollowTheirClass) {
  Building b = slab(Use::kHome, 1);
  for (const auto& [building_class, use] : {std::pair{map::BuildingClass::kHotel, Use::kHotel},
                                            {map::BuildingClass::kSchool, Use::kSchool},
                                            {map::BuildingClass::kHospital, Use::kHospital},
                                            {map::BuildingClass::kHall, Use::kIndustry},
                                            {map::BuildingClass::kApartments, Use::kHome}}) {
    b.building_class = static_cast<std::uint8_t>(building_class);
    EXPECT_EQ(use_of(b), use);
  }
}

// A house with many fronts of one kind.
Building with_fronts(map::FrontKind kind, std::optional<map::FrontHours> hours = {}) {
  Building b = slab(Use::kHome, 4);
  for (std::uint32_t i = 0; i < 20; ++i)
    b.fronts.push_back({.edge = 0, .from_m = 3.0 * i, .to_m = 3.0 * i + 3, .kind = kind, .hours = hours});
  return b;
}

int lit_fronts(const Building& b, WeekTime time) {
  int lit = 0;
  for (std::uint32_t i = 0; i < b.fronts.size(); ++i) lit += is_front_lit(b, i, time, 1);
  return lit;
}

TEST(LitFronts, AreThoseThatAreOpen) {
  const Building bars = with_fronts(map::FrontKind::kBar), offices = with_fronts(map::FrontKind::kOffice);
  EXPECT_EQ(lit_fronts(offices, wednesday(16)), 20);
  EXPECT_EQ(lit_fronts(bars, wednesday(22)), 20);
  EXPECT_LT(lit_fronts(offices, wednesday(22)), 8);
  EXPECT_EQ(lit_fronts(offices, wednesday(5)), 0);
  // Wednesday's guests, after midnight
  EXPECT_EQ(lit_fronts(bars, wednesday(25.5)), 20);
  EXPECT_EQ(lit_fronts(bars, wednesday(28)), 0);
}

TEST(LitFronts, FollowTaggedHours) {
  const Building late = with_fronts(map::FrontKind::kOffice, map::FrontHours{{72, 96, 0, 0, 0, 0}});
  EXPECT_EQ(lit_fronts(late, wednesday(23)), 20);
  EXPECT_EQ(lit_fronts(late, wednesday(9)), 0);
}

TEST(LitFronts, KeepSomeWindowsLitInTheEvening) {
  const Building banks = with_fronts(map::FrontKind::kBank);
  EXPECT_GT(lit_fronts(banks, wednesday(21)), 10);
  EXPECT_EQ(lit_fronts(banks, wednesday(23.75)), 0);
}

}  // namespace
}  // namespace citykiln::buildings
