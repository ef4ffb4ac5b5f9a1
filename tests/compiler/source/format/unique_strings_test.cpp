// Numbers of distinct strings.
#include "compiler/source/format/unique_strings.h"

#include <gtest/gtest.h>

namespace citykiln::source {
namespace {

TEST(UniqueStrings, AreNumberedInOrderOfUseAndSortedAtTheEnd) {
  UniqueStrings strings;
  EXPECT_EQ(strings.number_of("way"), 0u);
  EXPECT_EQ(strings.number_of("node"), 1u);
  EXPECT_EQ(strings.number_of("way"), 0u);
  EXPECT_EQ(strings.sorted(), (std::vector<std::string>{"node", "way"}));
  EXPECT_EQ(strings.places_in_sorted(), (std::vector<std::uint32_t>{1, 0}));
}

// buffers of a decoded file are freed before the strings are sorted
TEST(UniqueStrings, OutliveTheTextsThatTheyWereMadeOf) {
  UniqueStrings strings;
  for (const char letter : {'b', 'a', 'b'}) {
    std::string text(100, letter);
    strings.number_of(text);
    text.assign(100, 'x');
  }
  EXPECT_EQ(strings.sorted(), (std::vector{std::string(100, 'a'), std::string(100, 'b')}));
}

}  // namespace
}  // namespace citykiln::source
