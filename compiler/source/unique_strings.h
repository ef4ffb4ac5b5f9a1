// A set of strings with consecutive numbers.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace citykiln::source {

/// Numbers distinct strings in order of first use; can renumber them in alphabetical order at the end.
class UniqueStrings {
 public:
  /// Keeps a copy of a text that is new.
  std::uint32_t number_of(std::string_view text);

  /// All strings, sorted by bytes.
  std::vector<std::string> sorted() const;

  /// The index in sorted() of each number.
  std::vector<std::uint32_t> places_in_sorted() const;

 private:
  std::vector<std::uint32_t> numbers_by_alphabet() const;

  std::deque<std::string> texts_;  // by number; a deque, because numbers_ refers to them
  std::unordered_map<std::string_view, std::uint32_t> numbers_;
};

}  // namespace citykiln::source
