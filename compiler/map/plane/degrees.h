// The form of a longitude or latitude in outputs: the digits that the map has, on every machine.
#pragma once

#include <array>
#include <string>

#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// Decimals of a degree in outputs: OSM's grid of 1e-7 degrees, about 1 cm.
inline constexpr int kDegreeDecimals = 7;
/// Decimals for shapes in the plane, which has a finer grid: valid polygons stay valid.
inline constexpr int kFineDegreeDecimals = 9;

/// Returns the angle with a fixed number of decimals, such as "7.0001000".
std::string degrees_text(double deg, int decimals = kDegreeDecimals);

/// Returns the number that a JSON writer prints with at most kDegreeDecimals decimals.
double rounded_degrees(double deg);
/// Returns west, south, east and north, each as rounded_degrees().
std::array<double, 4> rounded_degrees(const source::LonLatBox& box);

}  // namespace citykiln::map
