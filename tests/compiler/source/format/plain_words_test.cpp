#include "compiler/source/format/plain_words.h"

#include <gtest/gtest.h>

#include "tests/compiler/source/extract_text.h"

namespace citykiln::source {
namespace {

TEST(PlainWords, WordsLoseCapitalsAndSpacesAndOtherValuesStay) {
  EXPECT_EQ(plain_word("building", "Mixed Use"), "mixed_use");
  EXPECT_EQ(plain_word("highway", "Residential"), "residential");
  EXPECT_EQ(plain_word("sport", "Soccer; Table Tennis"), "soccer; table_tennis");
  EXPECT_EQ(plain_word("surface", " Asphalt "), " asphalt ");
  EXPECT_EQ(plain_word("name", "Main Street"), "Main Street");
  EXPECT_EQ(plain_word("roof:colour", "IndianRed"), "IndianRed");
  EXPECT_EQ(plain_word("building", ""), "");
}

TEST(PlainWords, ReadElementsHaveThem) {
  Report report;
  const OsmData data = read(R"(
    <node id="1" version="1" lon="0" lat="0"><tag k="natural" v="Tree"/><tag k="name" v="Old Tree"/></node>
    <node id="2" version="1" lon="0.001" lat="0"/>
    <way id="3" version="1"><nd ref="1"/><nd ref="2"/><tag k="highway" v="Living Street"/></way>)",
                            report);
  ASSERT_EQ(data.nodes.size(), 1u);
  EXPECT_EQ(data.value_of(data.nodes[0].tags, "natural"), "tree");
  EXPECT_EQ(data.value_of(data.nodes[0].tags, "name"), "Old Tree");
  ASSERT_EQ(data.ways.size(), 1u);
  EXPECT_EQ(data.value_of(data.ways[0].tags, "highway"), "living_street");
}

}  // namespace
}  // namespace citykiln::source
