#include "compiler/regions/region_file.h"

#include <gtest/gtest.h>

#include <osmium/builder/attr.hpp>
#include <osmium/memory/buffer.hpp>
#include <osmium/osm/object.hpp>
#include <vector>

namespace citykiln::regions {
namespace {

using namespace osmium::builder::attr;

// A box of 1000 x 1000 m, whose degrees are as long as 10 km.
constexpr Box2 kOwn_deg{{0, 0}, {0.1, 0.1}};
constexpr double kOwn_m2 = 1e6;

class Elements {
 public:
  void add_square(int id, double west, double south, double side, const char* key, const char* value) {
    const double east = west + side, north = south + side;
    osmium::builder::add_way(
        buffer_, _id(id), _tag(key, value),
        _nodes({{1, {west, south}}, {2, {east, south}}, {3, {east, north}}, {4, {west, north}}, {1, {west, south}}}));
  }
  void add_multipolygon(int id, int outer, int inner) {
    osmium::builder::add_relation(buffer_, _id(id), _tag("type", "multipolygon"), _tag("natural", "wood"),
                                  _member(osmium::item_type::way, outer, "outer"),
                                  _member(osmium::item_type::way, inner, "inner"));
  }
  RegionFile contents() const {
    std::vector<const osmium::OSMObject*> sorted;
    for (const osmium::OSMObject& object : buffer_.select<osmium::OSMObject>()) sorted.push_back(&object);
    return contents_of(sorted, kOwn_deg, kOwn_m2);
  }

 private:
  osmium::memory::Buffer buffer_{4096, osmium::memory::Buffer::auto_grow::yes};
};

TEST(RegionFile, CountsTreesOfTheWoodWithinTheRegion) {
  Elements elements;
  elements.add_square(1, -0.05, 0, 0.1, "natural", "wood");                       // half of it lies west
  EXPECT_NEAR(static_cast<double>(elements.contents().own_trees), 50 * 120, 60);  // 50 hectares of 120 trees
  EXPECT_EQ(elements.contents().own_plantings, 0u);
}

TEST(RegionFile, CountsNoTreesInTheHolesOfAMultipolygon) {
  Elements elements;
  elements.add_square(1, 0, 0, 0.1, "note", "");
  elements.add_square(2, 0.025, 0.025, 0.05, "note", "");
  elements.add_multipolygon(1, 1, 2);
  EXPECT_NEAR(static_cast<double>(elements.contents().own_trees), 75 * 120, 200);
}

TEST(RegionFile, CountsThePlantsOfMeadowsApart) {
  Elements elements;
  elements.add_square(1, 0, 0, 0.01, "landuse", "meadow");
  EXPECT_NEAR(static_cast<double>(elements.contents().own_plantings), 1e4, 1e3);
  EXPECT_EQ(elements.contents().own_trees, 0u);
}

TEST(RegionFile, CountsNodesWithinTheRegionByTheirWays) {
  Elements elements;
  elements.add_square(1, 0.05, 0, 0.1, "building", "yes");  // two corners lie east; the first is there twice
  elements.add_square(2, 0.2, 0, 0.1, "highway", "service");
  const RegionFile file = elements.contents();
  EXPECT_EQ(file.ways, 2u);
  EXPECT_EQ(file.way_nodes, 10u);
  EXPECT_EQ(file.own_way_nodes, 3u);
  EXPECT_EQ(file.own_building_nodes, 3u);
  EXPECT_EQ(file.own_road_nodes, 0u);
}

}  // namespace
}  // namespace citykiln::regions
