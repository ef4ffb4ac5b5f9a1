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

/// Areas of fields and of meadows that are mapped one by one (assumed_lands.h), beside the median of those into which
/// their land is divided, and fields a km² of such farmland. A mapped field that ways and watercourses divide counts as
/// several. There is a value for each of them.
std::vector<Sample> tagged_field_sizes(const Place& place);
std::vector<Sample> tagged_meadow_sizes(const Place& place);
Values built_field_sizes(const map::Features& features);
std::vector<Sample> tagged_fields_per_km2(const Place& place);
Values built_fields_per_km2(const map::Features& features);

/// Borders between fields: whether one is within 15 m, at places of a grid of 16 m on such land that are farther than
/// that from ways and watercourses. Each land has as many places at borders as elsewhere, spread evenly: borders at
/// random places have a balanced accuracy of 0.5.
std::vector<Sample> tagged_field_borders(const Place& place);
Values built_field_borders(const map::Features& features);

/// Rows of trees, and hedges, along half of a side of a road or more. The roads are primary to unclassified ones that
/// have farmland or no land use on both sides and houses along less than a tenth, within 256 m of a mapped tree or
/// hedge: elsewhere the map has none.
std::vector<Sample> tagged_avenues(const Place& place);
Values built_avenues(const map::Features& features);
std::vector<Sample> tagged_lane_hedges(const Place& place);
Values built_lane_hedges(const map::Features& features);

/// Grass, gardens and flowerbeds (no), and paved squares, footway areas and platforms (yes), of 60 to 4000 m², of which
/// at least 5 m² lie within 8 m behind the kerb of a street, before a wall at most 12 m behind it. Built is the share
/// of these places that a pavement of the street reaches; paved fronts of yards do not count.
std::vector<Sample> tagged_frontages(const Place& place);
Values built_frontages(const map::Features& features);

/// Courts: green (yes) or paved (no) areas of lots/courts.h with no street within 12 m of their middle, and walls
/// within 30 m of it in at least five of eight directions. Built is the kind of court at that place, 0.55 where lots
/// draw it.
std::vector<Sample> tagged_courts(const Place& place);
Values built_courts(const map::Features& features);

}  // namespace citykiln::charts
