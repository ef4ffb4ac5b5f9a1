#include "compiler/map/tagged_words.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "compiler/map/tags/tag_values.h"
#include "compiler/source/read_osm.h"
#include "grammars/roofs/roof_shape.h"
#include "tests/compiler/map/map_text.h"
#include "tests/test_files.h"

namespace citykiln::map {
namespace {

namespace fs = std::filesystem;
using materials::Material;

// The tags that cannot be read, with the number of elements that have them.
std::map<std::string, int> unread_tags(const Report& report) {
  std::map<std::string, int> tags;
  for (const Diagnosis& diagnosis : report.diagnoses())
    if (diagnosis.code == Code::kBadTagValue) ++tags[diagnosis.tag];
  return tags;
}

TEST(TaggedWords, MaterialsAreReadInAnyCapitalsAndFromLists) {
  EXPECT_EQ(wall_material_of("Brick"), Material::kBrick);
  EXPECT_EQ(wall_material_of("Natural Stone"), Material::kStone);
  EXPECT_EQ(wall_material_of("unheard_of; Reinforced-Concrete"), Material::kConcrete);
  EXPECT_EQ(wall_material_of("concrete/glass"), Material::kConcrete);
  EXPECT_EQ(roof_material_of("Clay tiles"), Material::kRoofTile);
  EXPECT_EQ(roof_material_of("thatch"), Material::kTimber);
  EXPECT_EQ(thing_material_of("Timber"), "wood");
  EXPECT_EQ(thing_material_of("stainless steel"), "steel");
  EXPECT_EQ(wall_material_of("unheard_of"), std::nullopt);
  EXPECT_EQ(roof_material_of(""), std::nullopt);
}

TEST(TaggedWords, SurfacesArePavedOrNot) {
  for (const char* paved : {"asphalt", "Asphalt", "paving stones", "concrete:plates", "Cement", "painted_concrete"})
    EXPECT_EQ(is_paved_surface(paved), true) << paved;
  for (const char* loose : {"Dirt", "fine gravel", "dirt/sand", "pebbles", "grass"})
    EXPECT_EQ(is_paved_surface(loose), false) << loose;
  EXPECT_EQ(is_paved_surface("customers"), std::nullopt);
}

TEST(TaggedWords, SynonymsGiveTheClassOfTheWord) {
  const Features f = features_of(R"(
    w1 0:0 50:0 highway=footway surface=Fine~Gravel
    w2 0:9 50:9 highway=track surface=tarmac
    w3 0:19 50:19 highway=service surface=pebbles
    a4 60:0 90:0 90:20 60:20 leisure=pitch surface=Synthetic~turf)");
  ASSERT_EQ(f.tracks.size(), 3u);
  EXPECT_EQ(f.tracks[0].surface, LandCoverClass::kFootPath);
  EXPECT_EQ(f.tracks[1].surface, LandCoverClass::kServiceRoad);
  EXPECT_EQ(f.tracks[2].surface, LandCoverClass::kUnpavedRoad);
  ASSERT_EQ(f.areas.size(), 1u);
  EXPECT_EQ(f.areas[0].surface, LandCoverClass::kArtificialPitch);
}

TEST(TaggedWords, TwelveUnknownWordsOfEachKeyAreQuotedOnceEach) {
  constexpr const char* kKeys[] = {"building:material", "material", "roof:material", "surface", "roof:shape",
                                   "building:colour",   "wall",     "fence_type",    "barrier"};
  std::string text;
  std::map<std::string, int> expected;
  int id = 0;
  for (const char* key : kKeys)
    for (int word = 0; word < 12; ++word) {
      const std::string tag = fmt::format("{}=unheard_of_{}", key, static_cast<char>('a' + word));
      const int x = 12 * (++id % 30) - 200, y = 12 * (id / 30);
      text += fmt::format("a{} {}:{} {}:{} {}:{} building=yes {}\n", id, x, y, x + 9, y, x + 9, y + 9, tag);
      expected[tag] = 1;
    }
  Report report;
  features_of(text, report);
  EXPECT_EQ(unread_tags(report), expected);
}

TEST(TaggedWords, TwelveUnknownWordsOfBuildingsAndBarriersAreQuotedOnceEach) {
  std::string text;
  std::map<std::string, int> buildings, barriers;
  for (int word = 0; word < 12; ++word) {
    const std::string value = fmt::format("unheard_of_{}", static_cast<char>('a' + word));
    text += fmt::format("a{} {}:0 {}:0 {}:9 building={}\n", word + 1, 12 * word, 12 * word + 9, 12 * word + 9, value);
    text += fmt::format("w{} {}:20 {}:20 barrier={}\n", word + 21, 12 * word, 12 * word + 9, value);
    buildings["building=" + value] = 1, barriers["barrier=" + value] = 1;
  }
  Report report;
  features_of(text, report);
  EXPECT_EQ(unread_tags(report), buildings) << "they are built as plain buildings";
  std::map<std::string, int> unknown;
  for (const Diagnosis& diagnosis : report.diagnoses())
    if (diagnosis.code == Code::kUnknownKind) ++unknown[diagnosis.tag];
  EXPECT_EQ(unknown, barriers) << "they are not built";
}

TEST(TaggedWords, UsualWordsOfBuildingsWallsAndFencesAreKnown) {
  Report report;
  features_of(R"(
    a1 0:0 9:0 9:9 building=bunker
    a2 20:0 29:0 29:9 building=Mixed-Use wall=no
    a3 40:0 49:0 49:9 building=yes;church
    a4 60:0 69:0 69:9 building=razed
    w5 0:20 9:20 barrier=fence fence_type=chain_link
    w6 20:20 29:20 barrier=wall wall=dry_stone)",
              report);
  EXPECT_EQ(unread_tags(report), (std::map<std::string, int>{}));
}

TEST(TaggedWords, KnownAndIndefiniteWordsAndPlacesOutsideAreNoFindings) {
  Report report;
  features_of(R"(
    a1 0:0 9:0 9:9 building=yes building:material=mixed roof:material=yes roof:shape=many
    a2 20:0 29:0 29:9 building=yes building:material=Brick roof:material=slate roof:shape=Gabled;hipped
    w3 5000:0 5050:0 highway=footway surface=unheard_of)",
              report);
  EXPECT_EQ(unread_tags(report), (std::map<std::string, int>{}));
}

