// Looks up the climate of a place on Earth.
#pragma once

#include "compiler/climate/climate_mix.h"

namespace citykiln::climate {

/// Returns the class of the half degree that contains a place; at sea, that of the nearest half degree of land.
/// Distances are those of a plane whose degrees of longitude have their length at the place.
///
/// Total: longitudes are taken modulo 360, latitudes clamped to ±90. Cost: some microseconds on land, up to a
/// millisecond far out at sea. Source: climate_cells.inc.
ClimateClass climate_at(double lon_deg, double lat_deg);

/// Returns the classes of the four half degrees about a place, weighted bilinearly by the distances of their centres,
/// so that shares change gradually. Half degrees of sea do not count; where all four are sea, the result is the class
/// of climate_at(). Total, as climate_at() is.
ClimateMix climate_mix_at(double lon_deg, double lat_deg);

}  // namespace citykiln::climate
