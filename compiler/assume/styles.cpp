#include "compiler/assume/styles.h"

namespace citykiln::assume {

map::Features assume_styles(map::Features features, Report& report) {
  for (map::Footprint& footprint : features.footprints) {
    footprint.assumed |= bit_of(Assumption::kStyles);
    if (!footprint.has_parts) report.count_assumed(Assumption::kStyles, footprint.id.osm);
  }
  return features;
}

}  // namespace citykiln::assume
