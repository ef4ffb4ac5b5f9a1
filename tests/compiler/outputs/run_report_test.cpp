#include "compiler/outputs/run_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/scratch_folder.h"

namespace citykiln::outputs {
namespace {

/// The folder of a run that ended with a report.
class RunFolder : public ScratchFolder {
 public:
  void report(const std::string& text) const { write("report.json", text); }
};

WrittenFiles two_tiles() {
  WrittenFiles written;
  written.files = {{"scene.kiln", 100}};
  written.tiles = {{{"glb/0_0_L0.glb", 1000}, {0, 0}, 0, 0.1, 0.09, 12, 3},
                   {{"glb/-1_2_L0.glb", 500}, {-1, 2}, 0, 0.1, 0.08, 6, 0}};
  return written;
}

std::string report_of(Report& report, const WrittenFiles& written) {
  scene::Header header;
  header.extent = {{-1024, 0}, {1024, 3072}};
  header.tile_m = 1024;
  return report_json(header, {}, report, written, {}, nlohmann::ordered_json::object());
}

TEST(RunReport, ReadsBackTheTilesItWrote) {
  Report report;
  const WrittenFiles written = two_tiles();
  const RunFolder folder;
  folder.report(report_of(report, written));
  const Result<RunRecord> record = read_report(folder.path());
  ASSERT_TRUE(record) << to_string(record.error());
  ASSERT_EQ(record->tiles.size(), 2u);
  EXPECT_EQ(record->tiles[1].file.name, "glb/-1_2_L0.glb");
  EXPECT_EQ(record->tiles[1].tile, (scene::TileKey{-1, 2}));
  EXPECT_EQ(record->tiles[0].error_m, 0.09);
  EXPECT_TRUE(record->has_manifest);
  EXPECT_TRUE(record->unbalanced.empty());
}

TEST(RunReport, FindsAccountsThatDoNotBalance) {
  Report report;
  report.account("map", "track").in = 3;
  report.account("map", "track").out = 2;
  report.account("map", "area").in = report.account("map", "area").out = 1;
  const RunFolder folder;
  folder.report(report_of(report, {}));
  EXPECT_EQ(read_report(folder.path())->unbalanced, (std::vector<std::string>{"map/track"}));
}

TEST(RunReport, ReadsBackWhatIsAssumed) {
  Report report;
  for (int i = 0; i < 3; ++i) report.count_assumed(Assumption::kHeights, {OsmType::kWay, i});
  const RunFolder folder;
  folder.report(report_of(report, {}));
  const Result<RunRecord> record = read_report(folder.path());
  ASSERT_TRUE(record) << to_string(record.error());
  EXPECT_EQ(record->ledger.assumed(Assumption::kHeights), 3u);
  EXPECT_EQ(record->ledger.assumed(Assumption::kLamps), 0u);
}

TEST(RunReport, IsTheSameWhateverTheOrderOfDiagnoses) {
  Report one, other;
  for (int i = 0; i < 50; ++i) one.add(Code::kMissingNode, {OsmType::kWay, i});
  for (int i = 49; i >= 0; --i) other.add(Code::kMissingNode, {OsmType::kWay, i});
  EXPECT_EQ(report_of(one, {}), report_of(other, {}));
}

TEST(RunReport, RefusesOtherFilesWithTheirName) {
  const RunFolder folder;
  for (const char* text : {"", "{}", "[1]", R"({"tiles": 3})", R"({"tiles": [{}]})"}) {
    folder.report(text);
    const Result<RunRecord> record = read_report(folder.path());
    ASSERT_FALSE(record) << text;
    EXPECT_EQ(record.error().where, folder.path() + "/report.json");
  }
  EXPECT_FALSE(read_report("/nowhere"));
}

TEST(RunReport, IsStrictAboutMendedAndDroppedOnly) {
  Report report;
  report.add(Code::kNoBuildingHeight, {OsmType::kWay, 1});
  EXPECT_FALSE(has_mended_or_dropped(report));
  report.add(Code::kMissingNode, {OsmType::kWay, 1});
  EXPECT_TRUE(has_mended_or_dropped(report));
}

TEST(RunReport, IsStrictAboutTheCodesThatAreNamed) {
  Report report;
  report.add(Code::kMissingNode, {OsmType::kWay, 1});
  EXPECT_FALSE(is_violated({}, report));
  EXPECT_TRUE(is_violated({.is_on = true, .codes = {}}, report));
  EXPECT_TRUE(is_violated({.is_on = true, .codes = {Code::kBrokenArea, Code::kMissingNode}}, report));
  EXPECT_FALSE(is_violated({.is_on = true, .codes = {Code::kBrokenArea}}, report));
}

}  // namespace
}  // namespace citykiln::outputs
