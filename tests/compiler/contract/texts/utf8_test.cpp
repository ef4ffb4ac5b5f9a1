#include "compiler/contract/texts/utf8.h"

#include <gtest/gtest.h>

namespace citykiln {
namespace {

TEST(Utf8, CharactersOfAllLengthsAreValid) {
  for (const char* text : {"", "Rue", "é", "«Ω»", "日本", "\xf0\x9f\x8c\xb3", "\x7f", "\xf4\x8f\xbf\xbf"}) {
    EXPECT_TRUE(is_utf8(text)) << text;
    EXPECT_EQ(to_valid_utf8(text), text);
  }
}

TEST(Utf8, OverlongFormsSurrogatesAndCutCharactersAreNot) {
  for (const char* text : {"\x80", "\xc3", "a\xe6\x97", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xf0\x80\x80\xaf",
                           "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80", "\xff"}) {
    EXPECT_FALSE(is_utf8(text)) << text;
    EXPECT_TRUE(is_utf8(to_valid_utf8(text))) << text;
  }
}

TEST(Utf8, OnlyTheWrongBytesAreReplaced) { EXPECT_EQ(to_valid_utf8("é\xff«\xc3"), "é\xef\xbf\xbd«\xef\xbf\xbd"); }

}  // namespace
}  // namespace citykiln
