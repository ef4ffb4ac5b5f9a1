#include "compiler/map/buildings/part_heights.h"

#include <algorithm>

#include "compiler/geometry/snap.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/map/buildings/part_outlines.h"

namespace citykiln::map {
namespace {

// Storey heights outside this range mean that building:levels is wrong.
constexpr double kLowestStorey_m = 2.1, kHighestStorey_m = 7;
// The height of a roof with a shape but no height.
constexpr double kPitchedRoof_m = 3;
// The least height of a building whose height follows from storeys.
constexpr double kLeastByLevels_m = 1;

double class_storey_m(const Footprint& f) { return values_of(static_cast<BuildingClass>(f.building_class)).level_m; }

bool has_pitched_roof(const Footprint& f) { return f.has_roof_shape && f.roof.form != roofs::RoofForm::kFlat; }

// The levels of the part itself are meant where they do not exceed those below it.
void set_height_by_levels(Footprint& part) {
  const double below = part.min_levels;
  const double own = part.levels != below ? part.levels : 1;
  const double levels = part.levels > below ? part.levels : below + own;
  part.height_m = snapped(std::max(kLeastByLevels_m, levels * part.storey_m));
}

void complete_part(const Footprint& outline, Footprint& part) {
  const double whole_m = measured_storey_m(outline), own_m = measured_storey_m(part);
  part.storey_m = whole_m > 0 ? whole_m : own_m > 0 ? own_m : class_storey_m(outline);
  const Footprint as_read = part;
  if (part.min_levels > 0) part.min_height_m = snapped(part.min_levels * part.storey_m);
  if (!part.has_roof_in_height && part.levels > 0) set_height_by_levels(part);
  if (part.has_default_height && outline.height_m > part.min_height_m) {
    part.height_m = outline.height_m, part.levels = outline.levels;
    part.has_roof_in_height = outline.has_roof_in_height, part.has_default_height = outline.has_default_height;
  }
  if (part.min_height_m < part.height_m) return;
  part.height_m = as_read.height_m, part.min_height_m = as_read.min_height_m;
}

}  // namespace

double measured_storey_m(const Footprint& footprint) {
  if (!footprint.has_roof_in_height || footprint.levels <= 0) return 0;
  const double assumed_m = has_pitched_roof(footprint) ? kPitchedRoof_m : 0;
  const double roof_m = footprint.roof.height_m > 0 ? footprint.roof.height_m : assumed_m;
  const double storey_m = (footprint.height_m - roof_m) / footprint.levels;
  return storey_m >= kLowestStorey_m && storey_m <= kHighestStorey_m ? storey_m : 0;
}

void complete_parts(std::vector<Footprint>& footprints, std::span<const std::uint32_t> outlines) {
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    const bool are_steps = footprints[i].building_class == static_cast<std::uint8_t>(BuildingClass::kSteps);
    if (outlines[i] != kNoOutline && !are_steps) complete_part(footprints[outlines[i]], footprints[i]);
  }
}

}  // namespace citykiln::map
