#include "compiler/map/readers/coastline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "compiler/geometry/snap.h"

namespace citykiln::map {
namespace {

const Box2 kCoastBox{{0, 0}, {128, 128}};

// Coastlines as text, one a line of places; ends in the same place are the same node.
std::vector<CoastWay> coasts(const std::string& text) {
  std::vector<CoastWay> ways;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    CoastWay way{{OsmType::kWay, static_cast<std::int64_t>(ways.size()) + 1}, {}};
    for (std::string word; words >> word;) {
      const std::size_t colon = word.find(':');
      way.axis.push_back({std::stod(word.substr(0, colon)), std::stod(word.substr(colon + 1))});
    }
    if (way.axis.empty()) continue;
    const auto node = [](Vec2 p) {
      return static_cast<std::int64_t>(p.x * 1024 + 1e6) * 10000000 + static_cast<std::int64_t>(p.y * 1024 + 1e6);
    };
    way.first_node = node(way.axis.front());
    way.last_node = node(way.axis.back());
    ways.push_back(std::move(way));
  }
  return ways;
}

// '~' sea, '.' land, by 16 m squares, north on top.
std::string picture(const Sea& sea) {
  std::string rows;
  for (int j = 7; j >= 0; --j) {
    for (int i = 0; i < 8; ++i) {
      const auto holds = [&](const Polygon& p) { return contains(p, {i * 16 + 8.0, j * 16 + 8.0}); };
      rows += std::any_of(sea.polygons.begin(), sea.polygons.end(), holds) ? '~' : '.';
    }
    rows += '\n';
  }
  return rows;
}

void expect_rings_are_oriented_and_inside(const Sea& sea) {
  for (const Polygon& polygon : sea.polygons) {
    EXPECT_GT(signed_area_m2(polygon.outer), 0);
    for (const Ring& hole : polygon.holes) EXPECT_LT(signed_area_m2(hole), 0);
    for (const Vec2 p : polygon.outer) {
      EXPECT_TRUE(kCoastBox.contains(p));
      EXPECT_EQ(p, snapped(p));
    }
  }
}

TEST(CloseSea, SeaLiesToTheRight) {
  const Sea sea = close_sea(coasts("-10:64 140:64"), kCoastBox);
  EXPECT_EQ(picture(sea), "........\n........\n........\n........\n~~~~~~~~\n~~~~~~~~\n~~~~~~~~\n~~~~~~~~\n");
  EXPECT_TRUE(sea.open_ends.empty());
  expect_rings_are_oriented_and_inside(sea);
  EXPECT_EQ(picture(close_sea(coasts("140:64 -10:64"), kCoastBox)),
            "~~~~~~~~\n~~~~~~~~\n~~~~~~~~\n~~~~~~~~\n........\n........\n........\n........\n");
}

TEST(CloseSea, WaysAreJoinedInAnyOrder) {
  const Sea whole = close_sea(coasts("-10:64 30:40 70:90 140:64"), kCoastBox);
  const Sea pieces = close_sea(coasts("70:90 140:64\n-10:64 30:40\n30:40 70:90"), kCoastBox);
  EXPECT_EQ(whole.polygons, pieces.polygons);
  EXPECT_TRUE(pieces.open_ends.empty());
}

TEST(CloseSea, TheCornerWithWaterOnTheRightIsSea) {
  EXPECT_EQ(picture(close_sea(coasts("32:-5 32:32 -5:32"), kCoastBox)),
            "~~~~~~~~\n~~~~~~~~\n~~~~~~~~\n~~~~~~~~\n~~~~~~~~\n~~~~~~~~\n..~~~~~~\n..~~~~~~\n");
  EXPECT_EQ(picture(close_sea(coasts("-5:32 32:32 32:-5"), kCoastBox)),
            "........\n........\n........\n........\n........\n........\n~~......\n~~......\n");
}

TEST(CloseSea, AStraitLiesBetweenItsTwoCoasts) {
  const Sea strait = close_sea(coasts("48:-5 48:140\n80:140 80:-5"), kCoastBox);
  std::string rows;
  for (int j = 0; j < 8; ++j) rows += "...~~...\n";
  EXPECT_EQ(picture(strait), rows);
  expect_rings_are_oriented_and_inside(strait);
  // an isthmus, the other way round
  const Sea seas = close_sea(coasts("48:140 48:-5\n80:-5 80:140"), kCoastBox);
  EXPECT_EQ(seas.polygons.size(), 2u);
  for (const Polygon& polygon : seas.polygons) EXPECT_EQ(area_m2(polygon), 48.0 * 128);
}

TEST(CloseSea, AnIslandIsAHole) {
  const Sea sea = close_sea(coasts("48:48 80:48 80:80 48:80 48:48"), kCoastBox);
  EXPECT_EQ(picture(sea), "~~~~~~~~\n~~~~~~~~\n~~~~~~~~\n~~~..~~~\n~~~..~~~\n~~~~~~~~\n~~~~~~~~\n~~~~~~~~\n");
  expect_rings_are_oriented_and_inside(sea);
}

TEST(CloseSea, IslandsAndACoastTogether) {
  const Sea sea =
      close_sea(coasts("-5:96 140:96\n16:16 32:16 32:32 16:32 16:16\n64:16 96:16 96:64\n96:64 64:64 64:16"), kCoastBox);
  EXPECT_EQ(picture(sea), "........\n........\n~~~~~~~~\n~~~~~~~~\n~~~~..~~\n~~~~..~~\n~.~~..~~\n~~~~~~~~\n");
  ASSERT_EQ(sea.polygons.size(), 1u);
  EXPECT_EQ(sea.polygons[0].holes.size(), 2u);
  EXPECT_EQ(area_m2(sea.polygons[0]), 128.0 * 96 - 16 * 16 - 32 * 48);
}

TEST(CloseSea, AnIslandThatReachesOutIsCutAtTheSides) {
  const Sea sea = close_sea(coasts("96:32 200:32 200:96 96:96 96:32"), kCoastBox);
  EXPECT_EQ(picture(sea), "~~~~~~~~\n~~~~~~~~\n~~~~~~..\n~~~~~~..\n~~~~~~..\n~~~~~~..\n~~~~~~~~\n~~~~~~~~\n");
  expect_rings_are_oriented_and_inside(sea);
}

TEST(CloseSea, ABayInsideIsASeaOfItsOwn) {
  const Sea sea = close_sea(coasts("48:48 48:80 80:80 80:48 48:48"), kCoastBox);
  EXPECT_EQ(picture(sea), "........\n........\n........\n...~~...\n...~~...\n........\n........\n........\n");
}

TEST(CloseSea, ACoastThatEndsInsideIsLedToASideAndNamed) {
  const Sea sea = close_sea(coasts("-10:64 120:64"), kCoastBox);
  EXPECT_EQ(picture(sea), "........\n........\n........\n........\n~~~~~~~~\n~~~~~~~~\n~~~~~~~~\n~~~~~~~~\n");
  EXPECT_EQ(sea.open_ends, (std::vector<OsmId>{{OsmType::kWay, 1}}));
  expect_rings_are_oriented_and_inside(sea);
}

TEST(CloseSea, WithoutACoastThereIsNoSea) { EXPECT_TRUE(close_sea({}, kCoastBox).polygons.empty()); }

TEST(CloseSea, IsTotalForInvalidCoasts) {
  std::size_t polygons = 0;
  for (const char* text : {"10:10 20:20", "-5:10 140:10\n-5:20 140:20", "0:0 128:128", "0:0 128:0",
                           "64:0 64:128\n64:128 64:0", "128:64 128:128 64:128", "10:10 20:10 10:10",
                           "-5:-5 140:140\n140:-5 -5:140", "10:10 20:10 20:20 10:10\n10:10 20:10 20:20 10:10"}) {
    const Sea sea = close_sea(coasts(text), kCoastBox);
    polygons += sea.polygons.size();
    for (const Polygon& polygon : sea.polygons)
      for (const Vec2 p : polygon.outer) EXPECT_TRUE(kCoastBox.contains(p)) << text;
  }
  EXPECT_GT(polygons, 0u);
}

}  // namespace
}  // namespace citykiln::map
