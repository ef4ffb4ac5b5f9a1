// Classes of the Köppen-Geiger climate classification, and how their year looks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace citykiln::climate {

/// The classes of climate_classes.inc. Their order is part of the manifest's format.
enum class ClimateClass : std::uint8_t {
#define CLIMATE(name, ...) k##name,
#include "compiler/climate/climate_classes.inc"
  kCount
};
inline constexpr std::size_t kClimateClasses = static_cast<std::size_t>(ClimateClass::kCount);

/// A month of a hemisphere's year, 1 to 12: 1 is January in the north and July in the south.
enum class LocalMonth : std::uint8_t {};

/// The class as in publications: "Cfb".
std::string_view name_of(ClimateClass climate);

/// The class of a name of this form; kCount for other texts.
ClimateClass climate_named(std::string_view name);

/// True for classes with cold winters (D and E), which species of high mountains grow in at any altitude.
bool has_cold_winters(ClimateClass climate);

/// Returns the month, 1 to 12, in which leaves and fields of central Europe look like those of this class in `month`;
/// 6 in the tropics.
std::uint8_t equivalent_month(ClimateClass climate, LocalMonth month);

/// The share of grass without irrigation that is straw in a month, within 0 … 1.
double straw_share(ClimateClass climate, LocalMonth month);

/// The share of ground without irrigation on which nothing grows, within 0 … 1.
double bare_share(ClimateClass climate);

/// True if the ground is usually under snow in a month, at the altitudes for which the table has this class.
bool is_under_snow(ClimateClass climate, LocalMonth month);

}  // namespace citykiln::climate
