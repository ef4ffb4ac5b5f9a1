#include "compiler/commands/edits_template.h"

#include <gtest/gtest.h>

#include <sstream>

#include "compiler/edits/parse_edits.h"

namespace citykiln::commands {
namespace {

const std::string_view kKinds[] = {
#define MEND(kind, edit) kind,
#include "compiler/commands/mends.inc"
#undef MEND
};

verify::WorstPlace place_with(std::string text) {
  return {.ids = {{OsmType::kWay, 7}, {OsmType::kWay, 8}}, .size = 2.5, .text = std::move(text), .at = Vec2{10, 20}};
}

std::string template_of(const std::vector<verify::PlacesOfKind>& kinds, const std::vector<outputs::Finding>& findings) {
  return edits_template(kinds, findings, map::Plane({7, 43}), "out/town");
}

TEST(EditsTemplate, EachMendIsAnEdit) {
  for (const std::string_view kind : kKinds) {
    const std::string mend = likely_mend(kind, place_with("width=wide"));
    const Result<edits::Edits> parsed = edits::parse_edits(mend, "a.edits");
    ASSERT_TRUE(parsed) << kind << ": " << to_string(parsed.error());
    ASSERT_EQ(parsed->lines.size(), 1U) << kind;
    EXPECT_EQ(parsed->lines[0].filter.at(0).ids.at(0), (OsmId{OsmType::kWay, 7}));
  }
}

TEST(EditsTemplate, HasNoEditsBeforeALineIsUncommented) {
  verify::PlacesOfKind kind{"TooSteep", "steep\nlines", 1, {place_with("a\nb drop")}};
  const std::string text = template_of({kind}, {});
  const Result<edits::Edits> parsed = edits::parse_edits(text, "a.edits");
  ASSERT_TRUE(parsed) << to_string(parsed.error());
  EXPECT_TRUE(parsed->lines.empty());
  EXPECT_NE(text.find("\n# w7 w8 at 7.000"), std::string::npos) << text;
  EXPECT_NE(text.find("\n#w7 set highway=steps\n"), std::string::npos) << text;
}

TEST(EditsTemplate, HasDiagnosesThatAreNoWorstPlaces) {
  outputs::Finding finding{.diagnosis = {Code::kNoPlaceForThing, {OsmType::kNode, 5}}, .at = {}, .tile = {}};
  const std::string text = template_of({}, {finding, finding});
  EXPECT_NE(text.find("---- NoPlaceForThing: "), std::string::npos);
  EXPECT_NE(text.find("\n#n5 drop\n"), std::string::npos) << text;
}

TEST(EditsTemplate, QuotesTheKeyOfATag) {
  EXPECT_EQ(likely_mend("BadTagValue", place_with("width=wide")), "w7 remove width");
  EXPECT_EQ(likely_mend("BadTagValue", place_with("odd key=1")), "w7 remove \"odd key\"");
  EXPECT_EQ(likely_mend("cut of a road", place_with("")), "");
}

}  // namespace
}  // namespace citykiln::commands
