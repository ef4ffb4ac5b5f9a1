// A set of strings that gives each one a number.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace citykiln::source {

/// Numbers distinct strings in order of first use. At the end the numbers can be replaced by alphabetical positions.
class UniqueStrings {
 public:
  /// Returns the number of a text, and stores a copy of it if it is new.
  std::uint32_t number_of(std::string_view text);

  /// Returns all strings, sorted by bytes.
  std::vector<std::string> sorted() const;

  /// Returns for each number the index of its string in sorted().
  std::vector<std::uint32_t> places_in_sorted() const;

 private:
  std::vector<std::uint32_t> numbers_by_alphabet() const;

  std::deque<std::string> texts_;  // by number; a deque, because numbers_ refers to them
  std::unordered_map<std::string_view, std::uint32_t> numbers_;
};

}  // namespace citykiln::source
