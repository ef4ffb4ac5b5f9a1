// Tag values as numbers: lengths, counts, colours. Unreadable values give nothing; the caller diagnoses them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "compiler/map/features.h"

namespace citykiln::map {

/// Returns "12", "12.5 m", "12,5", "40 ft", "5'10\"", "0.3 km" in metres; the first of "2;3". Nothing for what is no
/// finite number below 10 km.
std::optional<double> length_m_of(std::string_view value);
/// Returns a number without a unit; the first of "2;3".
std::optional<double> number_of(std::string_view value);
/// Returns "#rgb", "#rrggbb" or a CSS colour name used in OSM.
std::optional<Srgb> colour_of(std::string_view value);
/// Returns "225", "SW", "south-west" as degrees clockwise of north, 0 to below 360.
std::optional<double> bearing_deg_of(std::string_view value);
/// Returns the year of "1898", "1898-05-01", "~1900", "before 1850", "C19", "late C18", "1920s": the middle of the
/// period. Nothing outside 1 to 2999.
std::optional<std::uint16_t> year_of(std::string_view value);
/// True for every value except "no", "0", "false" and "".
bool says_yes(std::string_view value);

/// Returns the row whose `value` is the word, or null.
template <typename Row, std::size_t n>
const Row* row_with(const Row (&rows)[n], std::string_view value) {
  for (const Row& row : rows)
    if (row.value == value) return &row;
  return nullptr;
}

}  // namespace citykiln::map
