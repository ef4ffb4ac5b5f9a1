#include <gtest/gtest.h>

#include "compiler/invent/invent_settings.h"

namespace citykiln::invent {
namespace {

std::string error_in(const std::string& text) {
  const auto settings = read_invent_settings(text, "invent.json", {});
  return settings ? "" : to_string(settings.error());
}

TEST(InventSettings, TextIsReadBackToEqualSettings) {
  for (const WorldKind kind :
       {WorldKind::kVillage, WorldKind::kTown, WorldKind::kCity, WorldKind::kTiles, WorldKind::kForest}) {
    InventSettings settings = usual_settings(kind);
    settings.seed = 18446744073709551615U;
    settings.terrain.fractal.spread_m = 0.1 + 0.2;
    settings.terrain.has_coast = true;
    const std::string text = text_of(settings);
    const auto again = read_invent_settings(text, "invent.json", {});
    ASSERT_TRUE(again) << to_string(again.error());
    EXPECT_EQ(text_of(*again), text);
    EXPECT_EQ(again->terrain.fractal.spread_m, 0.1 + 0.2);
    EXPECT_EQ(again->seed, settings.seed);
  }
}

TEST(InventSettings, TheCommandLineGoesBeforeTheFile) {
  const auto settings = read_invent_settings(R"({"kind": "forest", "seed": 3, "size": 300})", "invent.json",
                                             {.kind = {}, .seed = 9, .side_m = {}, .place = {}});
  ASSERT_TRUE(settings);
  EXPECT_EQ(settings->kind, WorldKind::kForest);
  EXPECT_EQ(settings->seed, 9U);
  EXPECT_EQ(settings->side_m, 512);
}

TEST(InventSettings, SettingsLeftOutAreThoseOfTheKind) {
  const auto settings = read_invent_settings(R"({"kind": "forest", "terrain": {"lakes": 2}})", "invent.json", {});
  ASSERT_TRUE(settings);
  InventSettings expected = usual_settings(WorldKind::kForest);
  expected.terrain.lakes = 2;
  EXPECT_EQ(text_of(*settings), text_of(expected));
}

TEST(InventSettings, BadTextsGiveOneLine) {
  EXPECT_EQ(error_in("{\n \"seed\": 1,\n}"), "invent.json:3:1: invalid JSON at this place");
  EXPECT_EQ(error_in("[]"),
            "invent.json: expected a JSON object of settings, such as {\"kind\": \"forest\", \"seed\": 7}");
  EXPECT_EQ(error_in(R"({"sede": 1})"), "invent.json: unknown setting \"sede\"; did you mean seed?");
  EXPECT_EQ(error_in(R"({"seed": -1})"), "invent.json: \"seed\": expected a whole number of at least 0, found -1");
  EXPECT_EQ(error_in(R"({"kind": "wood"})"),
            "invent.json: \"kind\": expected village, town, city, tiles or forest, found \"wood\"");
  EXPECT_EQ(error_in(R"({"size": 0})"), "invent.json: \"size\": expected metres, up to 65536, found 0");
  EXPECT_EQ(error_in(R"({"place": [1]})"),
            "invent.json: \"place\": expected [longitude, latitude] in degrees, up to 179 and 80, found [1]");
  EXPECT_EQ(error_in(R"({"terrain": 1})"), "invent.json: \"terrain\": expected an object of settings, found 1");
  EXPECT_EQ(error_in(R"({"terrain": {"spred": 1}})"), "invent.json: unknown setting \"spred\"; did you mean spread?");
  EXPECT_EQ(error_in(R"({"terrain": {"power": 40}})"),
            "invent.json: \"terrain.power\": expected a whole number from 0 to 12, found 40");
  EXPECT_EQ(error_in(R"({"terrain": {"power": 4.5}})"),
            "invent.json: \"terrain.power\": expected a whole number from 0 to 12, found 4.5");
  EXPECT_EQ(error_in(R"({"terrain": {"coast": 1}})"),
            "invent.json: \"terrain.coast\": expected true or false, found 1");
  const std::string deep = "{\"seed\": " + std::string(200'000, '[') + std::string(200'000, ']') + "}";
  EXPECT_EQ(error_in(deep), "invent.json: the JSON is nested too deep");
}

}  // namespace
}  // namespace citykiln::invent
