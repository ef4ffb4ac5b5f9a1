#include "compiler/assume/styles.h"

namespace citykiln::assume {

std::vector<map::Footprint> assume_styles(std::span<const map::Footprint> footprints, Report& report) {
  std::vector<map::Footprint> styled(footprints.begin(), footprints.end());
  for (map::Footprint& footprint : styled) {
    footprint.assumed |= bit_of(Assumption::kStyles);
    if (!footprint.has_parts) report.count_assumed(Assumption::kStyles, footprint.id.osm);
  }
  return styled;
}

}  // namespace citykiln::assume
