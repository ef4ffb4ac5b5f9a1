#include "compiler/commands/manual/man_page.h"

#include <gtest/gtest.h>

namespace citykiln::commands {
namespace {

Verb described_verb(std::string name) {
  Verb verb{
      std::move(name), "bakes", {{"file", "FILE", "a map", false, {}}, {"-o,--out", "FOLDER", ".osm", false, {}}}, {}};
  verb.examples = {"citykiln bake a\\b"};
  return verb;
}

TEST(ManPage, HasEveryOptionWithItsFlagsAndValue) {
  const std::vector<Verb> verbs = {described_verb("bake")};
  const std::string page = man_page(verbs);
  EXPECT_NE(page.find(".SS citykiln bake\n"), std::string::npos);
  EXPECT_NE(page.find("\\fB\\-o\\fR, \\fB\\-\\-out\\fR \\fIFOLDER\\fR\n"), std::string::npos) << page;
  EXPECT_NE(page.find(".TP\n\\fIFILE\\fR\na map\n"), std::string::npos) << page;
}

TEST(ManPage, EscapesWhatManWouldReadAsACommand) {
  const std::vector<Verb> verbs = {described_verb("bake")};
  const std::string page = man_page(verbs);
  EXPECT_NE(page.find("\n\\&.osm\n"), std::string::npos) << page;
  EXPECT_NE(page.find("citykiln bake a\\eb\n"), std::string::npos) << page;
}

TEST(ManPage, LeavesOutHiddenVerbs) {
  std::vector<Verb> verbs = {described_verb("bake"), described_verb("secret")};
  verbs.back().is_hidden = true;
  EXPECT_EQ(man_page(verbs).find("secret"), std::string::npos);
}

}  // namespace
}  // namespace citykiln::commands
