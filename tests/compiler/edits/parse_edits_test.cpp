#include "compiler/edits/parse_edits.h"

#include <gtest/gtest.h>

#include <set>

namespace citykiln::edits {
namespace {

Edit edit_of(const std::string& line) {
  const Result<Edits> edits = parse_edits(line, "a.edits");
  EXPECT_TRUE(edits) << to_string(edits.error());
  return edits && !edits->lines.empty() ? edits->lines.front() : Edit{};
}

struct WrongLine {
  std::string line, error;
};

const std::vector<WrongLine> kWrong = {
    {"w12x drop", R"(1: expected an id such as w123, n5 or r7, or several such as w123,w124, found "w12x")"},
    {"w1,building drop", R"(4: expected an id such as w123, n5 or r7, or several such as w123,w124, found "building")"},
    {"w1 delete",
     R"(4: expected drop, set, remove, move or place after the filter, found "delete" at the end of the line)"},
    {"w1 moove 1,2", R"(4: expected drop, set, remove, move or place, found "moove"; did you mean move?)"},
    {"drop", R"(1: expected a filter, such as w123 or building=garage, or add, found "drop")"},
    {"w1 set", R"(4: expected a tag such as height=12 after "set", found the end of the line)"},
    {"w1 set height", R"(8: expected a tag such as height=12, found "height")"},
    {"w1 set height=", R"(8: expected a value after = ("remove height" takes a tag away), found "height=")"},
    {"w1 set drop", R"(8: expected a tag such as height=12, found "drop")"},
    {"w1 set height=3 name=A height=4", R"(24: expected height once in a line, found "height=4")"},
    {"w1 drop set height=3", R"(9: expected drop as the only change of a line, found "set")"},
    {"w1 move 1,2 drop", R"(13: expected drop as the only change of a line, found "drop")"},
    {"w1 remove height=3", R"(11: expected the key of a tag without its value, such as height, found "height=3")"},
    {"w1 move 3", R"(9: expected east,north in metres, up to 10000, such as 2.5,-1, found "3")"},
    {"w1 move", R"(4: expected east,north in metres after "move", found the end of the line)"},
    {"w1 place 7,43", R"(4: expected the id of one node alone before "place", found "place")"},
    {"n1 place 43,700", R"(10: expected longitude,latitude in degrees, such as 7.42,43.73, found "43,700")"},
    {"building= drop", R"(10: expected a value between = and , or after it, found "")"},
    {"building!=* drop", R"(11: expected a value after !=; elements without a key are !key, found "*")"},
    {"highway=a*b drop", R"(9: expected * at the begin or the end of a value, found "a*b")"},
    {"x/building drop", R"(1: expected types n, w, r or a before "/", found "x")"},
    {"height>3 drop",
     R"(1: expected key, key=value, key=value,value, key!=value or n/key (types n, w, r, a before the key), found "height>3")"},
    {"building and highway drop",
     R"(10: expected words of a filter side by side, all of which must fit ("a,b" lists values), found "and")"},
    {"box=7,43,6,44 drop",
     R"(5: expected west,south,east,north in degrees, such as box=7.41,43.72,7.43,43.74, found "7,43,6,44")"},
    {"near=7,43 drop", R"(6: expected longitude,latitude,metres, such as near=7.42,43.73,200, found "7,43")"},
    {"name=\"Rue drop", R"(6: expected " at the end of the text, found the end of the line)"},
    {"add", R"(1: expected n, w or a (a node, a line, an area) after "add", found the end of the line)"},
    {"add x 7,43 natural=tree", R"(5: expected n, w or a (a node, a line, an area) after "add", found "x")"},
    {"add n natural=tree", R"(5: expected one place such as 7.42,43.73 of "add n", found 0)"},
    {"add n 7,43 8,44 natural=tree", R"(7: expected one place such as 7.42,43.73 of "add n", found 2)"},
    {"add n n5 natural=tree",
     R"(7: expected a place of the new node, such as 7.42,43.73 (a node of the map is changed by "n5 set"), found "n5")"},
    {"add w 7,43 highway=path", R"(7: expected at least two points of "add w", found 1)"},
    {"add w 7,43 w5 highway=path", R"(12: expected a place such as 7.42,43.73 or a node such as n5, found "w5")"},
    {"add w 7,43 7,44", R"(12: expected tags such as highway=footway after "7,44", found the end of the line)"},
    {"add w 7,43 highway 7,44",
     R"(12: expected a place such as 7.42,43.73, a node such as n5, or a tag such as highway=footway, found "highway")"},
    {"\xff drop", R"(1: expected text in UTF-8, found other bytes)"},
};

TEST(ParseEdits, NamesPlaceAndFaultOfEachWrongLine) {
  for (const WrongLine& wrong : kWrong) {
    const Result<Edits> edits = parse_edits("# a comment\n" + wrong.line + "\n", "dir/a.edits");
    ASSERT_FALSE(edits) << wrong.line;
    EXPECT_EQ(to_string(edits.error()), "dir/a.edits:2:" + wrong.error) << wrong.line;
  }
}

TEST(ParseEdits, ColumnsCountCharacters) {
  const Result<Edits> edits = parse_edits("name=Grünstraße set höhe\n", "a");
  ASSERT_FALSE(edits);
  EXPECT_EQ(edits.error().where, "a:1:21");
}

TEST(ParseEdits, SkipsCommentsAndEmptyLines) {
  const Result<Edits> edits =
      parse_edits("\xef\xbb\xbf# a\r\n\n  w1 drop # why\r\n\tw2 set colour=#fff\n", "x/a.edits");
  ASSERT_TRUE(edits);
  ASSERT_EQ(edits->lines.size(), 2U);
  EXPECT_EQ(edits->lines[0].line, 3U);
  EXPECT_EQ(edits->lines[0].column, 3U);
  EXPECT_EQ(edits->lines[1].changes.set.at(0).second, "#fff");
  EXPECT_EQ(edits->name, "a.edits");
}

TEST(ParseEdits, QuotationMarksHoldBlanksAndSeparators) {
  const Edit edit = edit_of(R"(name="Bar, \"Grill\"",b set note="a=b, c")");
  EXPECT_EQ(edit.filter.at(0).values, (std::vector<std::string>{"Bar, \"Grill\"", "b"}));
  EXPECT_EQ(edit.changes.set.at(0).second, "a=b, c");
}

TEST(ParseEdits, WordsOfTablesHaveTheSpellingOfMapsThatWereRead) {
  const Edit edit = edit_of("building=\"Mixed Use\" set surface=Asphalt name=\"A B\"");
  EXPECT_EQ(edit.filter.at(0).values.at(0), "mixed_use");
  EXPECT_EQ(edit.changes.set.at(0).second, "asphalt");
  EXPECT_EQ(edit.changes.set.at(1).second, "A B");
}

TEST(ParseEdits, ALineHasSeveralChanges) {
  const Edit edit = edit_of("w1,n2 !area set a=b c=d remove e f* move 1.5,-2");
  EXPECT_EQ(edit.filter.at(0).ids.size(), 2U);
  EXPECT_TRUE(edit.filter.at(1).is_negated);
  EXPECT_EQ(edit.changes.set.size(), 2U);
  EXPECT_EQ(edit.changes.removed, (std::vector<std::string>{"e", "f*"}));
  EXPECT_EQ(edit.changes.moved_m->y, -2);
  EXPECT_FALSE(edit.changes.is_dropped);
  EXPECT_TRUE(edit_of("w1,n2 drop").changes.is_dropped);
}

TEST(ParseEdits, IdsOfNewElementsDependOnTypeAndPointsAlone) {
  const auto id_of = [](const std::string& text, std::size_t line = 0) {
    return parse_edits(text, "a")->lines.at(line).added->id;
  };
  const OsmId tree = id_of("add n 7,43 natural=tree");
  EXPECT_EQ(tree, id_of("w1 drop\nadd n 7,43 natural=tree height=3", 1));
  EXPECT_EQ(tree, id_of("add n 7.0,43.0 highway=stop"));
  EXPECT_EQ(tree.type, OsmType::kNode);
  std::set<OsmId> ids = {tree,
                         id_of("add n 7,43 a=b\nadd n 7,43 a=b", 1),
                         id_of("add w 7,43 8,44 9,43 a=b"),
                         id_of("add a 7,43 8,44 9,43 a=b"),
                         id_of("add w 8,44 7,43 9,43 a=b"),
                         id_of("add w n7 8,44 9,43 a=b")};
  EXPECT_EQ(ids.size(), 6U);
  for (const OsmId id : ids) EXPECT_LE(id.id, -(std::int64_t{1} << 60));
}

TEST(ParseEdits, OtherTextsHaveOtherSources) {
  EXPECT_EQ(source_text(*parse_edits("w1 drop", "x/a.edits")).substr(0, 18), "a.edits (1 edits, ");
  EXPECT_NE(source_text(*parse_edits("w1 drop", "a")), source_text(*parse_edits("w2 drop", "a")));
}

TEST(ParseEdits, BoundsMoves) {
  EXPECT_EQ(longest_move_m(*parse_edits("w1 move 3,4\nw2 move 6,8\nw3 drop", "a")), 15);
  EXPECT_EQ(longest_move_m(*parse_edits("n1 place 7,43\nn2 place 7,43", "a")), 1000);
}

}  // namespace
}  // namespace citykiln::edits
