#include "compiler/map/tags/read_elements.h"

#include <algorithm>

namespace citykiln::map {

std::vector<OsmId> built_elements(const Features& features) {
  std::vector<OsmId> built;
  const auto add = [&](const auto&... kinds) {
    const auto add_kind = [&](const auto& kind) {
      for (const auto& feature : kind) built.push_back(feature.id.osm);
    };
    (add_kind(kinds), ...);
  };
  add(features.tracks, features.footprints, features.areas, features.bridge_areas, features.waterways,
      features.barriers, features.landforms, features.points, features.things, features.supports_beyond,
      features.tree_rows, features.power_lines);
  std::ranges::sort(built);
  return built;
}

std::vector<OsmId> read_elements(const Features& features, const Report& report) {
  std::vector<OsmId> read = built_elements(features);
  for (const Diagnosis& diagnosis : report.diagnoses())
    if (severity_of(diagnosis.code) == Severity::kDropped) read.push_back(diagnosis.object);
  std::ranges::sort(read);
  return read;
}

}  // namespace citykiln::map
