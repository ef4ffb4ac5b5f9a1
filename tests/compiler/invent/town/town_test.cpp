// Each claim is tested for many seeds: 20 of each kind here, 1,000 in TownFull.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <map>
#include <set>

#include "compiler/contract/disjoint_sets.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/ring_crossing.h"
#include "compiler/geometry/segment.h"
#include "compiler/invent/town/add_town.h"
#include "compiler/invent/town/blocks/footprints.h"
#include "compiler/invent/town/town_layout.h"
#include "tests/compiler/invent/town/made_ground.h"

namespace citykiln::invent {
namespace {

constexpr TownKind kKinds[] = {TownKind::kVillage, TownKind::kTown, TownKind::kCity};
constexpr double kTownSide_m = 480;

std::string value_of(const Tags& tags, std::string_view key) {
  for (const auto& [k, value] : tags)
    if (k == key) return value;
  return {};
}

Ground ground_of(std::uint64_t seed) { return kGrounds[seed % 4]; }

InventedMap town_of(TownKind kind, std::uint64_t seed, double side_m = kTownSide_m) {
  const Terrain terrain = made_ground(ground_of(seed), side_m);
  InventedMap map;
  add_town(terrain, {kind, side_m, seed}, map);
  return map;
}

/// A straight piece of a street, with its line's number.
struct Piece {
  Vec2 a, b;
  std::size_t line = 0;
};

std::vector<Piece> street_pieces(const InventedMap& map) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < map.lines.size(); ++i)
    if (!value_of(map.lines[i].tags, "highway").empty())
      for (std::size_t k = 0; k + 1 < map.lines[i].axis.size(); ++k)
        pieces.push_back({map.lines[i].axis[k], map.lines[i].axis[k + 1], i});
  return pieces;
}

BoxGrid grid_of_pieces(const std::vector<Piece>& pieces) {
  std::vector<Box2> boxes;
  for (const Piece& piece : pieces) boxes.push_back(box_of(std::vector{piece.a, piece.b}));
  return grid_of(boxes, 32);
}

std::vector<const Ring*> houses_of(const InventedMap& map) {
  std::vector<const Ring*> houses;
  for (const InventedArea& area : map.areas)
    if (!value_of(area.tags, "building").empty()) houses.push_back(&area.polygon.outer);
  return houses;
}

// the corners of a ring, moved into it by 0.15 m or more; those at which that is not towards the middle are left out
std::vector<Vec2> points_inside(const Ring& ring) {
  const Vec2 middle = centroid(Polygon{ring, {}});
  std::vector<Vec2> points;
  for (const Vec2 corner : ring) {
    const Vec2 p = corner + unit(middle - corner) * 0.4;
    if (winding_number(ring, p) != 0 && distance_to_ring(ring, p) > 0.15) points.push_back(p);
  }
  return points;
}

// ---- claims about one map

void expect_connected(const InventedMap& map) {
  std::map<Vec2, std::uint32_t> numbers;
  DisjointSets parts;
  const auto number = [&](Vec2 p) {
    const auto [at, is_new] = numbers.try_emplace(p, static_cast<std::uint32_t>(numbers.size()));
    if (is_new) parts.add();
    return at->second;
  };
  for (const Piece& piece : street_pieces(map)) parts.join(number(piece.a), number(piece.b));
  const std::vector<std::uint32_t> lowest = parts.lowest();
  EXPECT_EQ(std::set<std::uint32_t>(lowest.begin(), lowest.end()).size(), 1u);
}

void expect_nodes_at_crossings(const InventedMap& map) {
  const std::vector<Piece> pieces = street_pieces(map);
  const BoxGrid grid = grid_of_pieces(pieces);
  for (std::uint32_t i = 0; i < pieces.size(); ++i)
    for (const std::uint32_t j : boxes_about(grid, box_of(std::vector{pieces[i].a, pieces[i].b}))) {
      const Piece &s = pieces[i], &t = pieces[j];
      if (j <= i || s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b) continue;
      EXPECT_FALSE(crossing_shares(s.a, s.b, t.a, t.b))
          << s.a.x << " " << s.a.y << ": " << value_of(map.lines[s.line].tags, "highway") << " and "
          << value_of(map.lines[t.line].tags, "highway");
    }
}

