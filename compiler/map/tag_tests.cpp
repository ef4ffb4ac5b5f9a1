#include "compiler/map/tag_tests.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/contract/texts/parse.h"
#include "compiler/source/format/plain_words.h"

namespace citykiln::map {
namespace {

Error wrong_tags(std::string_view expected, std::string_view found) {
  return {"", fmt::format("tags: expected {}, found \"{}\"", expected, found)};
}

Result<TagTest> test_of(std::string_view text) {
  const std::size_t at = text.find('=');
  const bool is_equal = at == std::string_view::npos || at == 0 || text[at - 1] != '!';
  const std::size_t key_end = at != std::string_view::npos && !is_equal ? at - 1 : at;
  if (at == std::string_view::npos || key_end == 0 || at + 1 == text.size())
    return wrong_tags("key=value, key!=value or key=*, several joined by & and |", text);
  // in the spelling of the map's values
  const std::string_view key = text.substr(0, key_end);
  return TagTest{std::string(key), source::plain_word(key, text.substr(at + 1)), is_equal};
}

// "maxspeed*" fits values that begin with "maxspeed", "*274*" those that contain "274".
bool fits_value(std::string_view pattern, std::string_view value) {
  const bool is_begin_open = pattern.starts_with('*'), is_end_open = pattern.ends_with('*');
  if (is_begin_open) pattern.remove_prefix(1);
  if (is_end_open && !pattern.empty()) pattern.remove_suffix(1);
  if (is_begin_open && is_end_open) return value.find(pattern) != std::string_view::npos;
  if (is_begin_open) return value.ends_with(pattern);
  return is_end_open ? value.starts_with(pattern) : value == pattern;
}

bool is_true(const TagTest& test, std::string_view value) {
  if (test.value == "*") return test.is_equal == (!value.empty() && value != "no");
  // one of several values, such as "bench;waste_basket"
  for (const std::string_view one : split(value, ';'))
    if (!one.empty() && fits_value(test.value, one)) return test.is_equal;
  return !test.is_equal;
}

}  // namespace

Result<TagTests> read_tag_tests(std::string_view text) {
  TagTests any;
  for (const std::string_view part : split(text, '|')) {
    std::vector<TagTest>& all = any.emplace_back();
    for (const std::string_view one : split(part, '&')) {
      Result<TagTest> test = test_of(one);
      if (!test) return test.error();
      all.push_back(std::move(*test));
    }
    if (!all.front().is_equal) return wrong_tags("key=value before key!=value", part);
  }
  return any;
}

std::optional<std::string_view> fitting_value(const TagTests& tests,
                                              const std::function<std::string_view(std::string_view)>& value_of) {
  for (const std::vector<TagTest>& all : tests)
    if (std::ranges::all_of(all, [&](const TagTest& test) { return is_true(test, value_of(test.key)); }))
      return value_of(all.front().key);
  return std::nullopt;
}

}  // namespace citykiln::map
