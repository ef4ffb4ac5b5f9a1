// Tags as numbers: lengths, counts, colours. A value that cannot be read is nothing, and the caller diagnoses it.
#pragma once

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
/// "yes", "1", "true" and every value but "no", "0", "false" and "".
bool says_yes(std::string_view value);

}  // namespace citykiln::map
