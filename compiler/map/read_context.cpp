#include "compiler/map/read_context.h"

#include <algorithm>
#include <cmath>

#include "compiler/map/clip_ring.h"
#include "compiler/map/tag_values.h"

namespace citykiln::map {
namespace {

// Rings that reach far out of the region (a lake, a national park) keep their vertices within this of it.
constexpr double kKeptAround_m = 256;
// And nothing reaches farther than this: a lake's edge that leads across half a continent is cut, a line's stray node
// is brought near. Longer than any segment of a real line, and small beside the 524 km within which ground/ counts
// exactly.
constexpr double kFarthest_m = 65536;

Ring located_ring(const ReadContext& context, const source::AreaRing& ring) {
  Ring points;
  for (const source::Location at : context.osm.points_of(ring)) points.push_back(context.plane.snapped_forward(at));
  points = without_repeats(points);
  if (points.size() < 3) return {};
  const double area = signed_area_m2(points);
  if ((area > 0) != ring.is_outer) std::reverse(points.begin(), points.end());
  return area == 0 ? Ring{} : points;
}

Polygon trimmed(const Polygon& polygon, const Box2& region) {
  const Box2 near = region.widened(kKeptAround_m), far = region.widened(kFarthest_m);
  Polygon kept{clip_ring(trimmed_to(polygon.outer, near), far), {}};
  for (const Ring& hole : polygon.holes)
    if (Ring ring = clip_ring(trimmed_to(hole, near), far); !ring.empty()) kept.holes.push_back(std::move(ring));
  return kept;
}

Vec2 brought_near(Vec2 p, const Box2& region) {
  const Box2 far = region.widened(kFarthest_m);
  return {std::clamp(p.x, far.min.x, far.max.x), std::clamp(p.y, far.min.y, far.max.y)};
}

}  // namespace

LocatedLine located(const ReadContext& context, const source::Way& way) {
  LocatedLine line;
  for (const source::NodeRef& node : context.osm.nodes_of(way)) {
    const Vec2 p = brought_near(context.plane.snapped_forward(node.at), context.region);
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
    located.polygon = trimmed(located.polygon, context.region);
  }
  return polygons;
}

std::optional<double> tagged_length_m(const ReadContext& context, OsmId id, source::Range tags, std::string_view key,
                                      double least_m, double most_m) {
  const std::string_view text = context.tag(tags, key);
  if (text.empty()) return std::nullopt;
  const auto length = length_m_of(text);
  if (length && *length >= least_m && *length <= most_m) return length;
  context.report.add(Code::kBadTagValue, id);
  return std::nullopt;
}

std::int8_t tagged_layer(const ReadContext& context, OsmId id, source::Range tags) {
  const std::string_view text = context.tag(tags, "layer");
  if (text.empty()) return 0;
  const auto layer = number_of(text);
  if (layer && std::abs(*layer) <= 10) return static_cast<std::int8_t>(*layer);
  context.report.add(Code::kBadTagValue, id);
  return 0;
}

Passage tagged_passage(const ReadContext& context, source::Range tags) {
  const std::string_view tunnel = context.tag(tags, "tunnel");
  const bool is_inside = says_yes(context.tag(tags, "indoor")) || context.tag(tags, "location") == "underground" ||
                         context.tag(tags, "highway") == "corridor";
  // a passage through a building runs on the ground below it
  if ((says_yes(tunnel) && tunnel != "building_passage") || is_inside) return Passage::kTunnel;
  return says_yes(context.tag(tags, "bridge")) ? Passage::kBridge : Passage::kGround;
}

bool is_near(const ReadContext& context, const Polyline& line) { return box_of(line).touches(context.region); }

}  // namespace citykiln::map
