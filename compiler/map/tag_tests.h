// Comparisons of tags with values, as tables of things and of plants write them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::map {

/// A comparison of a tag with a value; "*" stands for every value except "no".
struct TagTest {
  std::string key, value;
  bool is_equal = true;
};

/// Alternatives, joined by | in a table; each is a list of comparisons, joined by &.
using TagTests = std::vector<std::vector<TagTest>>;

/// Reads the column of tags: `key=value`, `key!=value`, `key=*` or `key=begin*`, joined by & and |. Error: without a
/// place.
Result<TagTests> read_tag_tests(std::string_view text);

/// Returns the value of the first tag that is tested; nothing if no alternative fits.
/// @param value_of  Returns the value of a key, "" if it is not tagged.
std::optional<std::string_view> fitting_value(const TagTests& tests,
                                              const std::function<std::string_view(std::string_view)>& value_of);

}  // namespace citykiln::map
