#include "compiler/fields/add_fields.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/contract/derived_id.h"

namespace citykiln::fields {
namespace {

using map::LandCoverClass;

Ring square_of(Vec2 low, Vec2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

map::AreaFeature area(std::int64_t id, LandCoverClass surface, Ring outer) {
  const double own_m2 = signed_area_m2(outer);
  return {{{OsmType::kWay, id}, 0}, {std::move(outer), {}}, surface, own_m2, {}};
}

// Farmland of 36 ha with a wood in it, hedges between fields of 2 ha.
struct Farm {
  map::Features map;
  map::Heightfield heights{
      .min = {-256, -256}, .step_m = {1280, 1280}, .columns = 2, .rows = 2, .heights = {0, 0, 0, 0}};
  Report report;

  Farm() {
    map.extent = {{-128, -128}, {768, 768}};
    map.areas = {area(1, LandCoverClass::kFarmland, square_of({0, 0}, {600, 600})),
                 area(2, LandCoverClass::kForest, square_of({200, 200}, {330, 420})),
                 area(3, LandCoverClass::kResidential, square_of({610, 0}, {700, 90}))};
  }

  Fields fields() {
    const RuleAt rule_at = [](Vec2) {
      return FieldRule{.area_m2 = 20000, .aspect = 1.5, .border = FieldBorder::kHedge, .border_share = 1};
    };
    const lots::ClimateAt climate_at = [](Vec2) { return climate::ClimateClass::kCfb; };
    const std::function<map::CountryGroup(Vec2)> country_at = [](Vec2) { return map::CountryGroup::kBritishIsles; };
    return with_fields(map,
                       {.roads = {},
                        .junctions = {},
                        .heights = heights,
                        .rule_at = rule_at,
                        .climate_at = climate_at,
                        .country_at = country_at,
                        .seed = 3,
                        .threads = 1},
                       report);
  }
};

TEST(AddFields, FarmlandBecomesFieldsAndOtherLandStays) {
  Farm farm;
  const Fields made = farm.fields();
  const auto is_crop = [](const map::AreaFeature& a) { return map::is_field(a.surface); };
  EXPECT_GT(std::ranges::count_if(made.areas, is_crop), 10);
  EXPECT_EQ(std::ranges::count(made.areas, LandCoverClass::kFarmland, &map::AreaFeature::surface), 0);
  EXPECT_EQ(std::ranges::count(made.areas, LandCoverClass::kForest, &map::AreaFeature::surface), 1);
  EXPECT_TRUE(std::ranges::is_sorted(made.areas, {}, &map::AreaFeature::id));
  EXPECT_EQ(std::ranges::adjacent_find(made.areas, {}, &map::AreaFeature::id), made.areas.end());
  EXPECT_EQ(farm.report.assumed(Assumption::kFields), 1u);
  for (const map::AreaFeature& each : made.areas) {
    if (is_of_field(each.id) && each.id.osm.type == OsmType::kWay) {
      EXPECT_EQ(each.area_m2, farm.map.areas[0].area_m2 - 1);
    }
  }
}

TEST(AddFields, HedgesKeepOffWoodsOnTheLand) {
  Farm farm;
  const Fields made = farm.fields();
  EXPECT_GT(made.barriers.size(), 8u);
  for (const map::Barrier& hedge : made.barriers) {
    EXPECT_TRUE(is_of_field(hedge.id));
    EXPECT_EQ(hedge.kind, map::BarrierKind::kHedge);
    for (int i = 0; i <= 10; ++i) {
      const Vec2 at = hedge.axis[0] + (hedge.axis[1] - hedge.axis[0]) * (i / 10.0);
      EXPECT_FALSE(at.x > 204 && at.x < 326 && at.y > 204 && at.y < 416);
    }
  }
}

TEST(AddFields, LandWithNamedPlantsStays) {
  Farm farm;
  farm.map.areas[0].plant_tags.kind = map::PlantKind::kMaize;
  const Fields made = farm.fields();
  const auto is_mapped = [](const map::AreaFeature& a) { return a.id.osm.type == OsmType::kWay; };
  EXPECT_EQ(std::ranges::count_if(made.areas, is_mapped), 3);
  EXPECT_EQ(made.areas[0].surface, LandCoverClass::kFarmland);
}

}  // namespace
}  // namespace citykiln::fields
