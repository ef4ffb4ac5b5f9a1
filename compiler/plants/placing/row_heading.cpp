#include "compiler/plants/placing/row_heading.h"

#include "compiler/map/row_direction.h"

namespace citykiln::plants {
namespace {

// Rows on flatter fields follow the border.
constexpr double kLeastSlope = 0.03;

// Slope samples along each side of the bounding box.
constexpr int kSlopeSamples = 16;

int winding_of(const ground::LandCoverPolygon& surface, Vec2 p) {
  int winding = 0;
  for (const Ring& ring : surface.rings) winding += winding_number(ring, p);
  return winding;
}

Vec2 mean_slope(const ground::LandCoverPolygon& surface, const map::Heightfield& terrain) {
  Box2 box;
  for (const Ring& ring : surface.rings)
    for (const Vec2 p : ring) box.grow(p);
  Vec2 sum;
  int count = 0;
  for (int i = 0; i < kSlopeSamples * kSlopeSamples; ++i) {
    const Vec2 p = {box.min.x + box.width() * (i % kSlopeSamples + 0.5) / kSlopeSamples,
                    box.min.y + box.height() * (i / kSlopeSamples + 0.5) / kSlopeSamples};
    if (winding_of(surface, p) <= 0) continue;
    const Vec3 normal = map::normal_at(terrain, p);
    sum = sum + in_plan(normal) * (1 / normal.z), ++count;
  }
  return count > 0 ? sum * (1.0 / count) : Vec2{};
}

Vec2 longest_edge(const ground::LandCoverPolygon& surface) {
  Vec2 longest{1, 0};
  double most = 0;
  for (const Ring& ring : surface.rings)
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
      if (const Vec2 edge = ring[i] - ring[j]; dot(edge, edge) > most) longest = edge, most = dot(edge, edge);
  return longest;
}

}  // namespace

std::uint8_t row_heading(const ground::LandCoverPolygon& surface, const map::Heightfield& terrain) {
  const Vec2 slope = mean_slope(surface, terrain);
  const Vec2 along = length(slope) >= kLeastSlope ? left_of(slope) : longest_edge(surface);
  return map::row_heading_along(along);
}

}  // namespace citykiln::plants
