#include "compiler/people/people.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "compiler/things/facing.h"

namespace citykiln::people {
namespace {

using map::LandCoverClass;
using map::LaneDirection;
using map::LaneKind;

ground::LandCoverPolygon cover_of(std::int64_t id, const Box2& box, LandCoverClass surface) {
  return {{{OsmType::kWay, id}, 0}, surface, 0, {{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}}};
}

// A street along y = 0 with a pavement of 4 m on its left, and houses behind it.
struct MadeStreet {
  std::vector<roads::Road> roads = {street()};
  std::vector<ground::LandCoverPolygon> cover = {cover_of(7, {{0, -3}, {1000, 3}}, LandCoverClass::kResidentialRoad),
                                                 cover_of(7, {{0, 3}, {1000, 7}}, LandCoverClass::kPavement),
                                                 cover_of(8, {{0, 7}, {1000, 20}}, LandCoverClass::kBuilding)};
  std::vector<buildings::Building> buildings{};
  std::vector<Solid> solids{};

  static roads::Road street() {
    roads::Road road;
    road.id = {{OsmType::kWay, 7}, 0};
    road.axis = {{0, 0}, {1000, 0}};
    road.surface = LandCoverClass::kResidentialRoad;
    road.section.lanes = {{LaneKind::kSidewalk, LaneDirection::kBoth, 4, 0, true},
                          {LaneKind::kDriving, LaneDirection::kBackward, 3},
                          {LaneKind::kDriving, LaneDirection::kForward, 3}};
    road.section.axis_offset_m = 3;  // from the carriageway's left edge
    return road;
  }

  void add_shops() {
    buildings::Building shops;
    shops.id = {{OsmType::kWay, 8}, 0};
    shops.footprint.outer = {{0, 7}, {1000, 7}, {1000, 20}, {0, 20}};
    for (double at_m = 0; at_m < 990; at_m += 10) shops.fronts.push_back({.edge = 0, .from_m = at_m, .to_m = at_m + 8});
    buildings.push_back(shops);
  }

  std::vector<things::Thing> people(const Box2& box, PeopleShare share, std::uint64_t seed = 1,
                                    buildings::WeekTime time = {60}) const {
    const ground::LandCoverIndex index = ground::index_land_cover(cover, box.widened(48));
    return people_in(life(index), wish(share, seed, time), box);
  }
  std::vector<Spot> spots(const Box2& box) const {
    const ground::LandCoverIndex index = ground::index_land_cover(cover, box.widened(48));
    return spots_in(life(index), wish(kUsualPeople, 1, {60}), box);
  }