bool ends_like_an_extract(const std::string& name) {
  return name.ends_with(".osm") || name.ends_with(".osm.pbf") || name.ends_with(".osm.gz") ||
         name.ends_with(".osm.bz2");
}

// True if the value is read. Only these keys are asked for.
bool is_read(std::string_view key, std::string_view value) {
  if (key == "building:material") return wall_material_of(value).has_value();
  if (key == "roof:material") return roof_material_of(value).has_value();
  if (key == "surface") return is_paved_surface(value).has_value();
  return thing_material_of(value).has_value();
}

TEST(TaggedWordsReal, EveryWordIsReadOrQuotedOnceForEachElement) {
  if (!fs::exists(real_data())) GTEST_SKIP() << "no real data at " << real_data();
  std::set<std::string> read, quoted;
  for (const auto& entry : fs::recursive_directory_iterator(real_data())) {
    if (!ends_like_an_extract(entry.path().filename().string())) continue;
    Report reading, report;
    const auto osm = source::read_osm(entry.path().string(), 2, reading);
    if (!osm || osm->tags.empty()) continue;
    // the whole earth, so that every element counts
    const ReadContext context{*osm, Plane(default_origin(choose_box(*osm, {}))), {{-2e7, -2e7}, {2e7, 2e7}}, report};
    diagnose_unknown_words(context);
    const std::map<std::string, int> unread = unread_tags(report);
    std::map<std::string, int> elements;
    const auto visit = [&](source::Range tags) {
      for (const source::Tag& tag : osm->tags_of(tags))
        ++elements[osm->strings[tag.key] + "=" + osm->strings[tag.value]];
    };
    for (const source::Node& node : osm->nodes) visit(node.tags);
    for (const source::Way& way : osm->ways) visit(way.tags);
    for (const source::Relation& relation : osm->relations) visit(relation.tags);
    for (const auto& [tag, count] : elements) {
      const std::size_t equals = tag.find('=');
      const std::string key = tag.substr(0, equals), value = tag.substr(equals + 1);
      if (key != "building:material" && key != "roof:material" && key != "surface" && key != "material") continue;
      const bool is_clear = is_read(key, value) || std::ranges::any_of(words_of(value), is_indefinite);
      const auto found = unread.find(tag_text(key, value));
      EXPECT_EQ(found == unread.end() ? 0 : found->second, is_clear ? 0 : count) << entry.path() << ": " << tag;
      (is_clear ? read : quoted).insert(tag);
    }
  }
  EXPECT_GT(read.size(), 80u);
  for (const std::string& tag : quoted) fmt::print("quoted: {}\n", tag);
  EXPECT_LT(quoted.size(), read.size() / 4);
}

}  // namespace
}  // namespace citykiln::map
