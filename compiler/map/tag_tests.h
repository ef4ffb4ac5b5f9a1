// Comparisons of tags with values, as tables of things and of plants write them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::map {

/// A comparison of a tag with a value. "*" stands for every value except "no", "begin*", "*end" and "*part*" for values
/// with this part. One of several values, separated by ";", is enough.
struct TagTest {
  std::string key, value;
  bool is_equal = true;
};

/// Alternatives, joined by | in a table; each is a list of comparisons, joined by &.
using TagTests = std::vector<std::vector<TagTest>>;

/// Reads the column of tags: tests `key=value` and `key!=value`, joined by & and |. Each alternative begins with an =
/// test. Errors: a test that cannot be read; Error::where stays empty.
Result<TagTests> read_tag_tests(std::string_view text);

/// Returns the whole value of the first tag of the first alternative that fits; nothing if none does.
/// @param value_of  Returns the value of a key, "" if it is not tagged.
std::optional<std::string_view> fitting_value(const TagTests& tests,
                                              const std::function<std::string_view(std::string_view)>& value_of);

}  // namespace citykiln::map