 private:
  StreetLife life(const ground::LandCoverIndex& index) const {
    return {.roads = roads,
            .junctions = {},
            .buildings = buildings,
            .trunks = {},
            .barriers = {},
            .solids = solids,
            .land_cover = index};
  }
  static PeopleWish wish(PeopleShare share, std::uint64_t seed, buildings::WeekTime time) {
    return {.share = share, .time = time, .season = Season::kWarm, .country = {}, .seed = seed, .tile_m = 256};
  }
};

const Box2 kWholeStreet{{-64, -64}, {1100, 64}};

TEST(People, StandOnThePavementAlone) {
  const MadeStreet street;
  const std::vector<things::Thing> people = street.people(kWholeStreet, {.share = 1});
  EXPECT_GT(people.size(), 200u);
  for (const things::Thing& person : people) {
    EXPECT_GE(person.at.y, 3 + kPersonRadius_m - 0.01);
    EXPECT_LE(person.at.y, 7 - kPersonRadius_m + 0.01);
  }
}

TEST(People, AreApart) {
  const std::vector<things::Thing> people = MadeStreet().people(kWholeStreet, {.share = 1});
  for (std::size_t i = 0; i < people.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) EXPECT_GE(distance(people[i].at, people[k].at), 0.5);
}

TEST(People, AreMoreBeforeShopsAndByDay) {
  MadeStreet homes, shops;
  shops.add_shops();
  std::size_t of_homes = 0, of_shops = 0, at_night = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    of_homes += homes.people(kWholeStreet, kUsualPeople, seed).size();
    of_shops += shops.people(kWholeStreet, kUsualPeople, seed).size();
    at_night += shops.people(kWholeStreet, kUsualPeople, seed, {51}).size();
  }
  EXPECT_GT(of_shops, 3 * of_homes);
  EXPECT_GT(of_homes, 20 * 8u);
  EXPECT_LT(at_night, of_shops / 10);
}

TEST(People, AreNobodyUnlessAskedFor) { EXPECT_TRUE(MadeStreet().people(kWholeStreet, kNobody).empty()); }

TEST(People, AreInOneTileEach) {
  MadeStreet street;
  street.add_shops();
  std::vector<Vec2> whole, parts;
  for (const things::Thing& person : street.people(kWholeStreet, {.share = 0.5})) whole.push_back(person.at);
  for (double x = -64; x < 1100; x += 194)
    for (const things::Thing& person : street.people({{x, -64}, {x + 194, 64}}, {.share = 0.5}))
      parts.push_back(person.at);
  std::ranges::sort(whole), std::ranges::sort(parts);
  EXPECT_EQ(parts, whole);
}

TEST(People, AreThoseOfTheWholeWayOnATrimmedOne) {
  MadeStreet whole, trimmed;
  trimmed.roads[0].axis = {{200, 0}, {1000, 0}}, trimmed.roads[0].start_along_m = 200;
  const Box2 box{{300, -64}, {500, 64}};
  EXPECT_EQ(whole.people(box, {.share = 0.5}), trimmed.people(box, {.share = 0.5}));
}

TEST(People, KeepOutOfThings) {
  MadeStreet street;
  for (double x = 2; x < 1000; x += 5)
    street.solids.push_back({.at = {x, 4.5}, .right = {1, 0}, .width_m = 2, .depth_m = 1});
  const std::vector<things::Thing> people = street.people(kWholeStreet, {.share = 1});
  EXPECT_GT(people.size(), 50u);
  for (const things::Thing& person : people)
    for (const Solid& solid : street.solids) {
      const Vec2 off = person.at - solid.at;
      EXPECT_FALSE(std::abs(off.x) < 1 && std::abs(off.y) < 0.5);
    }
}

TEST(People, WalkAlongTheStreetOrLookAtItsSides) {
  std::size_t along = 0;
  const std::vector<things::Thing> people = MadeStreet().people(kWholeStreet, {.share = 1});
  for (const things::Thing& person : people) along += std::abs(things::unit_vector(person.direction).x) > 0.9;
  EXPECT_GT(along, people.size() * 3 / 4);
  EXPECT_LT(along, people.size());
}

TEST(People, SitOnBenchesAndWaitAtStops) {
  MadeStreet street;
  street.solids = {{.at = {100, 5}, .right = {-1, 0}, .width_m = 1.8, .depth_m = 0.65, .is_seat = true},
                   {.at = {200, 4}, .right = {-1, 0}, .width_m = 0.5, .depth_m = 0.2, .is_stop = true}};
  int sitting = 0, waiting = 0;
  for (const Spot& spot : street.spots(kWholeStreet)) {
    sitting += spot.use == SpotUse::kSeat, waiting += spot.use == SpotUse::kStop;
    if (spot.use == SpotUse::kSeat) {
      EXPECT_EQ(spot.towards, (Vec2{0, 1})) << "to the right of its right side";
    }
  }
  EXPECT_EQ(sitting, 2);
  EXPECT_EQ(waiting, 6);
  std::set<double> seats;
  for (const things::Thing& person : street.people(kWholeStreet, {.share = 1}))
    if (look_of(*body_of(person.form), 1).pose == Pose::kSit) seats.insert(person.at.x);
  EXPECT_EQ(seats.size(), 2u);
}

TEST(People, WalkOnPathsAndSquares) {
  MadeStreet town;
  roads::Road path;
  path.id = {{OsmType::kWay, 9}, 0}, path.axis = {{0, 40}, {400, 40}}, path.surface = LandCoverClass::kPavedFootPath;
  path.section.lanes = {{LaneKind::kDriving, LaneDirection::kBoth, 2.5}}, path.section.axis_offset_m = 1.25;
  town.roads = {path};
  town.cover = {cover_of(10, {{0, 30}, {400, 50}}, LandCoverClass::kPark),
                cover_of(9, {{0, 38.75}, {400, 41.25}}, LandCoverClass::kPavedFootPath),
                cover_of(11, {{500, 0}, {540, 40}}, LandCoverClass::kSquare)};
  std::size_t parks = 0, squares = 0;
  for (const Spot& spot : town.spots(kWholeStreet))
    parks += spot.use == SpotUse::kPark, squares += spot.use == SpotUse::kSquare;
  EXPECT_NEAR(static_cast<double>(parks), 66, 2);
  EXPECT_NEAR(static_cast<double>(squares), 90, 20);
}

}  // namespace
}  // namespace citykiln::people
