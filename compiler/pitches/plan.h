// Plans sports pitches: how many fit into each sports area, how large they are, and where they are.
#pragma once

#include <vector>

#include "compiler/map/features.h"
#include "compiler/map/things/thing_table.h"
#include "compiler/pitches/recipe.h"

namespace citykiln::pitches {

/// Returns the pitches of one area.
///
/// The frame is the smallest rectangle around the area. The first row of the sport counts of which a pitch fits: one in
/// the middle along the longer side or, with a row that has a space for courts, as many as fit, in equal cells of the
/// rectangle. A pitch of which less than kInside of its ground lies in the area is left out.
///
/// @param sports  sport=*: the first value of which a pitch fits counts.
std::vector<Pitch> pitches_of(ObjectId id, const Polygon& area, std::string_view sports);

/// The share of a pitch's ground that must lie in its area.
inline constexpr double kInside = 0.94;

/// The pitches of a map, and the things that stand on them.
struct PitchPlan {
  std::vector<Pitch> pitches;                ///< Sorted by id.
  std::vector<map::ThingFeature> equipment;  ///< Sorted by id.
};

/// Returns the pitches of all areas with a sport, with their equipment as far as the table of things has it.
PitchPlan plan(const map::FeatureView& features, const map::ThingTable& table);

/// Returns the pitches of all areas with a sport, sorted by id.
std::vector<Pitch> plan_pitches(const map::FeatureView& features);

/// Returns the equipment of pitches as things, sorted by id. Equipment without a row in the table is left out, and any
/// within 5 m of a mapped thing of its kind.
std::vector<map::ThingFeature> things_of(const std::vector<Pitch>& pitches, const map::ThingTable& table,
                                         const map::FeatureView& features);

}  // namespace citykiln::pitches
