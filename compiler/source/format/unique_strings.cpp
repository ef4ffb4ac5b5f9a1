#include "compiler/source/format/unique_strings.h"

#include <algorithm>
#include <numeric>

namespace citykiln::source {

std::uint32_t UniqueStrings::number_of(std::string_view text) {
  if (const auto found = numbers_.find(text); found != numbers_.end()) return found->second;
  texts_.emplace_back(text);
  return numbers_.emplace(texts_.back(), static_cast<std::uint32_t>(texts_.size() - 1)).first->second;
}

std::vector<std::uint32_t> UniqueStrings::numbers_by_alphabet() const {
  std::vector<std::uint32_t> numbers(texts_.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  std::sort(numbers.begin(), numbers.end(), [&](std::uint32_t a, std::uint32_t b) { return texts_[a] < texts_[b]; });
  return numbers;
}

std::vector<std::string> UniqueStrings::sorted() const {
  std::vector<std::string> strings;
  strings.reserve(texts_.size());
  for (const std::uint32_t number : numbers_by_alphabet()) strings.push_back(texts_[number]);
  return strings;
}

std::vector<std::uint32_t> UniqueStrings::places_in_sorted() const {
  const std::vector<std::uint32_t> numbers = numbers_by_alphabet();
  std::vector<std::uint32_t> places(numbers.size());
  for (std::uint32_t place = 0; place < numbers.size(); ++place) places[numbers[place]] = place;
  return places;
}

}  // namespace citykiln::source