void expect_houses_off_streets(const InventedMap& map) {
  const std::vector<Piece> pieces = street_pieces(map);
  const BoxGrid grid = grid_of_pieces(pieces);
  for (const Ring* house : houses_of(map))
    for (const std::uint32_t i : boxes_about(grid, box_of(*house))) {
      const Piece& piece = pieces[i];
      EXPECT_EQ(winding_number(*house, (piece.a + piece.b) * 0.5), 0) << piece.a.x << " " << piece.a.y;
      for (std::size_t k = 0; k < house->size(); ++k)
        EXPECT_FALSE(crossing_shares(piece.a, piece.b, (*house)[k], (*house)[(k + 1) % house->size()]))
            << piece.a.x << " " << piece.a.y;
    }
}

void expect_houses_dry(const InventedMap& map, const Terrain& terrain) {
  for (const Ring* house : houses_of(map))
    for (const Vec2 p : *house) EXPECT_FALSE(terrain.is_water(p)) << p.x << " " << p.y;
}

void expect_houses_apart(const InventedMap& map) {
  const std::vector<const Ring*> houses = houses_of(map);
  if (houses.empty()) return;
  std::vector<Box2> boxes;
  for (const Ring* house : houses) boxes.push_back(box_of(*house));
  const BoxGrid grid = grid_of(boxes, 32);
  for (std::uint32_t i = 0; i < houses.size(); ++i) {
    EXPECT_TRUE(is_simple(*houses[i]));
    for (const std::uint32_t j : boxes_about(grid, boxes[i])) {
      if (j == i) continue;
      for (const Vec2 p : points_inside(*houses[i])) EXPECT_EQ(winding_number(*houses[j], p), 0) << p.x << " " << p.y;
    }
  }
}

void expect_sound(TownKind kind, std::uint64_t seed) {
  SCOPED_TRACE("kind " + std::to_string(static_cast<int>(kind)) + ", seed " + std::to_string(seed));
  const InventedMap map = town_of(kind, seed);
  expect_connected(map);
  expect_nodes_at_crossings(map);
  expect_houses_off_streets(map);
  expect_houses_dry(map, made_ground(ground_of(seed), kTownSide_m));
  expect_houses_apart(map);
}

void expect_sound_lots(TownKind kind, std::uint64_t seed) {
  SCOPED_TRACE("kind " + std::to_string(static_cast<int>(kind)) + ", seed " + std::to_string(seed));
  const Terrain terrain = made_ground(ground_of(seed), kTownSide_m);
  const TownPlan plan = plan_town(terrain, {kind, kTownSide_m, seed});
  const TownLayout layout = lay_out_town(plan);
  EXPECT_FALSE(layout.lots.lots.empty());
  for (const TownLot& lot : layout.lots.lots) {
    EXPECT_TRUE(is_simple(lot.ring));
    EXPECT_GT(lot.frontage_m(), 3);
    for (const Vec2 p : lot.ring) EXPECT_FALSE(terrain.is_water(p));
  }
}

// true if the corners of a house lie in one lot, or in none
bool is_in_one_lot(const Ring& house, const std::vector<TownLot>& lots) {
  const std::vector<Vec2> corners = points_inside(house);
  for (const TownLot& lot : lots) {
    const auto count = std::ranges::count_if(corners, [&](Vec2 p) { return winding_number(lot.ring, p) != 0; });
    if (count > 0) return count == static_cast<std::ptrdiff_t>(corners.size());
  }
  return true;
}

// ---- towns

TEST(Town, IsSoundFor20SeedsOfEachKind) {
  for (const TownKind kind : kKinds)
    for (std::uint64_t seed = 1; seed <= 20; ++seed) expect_sound(kind, seed);
}

