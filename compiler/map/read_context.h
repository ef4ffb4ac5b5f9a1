// An element's tags and nodes, seen from the plane: what the readers of tracks, footprints, areas and points have in
// common.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/map/features.h"
#include "compiler/map/plane.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// The extract, and where its elements come to lie.
struct ReadContext {
  const source::OsmData& osm;
  const Plane& plane;
  Box2 region;
  Report& report;

  std::string_view tag(source::Range tags, std::string_view key) const { return osm.value_of(tags, key); }
};

/// A line of the plane and the nodes it was made from: snapped, without repeated neighbours.
struct LocatedLine {
  Polyline axis;
  std::vector<std::int64_t> node_ids;   ///< Of each point.
  std::vector<std::uint32_t> vertices;  ///< The point of each node of the way.
};
LocatedLine located(const ReadContext& context, const source::Way& way);

/// The polygons of an area, each with the number of its part: snapped, without repeats, oriented, trimmed to what is
/// near the region. What lost its area is gone.
struct LocatedPolygon {
  std::uint32_t part = 0;
  Polygon polygon;
  double area_m2 = 0;  ///< Before trimming.
};
std::vector<LocatedPolygon> located(const ReadContext& context, const source::Area& area);

/// A length from a tag: nothing where it is absent; diagnosed kBadTagValue where it cannot be read or lies outside
/// least … most.
std::optional<double> tagged_length_m(const ReadContext& context, OsmId id, source::Range tags, std::string_view key,
                                      double least_m, double most_m);

/// layer=*, between -10 and 10; 0 where absent.
std::int8_t tagged_layer(const ReadContext& context, OsmId id, source::Range tags);

/// Bridge, tunnel or neither.
Passage tagged_passage(const ReadContext& context, source::Range tags);

/// The box of a line or polygon touches the region.
bool is_near(const ReadContext& context, const Polyline& line);

}  // namespace citykiln::map
