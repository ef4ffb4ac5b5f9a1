// Parcels of random land, which has the properties of parcels whatever lies in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/segment.h"
#include "tests/compiler/parcels/made_land.h"

namespace citykiln::parcels {
namespace {

void expect_of_seeds(std::uint64_t first, std::uint64_t count) {
  std::size_t lots = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const Land land = random_land(seed, 300);
    const Parcels parcels = divide(land, 1);
    expect_properties(land, parcels, "seed " + std::to_string(seed));
    lots += parcels.lots.size();
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(lots, 10 * count);
}

// The parts of lots that do not depend on indices, by id.
using ById = std::map<StableId, std::pair<Polygon, std::vector<StableId>>>;

ById by_id(const Land& land, const Parcels& parcels) {
  ById lots;
  for (const Lot& lot : parcels.lots) {
    std::vector<StableId> footprints;
    for (const std::uint32_t f : lot.footprints) footprints.push_back(land.footprints[f].id);
    std::ranges::sort(footprints);
    lots[lot.id] = {lot.polygon, footprints};
  }
  return lots;
}

Box2 box_of_lot(const Polygon& polygon) { return box_of(polygon.outer); }

TEST(RandomLand, HasTheProperties) { expect_of_seeds(1, 200); }
TEST(RandomLandFull, HasTheProperties) { expect_of_seeds(1000, 10000); }

TEST(RandomLand, TheOrderOfElementsDoesNotMatter) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Land land = random_land(seed, 300);
    Land other = land;
    std::ranges::reverse(other.lines);
    std::ranges::reverse(other.taken);
    std::ranges::rotate(other.footprints,
                        other.footprints.begin() + static_cast<std::ptrdiff_t>(other.footprints.size() / 3));
    const Parcels a = divide(land, 1), b = divide(other, 2);
    EXPECT_EQ(by_id(land, a), by_id(other, b)) << seed;
    ASSERT_EQ(a.blocks.size(), b.blocks.size());
    for (std::size_t i = 0; i < a.blocks.size(); ++i) EXPECT_EQ(a.blocks[i].polygon, b.blocks[i].polygon);
    EXPECT_EQ(a.rest, b.rest);
  }
}

// Another town east of a line replaces what was there: lots farther than the radius west of it keep every bit.
TEST(RandomLand, ALotDependsOnWhatIsWithinTheRadius) {
  constexpr double kLine_m = 900;
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Land land = random_land(seed, 1200);
    Land other = land;
    const Land east = random_land(seed + 500, 1200);
    const auto is_east = [](const Ring& points) { return box_of(points).min.x > kLine_m; };
    std::erase_if(other.lines, [&](const Line& line) { return is_east(line.axis); });
    std::erase_if(other.footprints, [&](const Footprint& f) { return is_east(f.ring); });
    std::erase_if(other.taken, [&](const Polygon& p) { return is_east(p.outer); });
    for (Line line : east.lines)
      if (is_east(line.axis))
        line.id = StableId{static_cast<std::uint64_t>(line.id) + 100000}, other.lines.push_back(line);
    for (Footprint f : east.footprints)
      if (is_east(f.ring)) f.id = StableId{static_cast<std::uint64_t>(f.id) + 100000}, other.footprints.push_back(f);
    other.extent.max.x += 77;
    const ById before = by_id(land, divide(land, 1)), after = by_id(other, divide(other, 1));
    const auto is_far = [](const Polygon& p) { return box_of_lot(p).max.x + kInfluenceRadius_m < kLine_m; };
    for (const auto& [id, lot] : before)
      if (is_far(lot.first)) {
        ++compared;
        ASSERT_TRUE(after.contains(id)) << seed;
        EXPECT_EQ(lot, after.at(id)) << seed;
      }
    for (const auto& [id, lot] : after) EXPECT_TRUE(!is_far(lot.first) || before.contains(id)) << seed;
  }
  EXPECT_GT(compared, 100u);
}

}  // namespace
}  // namespace citykiln::parcels
