// The overlay runs on OSM's own grid: one step of 1e-7° is one step of the plane's grid.
#include "compiler/source/areas/mended_rings.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "compiler/geometry/polygons/overlay.h"
#include "compiler/geometry/snap.h"

namespace citykiln::source {
namespace {

constexpr std::int64_t kWidest_e7 = 50000000;

// Owners of the overlay. Each ring is there in both directions, so that lobes that run clockwise count as well.
constexpr std::uint32_t kInner = 0, kInnerBack = 1, kOuter = 2, kOuterBack = 3, kOwners = 4;

bool is_closed(const AreaLine& line) { return line.points.size() > 3 && line.points.front() == line.points.back(); }

// Moves the line to the end of `chain` if they meet.
bool append_line(AreaLine& chain, AreaLine& line) {
  if (line.points.empty() || is_closed(line) || line.is_inner != chain.is_inner) return false;
  if (line.points.back() == chain.points.back()) std::ranges::reverse(line.points);
  if (line.points.front() != chain.points.back()) return false;
  chain.points.insert(chain.points.end(), line.points.begin() + 1, line.points.end());
  line.points.clear();
  return true;
}

void extend(AreaLine& chain, std::vector<AreaLine>& lines) {
  const auto grows = [&] { return std::ranges::any_of(lines, [&](AreaLine& l) { return append_line(chain, l); }); };
  while (!is_closed(chain) && grows()) {
  }
}

struct Corner {
  std::int64_t lon_e7 = 0, lat_e7 = 0;
};

Ring grid_ring(const AreaLine& ring, Corner origin) {
  Ring points;
  for (std::size_t i = 0; i + 1 < ring.points.size(); ++i)
    points.push_back(Vec2{static_cast<double>(ring.points[i].lon_e7 - origin.lon_e7),
                          static_cast<double>(ring.points[i].lat_e7 - origin.lat_e7)} *
                     kQuantum_m);
  return points;
}

std::vector<Location> places_of_grid_ring(const Ring& ring, Corner origin) {
  std::vector<Location> places;
  for (const Vec2 p : ring) {
    const GridPoint at = grid_point(p);
    places.push_back(
        {static_cast<std::int32_t>(at.x + origin.lon_e7), static_cast<std::int32_t>(at.y + origin.lat_e7)});
  }
  std::rotate(places.begin(), std::ranges::min_element(places), places.end());
  return places;
}

// The south-western corner of the rings; nothing wider than kWidest_e7 has one.
std::optional<Corner> corner_of(std::span<const AreaLine> rings) {
  std::vector<Location> all;
  for (const AreaLine& ring : rings) all.insert(all.end(), ring.points.begin(), ring.points.end());
  if (all.empty() || all.size() > kMostMended) return std::nullopt;
  const auto [west, east] = std::ranges::minmax(all, {}, &Location::lon_e7);
  const auto [south, north] = std::ranges::minmax(all, {}, &Location::lat_e7);
  const std::int64_t width = std::int64_t{east.lon_e7} - west.lon_e7,
                     height = std::int64_t{north.lat_e7} - south.lat_e7;
  if (std::max(width, height) > kWidest_e7) return std::nullopt;
  return Corner{west.lon_e7, south.lat_e7};
}

}  // namespace

std::vector<AreaLine> joined_lines(std::vector<AreaLine> lines) {
  std::vector<AreaLine> joined;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].points.empty()) continue;
    AreaLine chain = std::exchange(lines[i], {});
    if (!is_closed(chain)) {
      extend(chain, lines);
      std::ranges::reverse(chain.points);
      extend(chain, lines);
    }
    joined.push_back(std::move(chain));
  }
  return joined;
}

std::vector<MendedPolygon> mended_polygons(std::span<const AreaLine> rings) {
  const std::optional<Corner> origin = corner_of(rings);
  if (!origin) return {};
  std::vector<OwnedSegment> segments;
  for (const AreaLine& ring : rings) {
    if (!is_closed(ring)) continue;
    Ring points = grid_ring(ring, *origin);
    if (signed_area_m2(points) < 0) std::ranges::reverse(points);
    add_ring(segments, points, ring.is_inner ? kInner : kOuter);
    std::ranges::reverse(points);
    add_ring(segments, points, ring.is_inner ? kInnerBack : kOuterBack);
  }
  std::vector<std::vector<Polygon>> areas = overlay(segments, kOwners);
  std::vector<MendedPolygon> mended;
  for (const std::uint32_t owner : {kOuter, kOuterBack})
    for (const Polygon& polygon : areas[owner]) {
      MendedPolygon& places = mended.emplace_back();
      for (const Ring* ring : rings_of(polygon)) places.push_back(places_of_grid_ring(*ring, *origin));
    }
  std::ranges::sort(mended);
  return mended;
}

}  // namespace citykiln::source
