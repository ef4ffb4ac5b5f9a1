// Longitudes and latitudes in output files: rounded to the precision of OSM, with the same digits on every machine.
#pragma once

#include <array>
#include <string>

#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// Decimals of a degree in outputs: OSM's grid of 1e-7 degrees, about 1 cm.
inline constexpr int kDegreeDecimals = 7;
/// Decimals for polygons computed in the plane, whose grid is finer than OSM's: with fewer, valid polygons could become
/// invalid.
inline constexpr int kFineDegreeDecimals = 9;

/// Returns an angle in degrees as text with a fixed number of decimals, such as "7.0001000".
std::string degrees_text(double deg, int decimals = kDegreeDecimals);

/// Returns the angle rounded to kDegreeDecimals, as the number that a JSON writer prints without more digits.
double rounded_degrees(double deg);
/// Returns west, south, east and north of a box, each rounded so.
std::array<double, 4> rounded_degrees(const source::LonLatBox& box);

}  // namespace citykiln::map
