// The values of streets and buildings that the chart of assumptions compares: as tagged, and as built.
#pragma once

#include <vector>

#include "tests/charts/assumed_place.h"
#include "tests/charts/assumed_samples.h"

namespace citykiln::charts {

/// A kind of values.
struct Subject {
  const char* name;
  const char* unit;  ///< "" for values of yes and no.
  LeftOut left_out;
  bool is_yes_or_no;
  /// The values that tags of the place state.
  std::vector<Sample> (*tagged)(const Place& place);
  /// The values that are built of features.
  Values (*built)(const map::Features& features);
};

/// Pavements of streets, for each side. The tag `separate` counts as a pavement, and so does a mapped path that runs
/// beside most of the street.
std::vector<Sample> tagged_pavements(const Place& place);
Values built_pavements(const map::Features& features);

/// The light of streets: 1 if they are lit.
std::vector<Sample> tagged_lit(const Place& place);
Values built_lit(const map::Features& features);

/// Widths of carriageways.
std::vector<Sample> tagged_widths(const Place& place);
Values built_widths(const map::Features& features);

/// Lamps a kilometre of streets, the median distance along the street from one lamp to the next, and whether most lamps
/// stand on the left. Streets with at least three mapped lamps and 60 m count; a lamp belongs to the street whose edge
/// is nearest.
std::vector<Sample> tagged_lamps_per_km(const Place& place);
Values built_lamps_per_km(const map::Features& features);
std::vector<Sample> tagged_lamp_spacings(const Place& place);
Values built_lamp_spacings(const map::Features& features);
std::vector<Sample> tagged_lamp_sides(const Place& place);
Values built_lamp_sides(const map::Features& features);

/// Heights of buildings from the ground to the highest point of the roof, on level ground: of buildings with height=*.
std::vector<Sample> tagged_heights(const Place& place);
Values built_heights(const map::Features& features);

/// Storeys of buildings with building:levels=*. Roofs without walls, parts, and outlines with parts count neither here
/// nor among heights.
std::vector<Sample> tagged_storeys(const Place& place);
Values built_storeys(const map::Features& features);

}  // namespace citykiln::charts
