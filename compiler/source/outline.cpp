#include "compiler/source/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include "compiler/source/outline_formats.h"

namespace citykiln::source {
namespace {

// A place on OSM's grid of 1e-7 degrees, on which tests are exact for edges of up to kLongestEdge_deg.
struct GridPlace {
  std::int64_t x = 0, y = 0;
  auto operator<=>(const GridPlace&) const = default;
};
constexpr double kPlaceStep_deg = 1e-7, kLongestEdge_deg = 90;

GridPlace grid_place(LonLat at) {
  return {std::llround(at.lon_deg / kPlaceStep_deg), std::llround(at.lat_deg / kPlaceStep_deg)};
}

std::int64_t turn_of(GridPlace a, GridPlace b, GridPlace c) {
  const std::int64_t value = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return (value > 0) - (value < 0);
}

// An edge of a ring, from the lower to the higher end.
struct RingEdge {
  GridPlace low, high;
  std::size_t ring = 0, number = 0;
};

bool is_between(GridPlace p, const RingEdge& e) {
  return std::min(e.low.x, e.high.x) <= p.x && p.x <= std::max(e.low.x, e.high.x) &&
         std::min(e.low.y, e.high.y) <= p.y && p.y <= std::max(e.low.y, e.high.y);
}

bool lies_on(GridPlace p, const RingEdge& e) { return turn_of(e.low, e.high, p) == 0 && is_between(p, e); }

// True if edges cross in their insides.
bool are_crossing(const RingEdge& a, const RingEdge& b) {
  return turn_of(a.low, a.high, b.low) * turn_of(a.low, a.high, b.high) < 0 &&
         turn_of(b.low, b.high, a.low) * turn_of(b.low, b.high, a.high) < 0;
}

// The number of common points that edges have at their ends, 2 where they overlap.
int touches_of(const RingEdge& a, const RingEdge& b) {
  std::vector<GridPlace> common;
  for (const GridPlace p : {b.low, b.high})
    if (lies_on(p, a)) common.push_back(p);
  for (const GridPlace p : {a.low, a.high})
    if (lies_on(p, b)) common.push_back(p);
  std::ranges::sort(common);
  common.erase(std::unique(common.begin(), common.end()), common.end());
  return static_cast<int>(common.size());
}

// All rings of an outline, with the number of their polygon.
struct NumberedRing {
  const LonLatRing* points = nullptr;
  std::size_t polygon = 0, hole = 0;  // hole 0: the outer ring
};

std::vector<NumberedRing> numbered_rings(const Outline& outline) {
  std::vector<NumberedRing> rings;
  for (std::size_t p = 0; p < outline.polygons.size(); ++p) {
    rings.push_back({&outline.polygons[p].outer, p, 0});
    for (std::size_t h = 0; h < outline.polygons[p].holes.size(); ++h)
      rings.push_back({&outline.polygons[p].holes[h], p, h + 1});
  }
  return rings;
}

std::string name_of(const NumberedRing& ring) {
  const std::string polygon = fmt::format("polygon {}", ring.polygon + 1);
  return ring.hole == 0 ? polygon : fmt::format("{}, hole {}", polygon, ring.hole);
}

std::string text_of(LonLat at) { return fmt::format("{:.7g},{:.7g}", at.lon_deg, at.lat_deg); }

Error at_point(const Outline& outline, const NumberedRing& ring, std::size_t point, std::string message) {
  return {fmt::format("{}: {}, point {} ({})", outline.where, name_of(ring), point + 1, text_of((*ring.points)[point])),
          std::move(message)};
}

bool lies_on_earth(LonLat at) { return std::abs(at.lon_deg) <= 360 && std::abs(at.lat_deg) <= 90; }

// Points on Earth, at least three different ones, and no edge that is too long.
Result<Done> check_points(const Outline& outline, const NumberedRing& ring) {
  const LonLatRing& points = *ring.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (lies_on_earth(points[i])) continue;
    const bool is_swapped = lies_on_earth({points[i].lat_deg, points[i].lon_deg});
    return at_point(outline, ring, i,
                    fmt::format("is not on Earth; expected longitude, then latitude, in degrees{}",
                                is_swapped ? "; latitude and longitude swapped?" : ""));
  }
  std::vector<GridPlace> places;
  std::ranges::transform(points, std::back_inserter(places), grid_place);
  std::ranges::sort(places);
  const std::size_t different = static_cast<std::size_t>(std::unique(places.begin(), places.end()) - places.begin());
  if (different < 3)
    return Error{fmt::format("{}: {}", outline.where, name_of(ring)),
                 fmt::format("expected at least 3 different points, found {}", different)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const LonLat next = points[(i + 1) % points.size()];
    if (std::abs(next.lon_deg - points[i].lon_deg) > kLongestEdge_deg)
      return at_point(outline, ring, i, fmt::format("expected edges of at most {} degrees", kLongestEdge_deg));
  }
  return Done{};
}

std::vector<RingEdge> edges_of(const std::vector<NumberedRing>& rings) {
  std::vector<RingEdge> edges;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const LonLatRing& points = *rings[r].points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const GridPlace a = grid_place(points[i]), b = grid_place(points[(i + 1) % points.size()]);
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), r, i});
    }
  }
  std::ranges::sort(edges, {}, [](const RingEdge& e) { return std::pair(e.low, e.high); });
  return edges;
}