TEST(Town, LotsAreSimpleDryAndHaveAFront) {
  for (const TownKind kind : kKinds)
    for (std::uint64_t seed = 1; seed <= 8; ++seed) expect_sound_lots(kind, seed);
}

TEST(Town, NoHouseLiesAcrossTheBorderOfItsLot) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const Terrain terrain = made_ground(ground_of(seed), kTownSide_m);
    const TownLayout layout = lay_out_town(plan_town(terrain, {TownKind::kTown, kTownSide_m, seed}));
    const InventedMap map = town_of(TownKind::kTown, seed);
    for (const Ring* house : houses_of(map)) EXPECT_TRUE(is_in_one_lot(*house, layout.lots.lots)) << (*house)[0].x;
  }
}

TEST(Town, TheSameSeedGivesTheSameTownAtAnyNumberOfThreads) {
  const auto text_of = [](int threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    const InventedMap map = town_of(TownKind::kCity, 7);
    std::vector<Vec2> places;
    std::string text;
    for (const InventedPoint& point : map.points) places.push_back(point.position);
    for (const InventedLine& line : map.lines) places.insert(places.end(), line.axis.begin(), line.axis.end());
    for (const InventedArea& area : map.areas) {
      places.insert(places.end(), area.polygon.outer.begin(), area.polygon.outer.end());
      for (const auto& [key, value] : area.tags) text += key + "=" + value + " ";
    }
    return std::pair(places, text);
  };
  const auto once = text_of(1);
  EXPECT_EQ(once, text_of(7));
  EXPECT_FALSE(once.first.empty());
}

TEST(Town, AnotherSeedGivesAnotherTown) {
  const InventedMap one = town_of(TownKind::kTown, 4), other = town_of(TownKind::kTown, 8);
  EXPECT_NE(one.lines.front().axis, other.lines.front().axis);
}

double mean_storeys(const InventedMap& map) {
  double sum = 0, count = 0;
  for (const InventedArea& area : map.areas)
    if (const std::string storeys = value_of(area.tags, "building:levels");
        !storeys.empty() && !value_of(area.tags, "addr:housenumber").empty()) {
      sum += std::stod(storeys);
      ++count;
    }
  return count > 0 ? sum / count : 0;
}

TEST(Town, CitiesAreHigherThanTownsAndTownsThanVillages) {
  const double village = mean_storeys(town_of(TownKind::kVillage, 4, 700));
  const double town = mean_storeys(town_of(TownKind::kTown, 4, 700));
  const double city = mean_storeys(town_of(TownKind::kCity, 4, 700));
  EXPECT_LT(village, town);
  EXPECT_LT(town + 0.5, city);
}

TEST(Town, RoadsCrossWaterOnBridges) {
  const Terrain terrain = made_ground(Ground::kRiver, kTownSide_m);
  for (const std::uint64_t seed : {3, 7, 11})
    for (const InventedLine& line : town_of(TownKind::kTown, seed).lines) {
      if (value_of(line.tags, "highway").empty() || !value_of(line.tags, "bridge").empty()) continue;
      for (const Vec2 p : line.axis) EXPECT_FALSE(terrain.is_water(p)) << p.x << " " << p.y;
    }
}

TEST(Town, HouseNumbersAreOddOnOneSideAndUniqueInAStreet) {
  std::set<std::pair<std::string, std::string>> addresses;
  std::size_t houses = 0;
  for (const InventedArea& area : town_of(TownKind::kTown, 5).areas)
    if (const std::string number = value_of(area.tags, "addr:housenumber"); !number.empty()) {
      ++houses;
      EXPECT_TRUE(addresses.insert({value_of(area.tags, "addr:street"), number}).second) << number;
    }
  EXPECT_GT(houses, 50u);
}

TEST(TownFull, IsSoundFor1000SeedsOfEachKind) {
  for (const TownKind kind : kKinds)
    for (std::uint64_t seed = 21; seed <= 1020; ++seed) expect_sound(kind, seed);
}

}  // namespace
}  // namespace citykiln::invent
