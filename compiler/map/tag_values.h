// Tags as numbers: lengths, counts, colours. A value that cannot be read is nothing, and the caller diagnoses it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "compiler/map/features.h"

namespace citykiln::map {

/// "12", "12.5 m", "12,5", "40 ft", "5'10\"", "0.3 km" in metres; of "2;3" the first. Nothing for what is not a finite
/// number or not below 10 km.
std::optional<double> length_m_of(std::string_view value);
/// A number without a unit; of "2;3" the first.
std::optional<double> number_of(std::string_view value);
/// "#rgb", "#rrggbb" or one of the colours of CSS that OSM uses.
std::optional<Srgb> colour_of(std::string_view value);
/// "225", "SW", "south-west" as degrees clockwise of north, 0 to below 360.
std::optional<double> bearing_deg_of(std::string_view value);
/// "1898", "1898-05-01", "~1900", "before 1850", "C19", "late C18", "1920s" as a year, the middle of what is meant;
/// nothing for what names none between 1 and 2999.
std::optional<std::uint16_t> year_of(std::string_view value);
/// "yes", "1", "true" and every value but "no", "0", "false" and "".
bool says_yes(std::string_view value);

}  // namespace citykiln::map
