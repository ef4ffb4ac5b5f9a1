// The footprints of real towns and their roof tags.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compiler/map/locate.h"
#include "compiler/source/read_osm.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::roofs {

struct TaggedFootprint {
  ObjectId id;
  Polygon footprint;
  std::optional<RoofForm> form;
  std::string tag;
};

inline std::map<OsmId, std::string> tagged_shapes(const source::OsmData& osm) {
  std::map<OsmId, std::string> shapes;
  for (const source::Area& area : osm.areas)
    if (const auto shape = osm.value_of(area.tags, "roof:shape"); !shape.empty()) shapes[area.from] = shape;
  return shapes;
}

inline std::vector<TaggedFootprint> footprints_of(const std::string& path) {
  Report report;
  const auto osm = source::read_osm(path, 2, report);
  if (!osm) return {};
  const source::LonLatBox box = map::choose_box(*osm, {});
  const map::Plane plane(map::default_origin(box));
  const map::Features features = map::locate(*osm, plane, box, {}, report);
  const auto shapes = tagged_shapes(*osm);
  std::vector<TaggedFootprint> told;
  for (const map::Footprint& f : features.footprints) {
    const auto shape = shapes.find(f.id.osm);
    told.push_back({f.id, f.polygon, {}, ""});
    if (shape == shapes.end()) continue;
    told.back().tag = shape->second;
    told.back().form = form_named(shape->second);
  }
  return told;
}

/// The outline of the land cover area whose number of corners is nearest to `corners`. No building has 400 corners.
inline Polygon outline_of(const std::string& path, std::size_t corners) {
  Report report;
  const auto osm = source::read_osm(path, 2, report);
  if (!osm) return {};
  const source::LonLatBox box = map::choose_box(*osm, {});
  const map::Plane plane(map::default_origin(box));
  const map::Features features = map::locate(*osm, plane, box, {}, report);
  const auto off = [&](const Polygon& polygon) {
    std::size_t count = polygon.outer.size();
    for (const Ring& ring : polygon.holes) count += ring.size();
    return count > corners ? count - corners : corners - count;
  };
  const auto best = std::min_element(features.areas.begin(), features.areas.end(),
                                     [&](const auto& a, const auto& b) { return off(a.polygon) < off(b.polygon); });
  return best == features.areas.end() ? Polygon{} : best->polygon;
}

}  // namespace citykiln::roofs
