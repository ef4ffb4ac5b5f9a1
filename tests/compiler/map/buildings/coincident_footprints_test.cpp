#include "compiler/map/buildings/coincident_footprints.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

// Ids of the footprints that are left, and the number of those left out.
struct Left {
  std::vector<std::int64_t> ids;
  std::uint64_t dropped = 0;
  std::vector<double> begin_m{};
  bool operator==(const Left&) const = default;
};

Left left_of_map(const std::string& text) {
  Report report;
  Left left;
  for (const Footprint& f : features_of(text, report).footprints) {
    left.ids.push_back(f.id.osm.id);
    left.begin_m.push_back(f.min_height_m);
  }
  EXPECT_TRUE(report.balances());
  left.dropped = report.counts()[Code::kDuplicateBuilding];
  return left;
}

TEST(CoincidentFootprints, OfEqualOutlinesTheOneWithHeightsIsLeft) {
  EXPECT_EQ(left_of_map("a1 0:0 20:0 20:10 0:10 building=yes\na2 0:0 20:0 20:10 0:10 building=yes height=9"),
            (Left{{2}, 1, {0}}));
  EXPECT_EQ(left_of_map("a5 0:0 20:0 20:10 0:10 building=yes\na4 0:0 20:0 20:10 0:10 building=yes"),
            (Left{{4}, 1, {0}}));
}

TEST(CoincidentFootprints, NearlyEqualOutlinesCount) {
  EXPECT_EQ(
      left_of_map("a1 0:0 20:0 20:10 0:10 building=yes\na2 0:0.25 10:0 20:0.25 20:10.25 0:10 building=yes").dropped,
      1u);
  EXPECT_EQ(left_of_map("a1 0:0 20:0 20:10 0:10 building=yes\na2 0:0 20:0 20:12 0:12 building=yes").dropped, 0u);
}

TEST(CoincidentFootprints, PartsAboveEachOtherStay) {
  EXPECT_EQ(left_of_map("a1 0:0 20:0 20:10 0:10 building=yes\n"
                        "a2 0:0 20:0 20:10 0:10 building:part=yes height=10\n"
                        "a3 0:0 20:0 20:10 0:10 building:part=yes height=30 min_height=10")
                .dropped,
            0u);
}

}  // namespace
}  // namespace citykiln::map
