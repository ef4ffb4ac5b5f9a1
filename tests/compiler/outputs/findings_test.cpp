#include "compiler/outputs/findings.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace citykiln::outputs {
namespace {

scene::Header header_with_origin() {
  scene::Header header;
  header.origin = {7, 43};
  header.extent = {{-1024, -1024}, {1024, 1024}};
  header.tile_m = 512;
  header.attributions = {"© OpenStreetMap contributors"};
  return header;
}

TEST(Findings, AreOneFeatureForEachDiagnosisWithItsPlace) {
  Report report;
  report.add(Code::kMissingNode, {OsmType::kWay, 4}, 2);
  report.add(Code::kUnsortedFile, {});
  const std::string json = findings_json(
      findings_of(report, {{{OsmType::kWay, 4}, {7.0001, 43.0001}}}, {}, header_with_origin()), header_with_origin());
  EXPECT_EQ(
      json,
      R"({"type":"FeatureCollection","name":"findings","attribution":["© OpenStreetMap contributors"],"features":[)"
      "\n"
      R"({"type":"Feature","properties":{"code":"MissingNode","severity":"mended","id":"w4","size":2.0,"tile":"0_0"},)"
      R"("geometry":{"type":"Point","coordinates":[7.0001000,43.0001000]}},)"
      "\n"
      R"({"type":"Feature","properties":{"code":"UnsortedFile","severity":"note","id":null,"size":0.0},)"
      R"("geometry":null})"
      "\n]}\n");
}

TEST(Findings, OutsideTheRegionAreInNoTile) {
  Report report;
  report.add(Code::kOutsideBounds, {OsmType::kNode, 1});
  const auto findings = findings_of(report, {{{OsmType::kNode, 1}, {7.5, 43}}}, {}, header_with_origin());
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_TRUE(findings[0].at);
  EXPECT_FALSE(findings[0].tile);
}

TEST(Findings, OfBakingLieAtTheirObjectOrInTheMiddleOfTheTile) {
  const scene::Header header = header_with_origin();
  const map::Plane plane(header.origin);
  scene::Chunk chunk;
  chunk.tile = {1, -1};
  chunk.lamps.push_back({.id = {{OsmType::kNode, 8}, 0}, .at = {600, -30}});
  Report report;
  report.add(Code::kBelowTolerance, {OsmType::kNode, 8}, 1);
  report.add(Code::kToleranceNotMet, {}, 3);
  const auto findings = findings_of(report, header, chunk, 2);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(*findings[0].at, plane.backward({600, -30}));
  EXPECT_EQ(*findings[1].at, plane.backward({768, -256}));
  for (const Finding& finding : findings) {
    EXPECT_EQ(finding.tile, (scene::TileKey{1, -1}));
    EXPECT_EQ(finding.level, 2u);
  }
}

TEST(Findings, HavePlacesOfSevenAndSizesOfThreeDecimals) {
  Report report;
  report.add(Code::kHeightSpike, {OsmType::kWay, 4}, 331.79999923706055);
  const scene::Header header = header_with_origin();
  const std::string json =
      findings_json(findings_of(report, {{{OsmType::kWay, 4}, {700001234 * 1e-8, 43 + 1e-9}}}, {}, header), header);
  EXPECT_NE(json.find(R"("size":331.8,)"), std::string::npos) << json;
  EXPECT_NE(json.find(R"("coordinates":[7.0000123,43.0000000])"), std::string::npos) << json;
}

TEST(Findings, AreTheSameWhateverTheOrderOfDiagnoses) {
  Report one, other;
  for (int i = 0; i < 50; ++i) one.add(Code::kMissingNode, {OsmType::kWay, i}, i % 3);
  for (int i = 49; i >= 0; --i) other.add(Code::kMissingNode, {OsmType::kWay, i}, i % 3);
  const scene::Header header = header_with_origin();
  EXPECT_EQ(findings_json(findings_of(one, {}, {}, header), header),
            findings_json(findings_of(other, {}, {}, header), header));
}

TEST(Findings, BeginWithWhatIsMissingTheLargestFirst) {
  Report report;
  report.add(Code::kTooSteep, {OsmType::kWay, 1}, 9);
  report.add(Code::kMissingNode, {OsmType::kWay, 2}, 2);
  report.add(Code::kUnknownKind, {OsmType::kNode, 3});
  report.add(Code::kUnknownKind, {OsmType::kWay, 4}, 300);
  report.add(Code::kBrokenArea, {OsmType::kWay, 5}, 400);
  report.add(Code::kIncompleteArea, {OsmType::kRelation, 6}, 0.5);
  const scene::Header header = header_with_origin();
  const auto findings = parse_findings(findings_json(findings_of(report, {}, {}, header), header));
  ASSERT_TRUE(findings);
  std::vector<std::int64_t> ids;
  for (const Finding& finding : *findings) ids.push_back(finding.diagnosis.object.id);
  EXPECT_EQ(ids, (std::vector<std::int64_t>{6, 5, 4, 3, 2, 1}));
}

TEST(Findings, OfTwoWaysQuoteTheirTags) {
  const OsmId upper{OsmType::kWay, 4}, lower{OsmType::kWay, 5};
  Report report;
  report.add_pair(Code::kLayersContradict, upper, lower, 2);
  const scene::Header header = header_with_origin();
  const auto written = findings_of(report, {}, {{upper, "tunnel=yes"}, {lower, ""}}, header);
  ASSERT_EQ(written.size(), 1u);
  EXPECT_EQ(written[0].tags, "w4: tunnel=yes; w5: no tags of height");
  const auto read = parse_findings(findings_json(written, header));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->front().diagnosis.other, lower);
  EXPECT_EQ(read->front().tags, written[0].tags);
}

TEST(Findings, OfATagQuoteItAsValidText) {
  Report report;
  report.add_tag(Code::kBadTagValue, {OsmType::kWay, 4}, "width",
                 "wi\xff"
                 "de");
  const std::vector<Finding> findings = findings_of(report, {}, {}, header_with_origin());
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].tags,
            "width=wi\xef\xbf\xbd"
            "de");
  const auto read = parse_findings(findings_json(findings, header_with_origin()));
  ASSERT_TRUE(read);
  EXPECT_EQ((*read)[0].tags, findings[0].tags);
}

TEST(Findings, AreReadAsTheyWereWritten) {
  Report report;
  report.add(Code::kTooSteep, {OsmType::kWay, -4}, 0.25);
  report.add(Code::kUnsortedFile, {});
  const scene::Header header = header_with_origin();
  std::vector<Finding> written = findings_of(report, {{{OsmType::kWay, -4}, {7.0001, 43.0001}}}, {}, header);
  written[0].level = 3;
  const auto read = parse_findings(findings_json(written, header));
  ASSERT_TRUE(read);
  EXPECT_EQ(findings_json(*read, header), findings_json(written, header));
}

TEST(Findings, OfUnknownCodesAreLeftOutAndOtherTextsAreErrors) {
  EXPECT_FALSE(parse_findings("{}"));
  EXPECT_FALSE(parse_findings("[1"));
  const auto read =
      parse_findings(R"({"features":[{"properties":{"code":"Later","id":null,"size":0},"geometry":null}]})");
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->empty());
}

}  // namespace
}  // namespace citykiln::outputs
