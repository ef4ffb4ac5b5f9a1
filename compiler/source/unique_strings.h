// Keys, values and roles, each kept once.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace citykiln::source {

/// Gives each different string a number, in order of first use; numbers in order of the alphabet can be had at the end.
class UniqueStrings {
 public:
  /// @param text  Must stay where it is for as long as this lives.
  std::uint32_t number_of(std::string_view text);

  /// All strings, sorted by bytes.
  std::vector<std::string> sorted() const;

  /// Place in sorted() of each number.
  std::vector<std::uint32_t> places_in_sorted() const;

 private:
  std::vector<std::uint32_t> numbers_by_alphabet() const;

  std::vector<std::string_view> texts_;
  std::unordered_map<std::string_view, std::uint32_t> numbers_;
};

}  // namespace citykiln::source
