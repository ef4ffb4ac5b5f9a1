#include "compiler/spec.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/parse_values.h"
#include "compiler/settings.h"
#include "tests/scratch_folder.h"

namespace citykiln {
namespace {

const Setting& setting_named(std::string_view name) {
  for (const Setting& setting : settings()) {
    if (setting.name == name) return setting;
  }
  throw std::logic_error("no such setting");
}

/// The error of a value, or "" where it is taken.
std::string objection(std::string_view name, std::string_view text) {
  CompileSpec spec;
  const Result<Done> done = apply(setting_named(name), text, spec);
  return done ? "" : to_string(done.error());
}

/// A file that is gone at the end of the test.
class SpecFile {
 public:
  explicit SpecFile(const std::string& text) : path_(folder_.write("spec.json", text)) {}
  const std::string& path() const { return path_; }

 private:
  const ScratchFolder folder_;
  const std::string path_;
};

TEST(Spec, HasTheDefaultTolerances) {
  const CompileSpec spec;
  EXPECT_EQ(spec.outputs.tolerances_m, std::vector(kDefaultLevels_m.begin(), kDefaultLevels_m.end()));
  EXPECT_EQ(spec.tile_m, 1024);
}

TEST(Layout, IsThatOfTheTargetUnlessOneIsGiven) {
  Outputs outputs;
  EXPECT_EQ(layout_of(outputs), Layout::kEmbedded);
  outputs.target = Target::kThree;
  EXPECT_EQ(layout_of(outputs), Layout::kShared);
  outputs.layout = Layout::kEmbedded;
  EXPECT_EQ(layout_of(outputs), Layout::kEmbedded);
}

// A limit of bytes is one of lone files.
TEST(Layout, IsEmbeddedWhereEachFileHasALimit) {
  Outputs outputs;
  outputs.target = Target::kThree, outputs.max_bytes = 1000;
  EXPECT_EQ(layout_of(outputs), Layout::kEmbedded);
}

TEST(Spec, ParsesEverySetting) {
  const std::pair<const char*, const char*> rows[] = {{"map", "a.osm"},
                                                      {"dem", "a.png,bounds=1/2/3/4"},
                                                      {"bbox", "-3,1,-2,2.5"},
                                                      {"origin", "-3.5,42"},
                                                      {"tile", "256"},
                                                      {"only", "-1_2,3_-4"},
                                                      {"out", "o"},
                                                      {"emit", "glb,kiln,usd,3dtiles,3tz"},
                                                      {"lods", "0.1,2"},
                                                      {"world", "plane"},
                                                      {"geoid-height", "47.5"},
                                                      {"compress", "meshopt"},
                                                      {"layout", "shared"},
                                                      {"max-bytes", "30000000"},
                                                      {"max-triangles", "100000"},
                                                      {"tags", "true"},
                                                      {"target", "three"},
                                                      {"split", "building"},
                                                      {"rules", "r"},
                                                      {"things", "t"},
                                                      {"species", "s"},
                                                      {"cars", "0.5"},
                                                      {"people", "0.5"},
                                                      {"traffic", "0.5"},
                                                      {"drive-on", "left"},
                                                      {"seed", "18446744073709551615"},
                                                      {"threads", "2"},
                                                      {"snow-line", "2200"},
                                                      {"strict", "true"},
                                                      {"assume", "pavements,lamps"},
                                                      {"fill", "lots"},
                                                      {"time", "2026-06-21T15:00+02:00"},
                                                      {"visibility", "30"},
                                                      {"turbidity", "3"},
                                                      {"ground-albedo", "0.3"},
                                                      {"clouds", "fair"},
                                                      {"surroundings", "true"},
                                                      {"materials", "a"},
                                                      {"textures", "fine"},
                                                      {"lights", "20"},
                                                      {"area", "Old Town"},
                                                      {"layers", "-plants"},
                                                      {"wood-density", "0.5"},
                                                      {"lamps", "off"},
                                                      {"lit-windows", "0.5"}};
  // edits and clip read a file, which tests of their rooms write
  constexpr std::size_t kOfFiles = 2;
  for (const auto& [name, text] : rows) EXPECT_EQ(objection(name, text), "") << name;
  EXPECT_EQ(std::size(rows) + kOfFiles, settings().size()) << "a setting without a row here";
}

TEST(Spec, ErrorsSayTheExpectedValue) {
  const std::pair<const char*, const char*> rows[] = {
      {"bbox", "1,2,3"},    {"bbox", "3,1,2,2"},      {"bbox", "1,2,x,4"},   {"origin", "1"},    {"tile", "100"},
      {"tile", "0"},        {"only", "1-2"},          {"emit", "obj"},       {"lods", "1,1"},    {"lods", "0,1"},
      {"lods", ""},         {"lods", "0.1,500"},      {"lods", "1e9"},       {"target", "maya"}, {"split", "road"},
      {"drive-on", "top"},  {"seed", "-1"},           {"threads", "-1"},     {"threads", "1.5"}, {"strict", "yes"},
      {"dem", "a,bound=1"}, {"time", "noon"},         {"snow-line", "high"}, {"world", "torus"}, {"compress", "zip"},
      {"fill", "all"},      {"surroundings", "some"}, {"cars", "some"},      {"cars", "2"},      {"people", "many"},
      {"traffic", "2"}};
  for (const auto& [name, text] : rows) {
    EXPECT_NE(objection(name, text).find("expected "), std::string::npos)
        << name << " " << text << ": " << objection(name, text);
  }
}

TEST(Spec, SurroundingsAreThereUnlessNoneAreWanted) {
  CompileSpec spec;
  EXPECT_EQ(spec.outputs.surroundings, AroundWish::kWherePossible);
  for (const auto& [text, wish] :
       {std::pair{"true", AroundWish::kYes}, std::pair{"none", AroundWish::kNo}, std::pair{"false", AroundWish::kNo}}) {
    ASSERT_TRUE(apply(setting_named("surroundings"), text, spec)) << text;
    EXPECT_EQ(spec.outputs.surroundings, wish) << text;
  }
}

TEST(Spec, CarsAreUsualWhereParkingIsAssumed) {
  CompileSpec spec;
  EXPECT_EQ(car_share_of(spec), cars::kUsualCars);
  spec.assume = kNoAssumptions;
  EXPECT_EQ(car_share_of(spec), cars::kNoCars);
  // a bare --cars, as earlier versions had it, is "true"
  for (const auto& [text, share] :
       {std::pair{"true", cars::kUsualCars}, std::pair{"usual", cars::kUsualCars}, std::pair{"none", cars::kNoCars},
        std::pair{"false", cars::kNoCars}, std::pair{"0.5", cars::CarShare{.share = 0.5}}}) {
    ASSERT_TRUE(apply(setting_named("cars"), text, spec)) << text;
    EXPECT_EQ(car_share_of(spec), share) << text;
  }
}

TEST(Spec, InsideOfACylinderSurroundingsAreRefusedOnlyIfAskedFor) {
  CompileSpec spec;
  spec.world = World::kCylinder;
  EXPECT_TRUE(check_world(spec));
  spec.outputs.surroundings = AroundWish::kYes;
  EXPECT_FALSE(check_world(spec));
}

TEST(Spec, TextsOfTimeCloudsAndGeoidBecomeValuesAtOnce) {
  CompileSpec spec;
  ASSERT_TRUE(apply(setting_named("time"), "2026-06-21T15:00+02:00", spec));
  ASSERT_TRUE(apply(setting_named("clouds"), "broken", spec));
  ASSERT_TRUE(apply(setting_named("geoid-height"), "47.50", spec));
  EXPECT_EQ(spec.time, *sky::parse_time("2026-06-21T13:00:00Z"));
  EXPECT_EQ(spec.clouds->size(), 2U);
  EXPECT_EQ(spec.outputs.geoid, (map::GeoidSource{"47.50", 47.5}));
}

TEST(Spec, AsksWhetherABoxIsInTheOtherOrder) {
  // Sydney as latitude, longitude: 151 is no latitude
  EXPECT_NE(objection("bbox", "-33.9,151.1,-33.8,151.3").find("swapped? Try 151.1,-33.9,151.3,-33.8"),
            std::string::npos);
  EXPECT_EQ(objection("bbox", "3,1,2,2").find("swapped"), std::string::npos);
}

TEST(Spec, ACylinderHasARadius) {
  EXPECT_EQ(objection("world", "cylinder:8000"), "");
  for (const char* text : {"cylinder", "cylinder:", "cylinder:-5", "cylinder:x", "cylinder:1e300"})
    EXPECT_NE(objection("world", text), "") << text;
}

TEST(Spec, RefusesACompressionThatTheTargetCannotRead) {
  Outputs outputs;
  EXPECT_TRUE(check_target(outputs));
  outputs.compress = Compression::kMeshopt;
  const Result<Done> refused = check_target(outputs);
  ASSERT_FALSE(refused);
  EXPECT_EQ(to_string(refused.error()),
            "--compress: meshopt cannot be read by the target generic; add --target three, cesium or unity");
  outputs.target = Target::kThree;
  EXPECT_TRUE(check_target(outputs));
  outputs.target = Target::kGeneric, outputs.glb = false;
  EXPECT_TRUE(check_target(outputs)) << "without .glb tiles the target matters to nothing";
}

TEST(Spec, IsUnchangedByInvalidValues) {
  CompileSpec spec;
  ASSERT_FALSE(apply(setting_named("emit"), "kiln,obj", spec));
  EXPECT_TRUE(spec.outputs.manifest && spec.outputs.glb);
}

TEST(Spec, KeepsTilesSortedAndOnce) {
  CompileSpec spec;
  ASSERT_TRUE(apply(setting_named("only"), "3_1,-1_0,3_1", spec));
  ASSERT_TRUE(apply(setting_named("only"), "0_0", spec));
  EXPECT_EQ(spec.only, (std::vector<scene::TileKey>{{-1, 0}, {0, 0}, {3, 1}}));
}

TEST(Spec, TilesReadBackAsTheyAreWritten) {
  for (const scene::TileKey tile :
       {scene::TileKey{0, 0}, scene::TileKey{-3, 12}, scene::TileKey{2147483647, -2147483647}}) {
    const Result<scene::TileKey> back = parse_tile(to_string(tile));
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, tile);
  }
  for (const char* text : {"", "_", "1_", "_1", "1", "1_2_3", "a_b", "1_2 ", "99999999999_0"})
    EXPECT_FALSE(parse_tile(text)) << text;
}

TEST(SpecFile, SaysTheSameAsTheCommandLine) {
  const SpecFile file(
      R"({"map": "a.osm", "dem": ["x.tif", "y.tif"], "bbox": [1, 2, 3, 4], "tile": 512, "lods": [0.5, 4], "strict": true})");
  const Result<CompileSpec> spec = read_spec(file.path());
  ASSERT_TRUE(spec) << to_string(spec.error());
  EXPECT_EQ(spec->map_path, "a.osm");
  ASSERT_EQ(spec->rasters.size(), 2u);
  EXPECT_EQ(spec->rasters[1].path, "y.tif");
  EXPECT_EQ(spec->map.bbox, (source::LonLatBox{1, 2, 3, 4}));
  EXPECT_EQ(spec->tile_m, 512);
  EXPECT_EQ(spec->outputs.tolerances_m, (std::vector{0.5, 4.0}));
  EXPECT_TRUE(spec->strict.is_on);
}

TEST(SpecFile, ErrorsNameFileAndPlace) {
  const SpecFile cut("{\"map\":\n  nonsense}");
  EXPECT_TRUE(to_string(read_spec(cut.path()).error()).starts_with(cut.path() + ":2:"));
  const SpecFile unknown(R"({"maps": "a.osm"})");
  EXPECT_EQ(to_string(read_spec(unknown.path()).error()),
            unknown.path() + ":1:2: unknown setting \"maps\"; did you mean map? (citykiln compile --help lists all)");
  const SpecFile twice("{\"map\": \"a.osm\",\n \"tile\": 512, \"map\": \"b.osm\"}");
  EXPECT_EQ(to_string(read_spec(twice.path()).error()), twice.path() + ":2:15: \"map\" is given twice");
  const SpecFile list("[1, 2]");
  EXPECT_FALSE(read_spec(list.path()));
  EXPECT_EQ(to_string(read_spec("/nowhere/spec.json").error()), "/nowhere/spec.json: the file cannot be read");
}

// Found by fuzz_spec.
TEST(SpecFile, NumbersAndNestingThatCannotBeReadAreErrors) {
  const SpecFile large(R"({"tile": 1e999})");
  EXPECT_EQ(to_string(read_spec(large.path()).error()), large.path() + ": invalid JSON: a number is too large");
  const SpecFile deep("{\"tile\": " + std::string(200'000, '[') + std::string(200'000, ']') + "}");
  EXPECT_EQ(to_string(read_spec(deep.path()).error()), deep.path() + ": the JSON is nested too deep");
}

TEST(Spec, IsCompleteWithAMapAndAFolder) {
  CompileSpec spec;
  EXPECT_FALSE(check_complete(spec));
  spec.map_path = "a.osm";
  EXPECT_FALSE(check_complete(spec));
  spec.outputs.folder = "out";
  EXPECT_TRUE(check_complete(spec));
}

TEST(Spec, StrictTakesCodes) {
  const auto strict = std::ranges::find(settings(), "strict", &Setting::name);
  CompileSpec spec;
  ASSERT_TRUE(apply(*strict, "MissingNode,RoofFallback", spec));
  EXPECT_TRUE(spec.strict.is_on);
  EXPECT_EQ(spec.strict.codes, (std::vector<Code>{Code::kMissingNode, Code::kRoofFallback}));
  EXPECT_FALSE(apply(*strict, "MissingNode,Nonsense", spec));
  ASSERT_TRUE(apply(*strict, "false", spec));
  EXPECT_FALSE(spec.strict.is_on);
  EXPECT_TRUE(spec.strict.codes.empty());
}

}  // namespace
}  // namespace citykiln
