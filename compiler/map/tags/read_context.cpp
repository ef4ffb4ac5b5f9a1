#include "compiler/map/tags/read_context.h"

#include <algorithm>
#include <cassert>

#include "compiler/geometry/polygons/clip_polyline.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/plane/clip_ring.h"
#include "compiler/map/tags/standing.h"
#include "compiler/map/tags/tag_values.h"

namespace citykiln::map {
namespace {

// Rings much larger than the extent (a lake, a national park) keep their vertices within this distance.
constexpr double kKeptAround_m = 256;
// Maximum distance of anything from the extent: rings are clipped there, stray nodes of lines are moved there. Longer
// than any real segment, and well within the 524 km in which ground/ computes exactly.
constexpr double kFarthest_m = 65536;

Ring located_ring(const ReadContext& context, const source::AreaRing& ring) {
  Ring points;
  points.reserve(context.osm.points_of(ring).size());
  for (const source::Location at : context.osm.points_of(ring)) points.push_back(context.plane.snapped_forward(at));
  points = without_repeats(points);
  if (points.size() < 3) return {};
  const double area = signed_area_m2(points);
  if ((area > 0) != ring.is_outer) std::reverse(points.begin(), points.end());
  return area == 0 ? Ring{} : points;
}

Polygon trimmed_to_region(const Polygon& polygon, const Box2& extent) {
  const Box2 near = extent.widened(kKeptAround_m), far = extent.widened(kFarthest_m);
  Polygon kept{clip_ring(trimmed_to(polygon.outer, near), far), {}};
  for (const Ring& hole : polygon.holes)
    if (Ring ring = clip_ring(trimmed_to(hole, near), far); !ring.empty()) kept.holes.push_back(std::move(ring));
  return kept;
}

Vec2 brought_near(Vec2 p, const Box2& extent) {
  const Box2 far = extent.widened(kFarthest_m);
  return {std::clamp(p.x, far.min.x, far.max.x), std::clamp(p.y, far.min.y, far.max.y)};
}

}  // namespace

LocatedLine located(const ReadContext& context, const source::Way& way) {
  LocatedLine line;
  const std::size_t n = context.osm.nodes_of(way).size();
  line.axis.reserve(n), line.node_ids.reserve(n), line.vertices.reserve(n);
  for (const source::NodeRef& node : context.osm.nodes_of(way)) {
    const Vec2 p = brought_near(context.plane.snapped_forward(node.at), context.extent);
    if (line.axis.empty() || line.axis.back() != p) {
      line.axis.push_back(p);
      line.node_ids.push_back(node.id);
    }
    line.vertices.push_back(static_cast<std::uint32_t>(line.axis.size() - 1));
  }
  return line;
}

std::vector<LocatedPolygon> located(const ReadContext& context, const source::Area& area) {
  std::vector<LocatedPolygon> polygons;
  bool lost = false;
  for (const source::AreaRing& ring : context.osm.rings_of(area)) {
    Ring points = located_ring(context, ring);
    if (ring.is_outer) lost = points.empty();
    if (points.empty() || lost) continue;
    if (ring.is_outer)
      polygons.push_back({ring.part, {std::move(points), {}}, 0});
    else if (!polygons.empty())
      polygons.back().polygon.holes.push_back(std::move(points));
  }
  for (LocatedPolygon& located : polygons) {
    located.area_m2 = area_m2(located.polygon);
    located.polygon = trimmed_to_region(located.polygon, context.extent);
  }
  return polygons;
}

std::optional<double> number_within(const ReadContext& context, OsmId id, std::string_view key, std::string_view text,
                                    double least, double most) {
  return parsed_text(context, id, key, text, [&](std::string_view value) {
    const auto number = number_of(value);
    return number && *number >= least && *number <= most ? number : std::nullopt;
  });
}

std::optional<double> tagged_length_m(const ReadContext& context, OsmId id, source::Range tags, std::string_view key,
                                      double least_m, double most_m) {
  assert(least_m <= most_m);
  return parsed_tag(context, id, tags, key, [&](std::string_view text) {
    const auto length = length_m_of(text);
    return length && *length >= least_m && *length <= most_m ? length : std::nullopt;
  });
}

std::int8_t tagged_layer(const ReadContext& context, OsmId id, source::Range tags) {
  return static_cast<std::int8_t>(number_within(context, id, "layer", context.tag(tags, "layer"), -10, 10).value_or(0));
}

Passage tagged_passage(const ReadContext& context, source::Range tags) {
  const std::string_view tunnel = context.tag(tags, "tunnel");
  const Storey storey = standing_of_object(context.osm, tags, "highway").storey;
  const bool is_inside =
      storey == Storey::kUnderground || storey == Storey::kIndoor || context.tag(tags, "highway") == "corridor";
  const bool is_bridge = says_yes(context.tag(tags, "bridge")) && storey != Storey::kUnderground;
  // a bridge from house to house is no corridor, and a passage through a building is on the ground
  if (is_bridge && !says_yes(tunnel)) return Passage::kBridge;
  if ((says_yes(tunnel) && tunnel != "building_passage") || is_inside) return Passage::kTunnel;
  return is_bridge ? Passage::kBridge : Passage::kGround;
}

bool is_near(const ReadContext& context, const Polyline& line) { return box_of(line).touches(context.extent); }

void diagnose_cut(const ReadContext& context, OsmId id, const Polyline& line) {
  const Box2 box = box_of(line);
  if (context.extent.contains(box.min) && context.extent.contains(box.max)) return;
  double outside_m = length_m(line);
  for (const Polyline& part : clipped_to(line, context.extent, kMapStep_m)) outside_m -= length_m(part);
  context.report.add(Code::kCutAtBounds, id, std::max(0.0, snapped_to(kMapStep_m, outside_m)));
}

}  // namespace citykiln::map
