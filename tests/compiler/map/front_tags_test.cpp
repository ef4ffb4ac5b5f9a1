#include "compiler/map/front_tags.h"

#include <gtest/gtest.h>

#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

TEST(FrontTags, SayWhatIsSoldOrDone) {
  const Features features = features_of(R"(
    n1 3:4 amenity=cafe
    n2 5:4 shop=bakery opening_hours=Mo-Sa~07:00-18:00
    n3 6:4 office=lawyer addr:housenumber=7
    n4 7:4 shop=vacant name=none
    n5 8:4 shop=books level=1
    n6 9:4 craft=shoemaker
    n7 9:5 shop=toys level=0;1)");
  ASSERT_EQ(features.points.size(), 6u);
  EXPECT_EQ(features.points[0].front->kind, FrontKind::kCafe);
  EXPECT_EQ(features.points[1].front->kind, FrontKind::kFood);
  EXPECT_EQ(features.points[1].front->hours, (FrontHours{{28, 72, 28, 72, 0, 0}}));
  EXPECT_EQ(features.points[2].kind, PointKind::kAddress);
  EXPECT_EQ(features.points[2].front->kind, FrontKind::kOffice);
  EXPECT_FALSE(features.points[3].front);
  EXPECT_EQ(features.points[4].front->kind, FrontKind::kCraft);
  EXPECT_EQ(features.points[5].front->kind, FrontKind::kShop);
}

TEST(FrontHours, AreReadInSimpleForms) {
  EXPECT_EQ(front_hours_of("24/7"), (FrontHours{{0, 96, 0, 96, 0, 96}}));
  EXPECT_EQ(front_hours_of("Mo-Fr 08:00-18:00; Sa 10:00-16:00"), (FrontHours{{32, 72, 40, 64, 0, 0}}));
  EXPECT_EQ(front_hours_of("Mo-Su 11:30-15:00,18:00-23:00"), (FrontHours{{46, 92, 46, 92, 46, 92}}));
  EXPECT_EQ(front_hours_of("We-Mo 17:00-02:00; Tu off"), (FrontHours{{68, 104, 68, 104, 68, 104}}));
  EXPECT_EQ(front_hours_of("10:00-20:00"), (FrontHours{{40, 80, 40, 80, 40, 80}}));
}

TEST(FrontHours, AreUnknownInOtherForms) {
  for (const char* text : {"", "Mo-Fr", "sunrise-sunset", "May-Sep 10:00-18:00", "Mo-Fr 08:00-18:00 \"call\"",
                           "Mo-Fr 8-18", "Mo-Fr off", "Mo-Fr 25:99-31:00"})
    EXPECT_FALSE(front_hours_of(text)) << text;
}

TEST(FrontKinds, HaveOrderedUsualHours) {
  for (std::size_t kind = 0; kind < static_cast<std::size_t>(FrontKind::kCount); ++kind) {
    const FrontValues& values = values_of(static_cast<FrontKind>(kind));
    EXPECT_FALSE(values.name.empty());
    for (std::size_t day = 0; day < 3; ++day) {
      EXPECT_LE(values.hours.quarters[2 * day], values.hours.quarters[2 * day + 1]) << values.name;
      EXPECT_LE(values.hours.quarters[2 * day + 1], kLatestClosing) << values.name;
    }
    for (const std::string_view colour : values.colours) EXPECT_EQ(colour.size(), 7u) << values.name;
  }
}

}  // namespace
}  // namespace citykiln::map
