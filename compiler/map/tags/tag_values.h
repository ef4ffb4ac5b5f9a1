// Parses tag values: lengths, numbers, colours, years. Functions return nothing for unreadable values, which the caller
// diagnoses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/map/features.h"

namespace citykiln::map {

/// Returns a length such as "12", "12.5 m", "12,5 M", "40 ft", "5'10\"", "40′", "480\"", "90 cm", "0.3 km" in
/// metres; the first of "2;3". Nothing unless it is a finite number below 10 km.
std::optional<double> length_m_of(std::string_view value);
/// Returns a number without a unit; the first one of "2;3".
std::optional<double> number_of(std::string_view value);
/// Returns the colour of "#rgb", "#rgba", "#rrggbb", "#rrggbbaa", "rgb(178, 50, 40)", "rgb(70% 20% 16%)", "rgba(…)" or
/// a name of colours.inc; the first of "red;white" or "red/white". Opacity is ignored.
std::optional<Srgb> colour_of(std::string_view value);
/// Returns a bearing such as "225", "225°", "SW", "south-west" in degrees clockwise of north, 0 to below 360.
std::optional<double> bearing_deg_of(std::string_view value);
/// Returns the year of a date such as "1898", "1898-05-01", "~1900", "before 1850", "C19", "late C18", "1920s"; for a
/// period its middle. Nothing outside 1 to 2999.
std::optional<std::uint16_t> year_of(std::string_view value);
/// Returns the text with a to z in place of A to Z; all other characters stay.
std::string in_lower_case(std::string_view text);
/// Returns the words of a value such as "Brick; natural stone", "dirt/sand" or "wood,_metal", in their order, in lower
/// case and with "_" for spaces and hyphens, as the tables of values have them: "brick", "natural_stone". Words are
/// separated by ";", "," or "/".
std::vector<std::string> words_of(std::string_view value);
/// True for "yes", "no", "other", "unknown", "many", "mixed" and other words that name no kind.
bool is_indefinite(std::string_view word);
/// True for every value except "no", "0", "false" and "".
bool says_yes(std::string_view value);

/// Returns the row whose member `value` is the word, or null.
template <typename Row, std::size_t n>
const Row* row_with(const Row (&rows)[n], std::string_view value) {
  for (const Row& row : rows)
    if (row.value == value) return &row;
  return nullptr;
}

/// Returns the first result of find(word), over words_of() the value in order, that is not empty; nothing if all are.
/// @param find  Takes a std::string_view and returns a std::optional.
template <typename Find>
auto first_known(std::string_view value, Find find) -> decltype(find(std::string_view())) {
  for (const std::string& word : words_of(value))
    if (auto found = find(std::string_view(word))) return found;
  return std::nullopt;
}

}  // namespace citykiln::map
