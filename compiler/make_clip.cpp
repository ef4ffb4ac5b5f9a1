#include "compiler/make_clip.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/snap.h"

namespace citykiln {
namespace {

Ring ring_in_plane(const source::LonLatRing& ring, const map::Plane& plane, bool is_hole) {
  Ring points;
  for (const LonLat at : ring)
    points.push_back(plane.snapped_forward({static_cast<std::int32_t>(std::lround(at.lon_deg * 1e7)),
                                            static_cast<std::int32_t>(std::lround(at.lat_deg * 1e7))}));
  points = without_repeats(points);
  if ((signed_area_m2(points) > 0) == is_hole) std::ranges::reverse(points);
  return points;
}

// The clip about all recipes, with a margin for those beside it.
Box2 box_around(const scene::Clip& clip) {
  Box2 box;
  for (const Polygon& polygon : clip)
    for (const Vec2 p : polygon.outer) box.grow(p);
  return box.widened(1);
}

// Tests places anywhere: those off the box of the clip are outside.
struct AnyPlace {
  Box2 box;
  scene::ClipTest test;
  explicit AnyPlace(const scene::Clip& clip) : box(box_around(clip)), test(clip, box) {}
  bool is_inside(Vec2 place) const { return box.contains(place) && test.is_inside(place); }
};

// The shares of a segment at which it crosses the rings of a clip, sorted, with 0 and 1.
std::vector<double> crossings_of(Vec2 from, Vec2 to, const scene::Clip& clip) {
  std::vector<double> shares = {0, 1};
  const Box2 box = box_of_segment(from, to);
  for (const Polygon& polygon : clip)
    for (const Ring* ring : rings_of(polygon))
      for (std::size_t i = 0; i < ring->size(); ++i) {
        const Vec2 a = (*ring)[i], b = (*ring)[(i + 1) % ring->size()];
        if (!box_of_segment(a, b).touches(box)) continue;
        const double below = cross(to - from, b - a);
        if (below == 0) continue;
        const double share = cross(a - from, b - a) / below, on_edge = cross(a - from, to - from) / below;
        if (share > 0 && share < 1 && on_edge >= 0 && on_edge <= 1) shares.push_back(share);
      }
  std::ranges::sort(shares);
  return shares;
}

// The parts of a line inside of a clip.
std::vector<Polyline> parts_inside(const Polyline& line, const scene::Clip& clip, const AnyPlace& places) {
  std::vector<Polyline> parts;
  bool is_open = false;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 from = line[i], way = line[i + 1] - line[i];
    const std::vector<double> shares = crossings_of(from, line[i + 1], clip);
    for (std::size_t s = 0; s + 1 < shares.size(); ++s) {
      const auto at = [&](double share) {
        return share == 1 ? line[i + 1] : snapped_to(map::kMapStep_m, from + way * share);
      };
      const Vec2 begin = at(shares[s]), end = at(shares[s + 1]);
      if (begin == end) continue;
      const bool is_inside = places.is_inside(from + way * ((shares[s] + shares[s + 1]) / 2));
      if (is_inside && !is_open) parts.push_back({begin});
      if (is_inside) parts.back().push_back(end);
      is_open = is_inside;
    }
  }
  return parts;
}

std::vector<props::Barrier> cut_barriers(const std::vector<props::Barrier>& barriers, const scene::Clip& clip,
                                         const AnyPlace& places) {
  std::vector<props::Barrier> cut;
  for (const props::Barrier& barrier : barriers)
    for (Polyline& part : parts_inside(barrier.axis, clip, places)) {
      cut.push_back(barrier);
      cut.back().axis = std::move(part);
    }
  return cut;
}

// Elements with their largest building inside.
std::map<OsmId, bool> kept_elements(const std::vector<buildings::Building>& buildings, const AnyPlace& places) {
  std::map<OsmId, std::pair<double, bool>> largest;
  for (const buildings::Building& building : buildings) {
    auto& [most_m2, is_inside] = largest[building.id.osm];
    const double own_m2 = area_m2(building.footprint);
    if (own_m2 <= most_m2) continue;
    most_m2 = own_m2, is_inside = places.is_inside(centroid(building.footprint));
  }
  std::map<OsmId, bool> kept;
  for (const auto& [element, found] : largest) kept[element] = found.second;
  return kept;
}

}  // namespace

scene::Clip make_clip(const CompileSpec& spec, const map::Plane& plane) {
  scene::Clip clip;
  if (!spec.clip) return clip;
  for (const source::LonLatPolygon& polygon : spec.clip->polygons) {
    Polygon in_plane{ring_in_plane(polygon.outer, plane, false), {}};
    for (const source::LonLatRing& hole : polygon.holes)
      if (Ring ring = ring_in_plane(hole, plane, true); ring.size() >= 3) in_plane.holes.push_back(std::move(ring));
    if (in_plane.outer.size() >= 3) clip.push_back(std::move(in_plane));
  }
  return clip;
}

StandingRecipes within_clip(StandingRecipes recipes, const scene::Clip& clip) {
  if (clip.empty()) return recipes;
  const AnyPlace places(clip);
  const std::map<OsmId, bool> kept = kept_elements(recipes.buildings, places);
  std::erase_if(recipes.buildings, [&](const auto& building) { return !kept.at(building.id.osm); });
  const auto is_outside = [&](const auto& standing) { return !places.is_inside(standing.at); };
  std::erase_if(recipes.trees, is_outside);
  std::erase_if(recipes.lamps, is_outside);
  std::erase_if(recipes.things, is_outside);
  std::erase_if(recipes.wire_spans, [&](const wires::WireSpan& span) {
    return !places.is_inside(in_plan(span.wires.front().from)) || !places.is_inside(in_plan(span.wires.front().to));
  });
  recipes.barriers = cut_barriers(recipes.barriers, clip, places);
  return recipes;
}

}  // namespace citykiln