bool are_neighbours(const RingEdge& a, const RingEdge& b, const std::vector<NumberedRing>& rings) {
  if (a.ring != b.ring) return false;
  const std::size_t count = rings[a.ring].points->size(),
                    apart = a.number > b.number ? a.number - b.number : b.number - a.number;
  return apart == 1 || apart == count - 1;
}

// True if a pair of edges makes an outline invalid: they cross or overlap, or those of one ring touch elsewhere than at
// the common end of neighbours.
bool are_invalid(const RingEdge& a, const RingEdge& b, const std::vector<NumberedRing>& rings) {
  if (are_crossing(a, b)) return true;
  const int touches = touches_of(a, b);
  if (touches == 0) return false;
  if (touches == 2) return true;
  return a.ring == b.ring && !are_neighbours(a, b, rings);
}

// Edges whose ranges in x overlap are compared. Cost: O(n log n) for outlines that are not all above each other.
Result<Done> check_crossings(const Outline& outline, const std::vector<NumberedRing>& rings) {
  const std::vector<RingEdge> edges = edges_of(rings);
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    std::erase_if(open, [&](std::size_t k) { return edges[k].high.x < edges[i].low.x; });
    for (const std::size_t k : open) {
      const RingEdge &a = edges[k], &b = edges[i];
      if (std::max(a.low.y, a.high.y) < std::min(b.low.y, b.high.y) ||
          std::max(b.low.y, b.high.y) < std::min(a.low.y, a.high.y) || !are_invalid(a, b, rings))
        continue;
      const RingEdge &first = std::pair(a.ring, a.number) < std::pair(b.ring, b.number) ? a : b,
                     &second = &first == &a ? b : a;
      return at_point(outline, rings[first.ring], first.number,
                      fmt::format("the edge from here crosses or touches the one from {}, point {} ({})",
                                  name_of(rings[second.ring]), second.number + 1,
                                  text_of((*rings[second.ring].points)[second.number])));
    }
    open.push_back(i);
  }
  return Done{};
}

// True if a place is inside of a ring; on its edge either.
bool is_in_ring(const LonLatRing& ring, LonLat at) {
  bool is_inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const LonLat a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.lat_deg > at.lat_deg) == (b.lat_deg > at.lat_deg)) continue;
    const double lon = a.lon_deg + (at.lat_deg - a.lat_deg) / (b.lat_deg - a.lat_deg) * (b.lon_deg - a.lon_deg);
    if (at.lon_deg < lon) is_inside = !is_inside;
  }
  return is_inside;
}

// A hole whose points are all outside of its outer ring. Rings that do not cross are inside or outside as a whole.
Result<Done> check_holes(const Outline& outline, const std::vector<NumberedRing>& rings) {
  for (const NumberedRing& ring : rings) {
    if (ring.hole == 0) continue;
    const LonLatRing& outer = outline.polygons[ring.polygon].outer;
    if (std::ranges::none_of(*ring.points, [&](LonLat at) { return is_in_ring(outer, at); }))
      return Error{fmt::format("{}: {}", outline.where, name_of(ring)), "lies outside of its polygon"};
  }
  return Done{};
}

}  // namespace

Result<Done> check_outline(const Outline& outline) {
  if (outline.polygons.empty()) return Error{outline.where, "has no polygon"};
  const std::vector<NumberedRing> rings = numbered_rings(outline);
  for (const NumberedRing& ring : rings)
    if (const Result<Done> done = check_points(outline, ring); !done) return done;
  if (const Result<Done> done = check_crossings(outline, rings); !done) return done;
  return check_holes(outline, rings);
}

Result<Outline> parse_outline(std::string_view text, const std::string& name) {
  const bool is_geojson = name.ends_with(".json") || name.ends_with(".geojson");
  Result<Outline> outline = is_geojson ? parse_geojson_outline(text, name) : parse_poly_outline(text, name);
  if (!outline) return outline;
  if (const Result<Done> done = check_outline(*outline); !done) return done.error();
  return outline;
}

Result<Outline> read_outline(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{path, "cannot be read"};
  std::ostringstream text;
  text << file.rdbuf();
  return parse_outline(text.str(), path);
}

LonLatBox box_of(const Outline& outline) {
  const LonLat first = outline.polygons.front().outer.front();
  LonLatBox box{first.lon_deg, first.lat_deg, first.lon_deg, first.lat_deg};
  for (const LonLatPolygon& polygon : outline.polygons)
    for (const LonLat at : polygon.outer) {
      box.west = std::min(box.west, at.lon_deg), box.east = std::max(box.east, at.lon_deg);
      box.south = std::min(box.south, at.lat_deg), box.north = std::max(box.north, at.lat_deg);
    }
  return box;
}

}  // namespace citykiln::source
