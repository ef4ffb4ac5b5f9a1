#include "exporters/tags_json.h"

#include <gtest/gtest.h>

namespace citykiln::exporters {
namespace {

TEST(TagsJson, IsAnObjectOfStringsWithoutSpaces) {
  EXPECT_EQ(tags_text({{"highway", "residential"}, {"name", "Rue \"A\""}}),
            R"({"highway":"residential","name":"Rue \"A\""})");
  EXPECT_EQ(tags_text({{"note", "a\nb\\"}}), R"({"note":"a\u000ab\\"})");
  EXPECT_EQ(tags_text({}), "");
}

TEST(TagsJson, ReadsBackWhatItWrote) {
  for (const map::TagList& tags : {map::TagList{},
                                   {{"building", "yes"}},
                                   {{"", ""}},
                                   {{"name", "«Ω» \"日本\" \t\x01\\"}, {"name:en", ""}, {"ref", "{}"}}})
    EXPECT_EQ(tags_in(tags_text(tags)), tags) << tags_text(tags);
}

TEST(TagsJson, RefusesAllButObjectsOfStrings) {
  for (const char* text : {"{", "[]", "null", R"({"a":1})", R"({"a":{"b":"c"}})",
                           R"({"a":"b"} )"
                           "x",
                           R"({"a":"\u0000"})"})
    EXPECT_FALSE(tags_in(text)) << text;
}

}  // namespace
}  // namespace citykiln::exporters
