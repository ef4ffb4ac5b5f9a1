#include "compiler/invent/town/blocks/footprints.h"

#include <algorithm>

#include "compiler/geometry/polygons/clip_polygon.h"
#include "compiler/geometry/polygons/offset_polygon.h"
#include "compiler/geometry/ring_crossing.h"
#include "compiler/geometry/segment.h"
#include "compiler/invent/town/streets/street_graph.h"

namespace citykiln::invent {
namespace {

constexpr double kLeastRow_m2 = 28;

Ring ring_on_grid(const Ring& ring) {
  Ring snapped;
  for (const Vec2 p : ring) snapped.push_back(on_place_grid(p));
  return without_repeats(snapped);
}

const Polygon* largest_of(const std::vector<Polygon>& polygons) {
  const Polygon* largest = nullptr;
  for (const Polygon& polygon : polygons)
    if (!largest || area_m2(polygon) > area_m2(*largest)) largest = &polygon;
  return largest;
}

// for each edge of a ring: the depth if it lies on an edge of the lot that is a front, else 0
std::vector<double> front_depths(const TownLot& lot, const Ring& ring, double from_m, double depth_m) {
  std::vector<double> depths;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()], middle = (a + b) * 0.5;
    bool is_on_street = false;
    for (std::size_t k = 0; k < lot.ring.size() && !is_on_street; ++k) {
      if (!lot.is_on_street[k]) continue;
      const Vec2 c = lot.ring[k], d = lot.ring[(k + 1) % lot.ring.size()];
      const bool is_along = dot(unit(b - a), unit(d - c)) > 0.97;
      is_on_street = is_along && distance_to_segment(c, d, middle) < from_m + 0.2;
    }
    depths.push_back(is_on_street ? depth_m : 0);
  }
  return depths;
}

}  // namespace

Ring box_ring(const TownLot& lot, const HouseBox& box) {
  const Vec2 u = lot.along(), n = lot.inward();
  const Vec2 corner = (lot.from + lot.to) * 0.5 + u * (box.aside_m - box.width_m / 2) + n * box.setback_m;
  const Vec2 across = u * box.width_m, back = n * box.depth_m;
  return ring_on_grid(Ring{corner, corner + across, corner + across + back, corner + back});
}

bool lies_within(const Ring& ring, const Ring& outer, double margin_m) {
  if (borders_touch(ring, outer)) return false;
  const bool is_in = std::ranges::all_of(
      ring, [&](Vec2 p) { return winding_number(outer, p) != 0 && distance_to_ring(outer, p) >= margin_m; });
  return is_in && std::ranges::all_of(outer, [&](Vec2 p) { return distance_to_ring(ring, p) >= margin_m; });
}

std::optional<Ring> fitted_box(const TownLot& lot, HouseBox box, double margin_m) {
  const HouseBox wanted = box;
  for (const double share : {1.0, 0.9, 0.8, 0.7, 0.6, 0.5})
    for (const double aside : {1.0, 0.0, -1.0, 0.5}) {
      box.width_m = wanted.width_m * share;
      box.depth_m = wanted.depth_m * std::max(share, 0.7);
      box.aside_m = wanted.aside_m * aside;
      const Ring ring = box_ring(lot, box);
      if (ring.size() == 4 && lies_within(ring, lot.ring, margin_m)) return ring;
    }
  return std::nullopt;
}

Ring row_ring(const TownLot& lot, double setback_m, double depth_m) {
  const Polygon whole{lot.ring, {}};
  const OffsetPolygon behind = inset(whole, front_depths(lot, lot.ring, 0, setback_m));
  const Polygon* plot = setback_m > 0 ? largest_of(behind.moved) : &whole;
  if (!plot) return {};
  const std::vector<double> depths = front_depths(lot, plot->outer, setback_m, depth_m);
  const OffsetPolygon split = inset(Polygon{plot->outer, {}}, depths);
  std::vector<Ring> bands;
  for (std::size_t i = 0; i < plot->outer.size() && i < split.bands.size(); ++i)
    if (depths[i] > 0)
      for (const Polygon& band : split.bands[i]) bands.push_back(band.outer);
  const std::vector<Polygon> united_bands = united(bands);
  const Polygon* house = largest_of(united_bands);
  if (!house || area_m2(*house) < kLeastRow_m2) return {};
  const Ring ring = ring_on_grid(house->outer);
  return ring.size() >= 4 && is_simple(ring) && signed_area_m2(ring) > kLeastRow_m2 ? ring : Ring{};
}

}  // namespace citykiln::invent
