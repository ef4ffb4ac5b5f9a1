#include "compiler/ground/surface_map.h"

#include <algorithm>
#include <cmath>

namespace citykiln::ground {
namespace {

// Smaller buckets repeat large surfaces too often; larger ones ask too many borders a question.
constexpr double kBucket_m = 32;

struct BucketRange {
  int first_column, last_column, first_row, last_row;
};

int bucket_index(double offset_m, int count) {
  return static_cast<int>(std::clamp(std::floor(offset_m / kBucket_m), 0.0, count - 1.0));
}

BucketRange buckets_of(const SurfaceMap& map, const Box2& box) {
  return {bucket_index(box.min.x - map.box.min.x, map.columns), bucket_index(box.max.x - map.box.min.x, map.columns),
          bucket_index(box.min.y - map.box.min.y, map.rows), bucket_index(box.max.y - map.box.min.y, map.rows)};
}

Box2 box_of(const Surface& surface) {
  Box2 box;
  for (const Ring& ring : surface.rings)
    for (const Vec2 p : ring) box.grow(p);
  return box;
}

// Calls visit(bucket) for every bucket that the surface's box touches.
template <typename Visit>
void for_each_bucket(const SurfaceMap& map, const Surface& surface, Visit visit) {
  const Box2 box = box_of(surface);
  if (box.is_empty() || !box.touches(map.box)) return;
  const BucketRange range = buckets_of(map, box);
  for (int row = range.first_row; row <= range.last_row; ++row)
    for (int column = range.first_column; column <= range.last_column; ++column)
      visit(static_cast<std::size_t>(row) * map.columns + column);
}

bool covers_point(const Surface& surface, Vec2 p) {
  int winding = 0;
  for (const Ring& ring : surface.rings) winding += winding_number(ring, p);
  return winding > 0;
}

double distance_to_border(const Surface& surface, Vec2 p) {
  double nearest2 = std::numeric_limits<double>::infinity();
  for (const Ring& ring : surface.rings)
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Vec2 along = ring[i] - ring[j];
      const double t = std::clamp(dot(p - ring[j], along) / std::max(dot(along, along), 1e-300), 0.0, 1.0);
      const Vec2 off = p - (ring[j] + along * t);
      nearest2 = std::min(nearest2, dot(off, off));
    }
  return std::sqrt(nearest2);
}

std::span<const std::uint32_t> candidates_at(const SurfaceMap& map, int column, int row) {
  const std::size_t bucket = static_cast<std::size_t>(row) * map.columns + column;
  return std::span(map.bucket_surfaces).subspan(map.bucket_starts[bucket], map.bucket_starts[bucket + 1] - map.bucket_starts[bucket]);
}

}  // namespace

SurfaceMap map_surfaces(std::span<const Surface> surfaces, const Box2& box) {
  SurfaceMap map{surfaces, box, kBucket_m, 0, 0, {}, {}};
  map.columns = std::max(1, static_cast<int>(std::ceil(box.width() / kBucket_m)));
  map.rows = std::max(1, static_cast<int>(std::ceil(box.height() / kBucket_m)));
  // count, sum, fill: each bucket's surfaces end up sorted from the top down
  map.bucket_starts.assign(static_cast<std::size_t>(map.columns) * map.rows + 1, 0);
  std::vector<std::uint32_t> order(surfaces.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return covers(surfaces[a], surfaces[b]); });
  for (const Surface& surface : surfaces)
    for_each_bucket(map, surface, [&](std::size_t bucket) { ++map.bucket_starts[bucket + 1]; });
  for (std::size_t i = 1; i < map.bucket_starts.size(); ++i) map.bucket_starts[i] += map.bucket_starts[i - 1];
  map.bucket_surfaces.resize(map.bucket_starts.back());
  std::vector<std::uint32_t> next(map.bucket_starts.begin(), map.bucket_starts.end() - 1);
  for (const std::uint32_t i : order)
    for_each_bucket(map, surfaces[i], [&](std::size_t bucket) { map.bucket_surfaces[next[bucket]++] = i; });
  return map;
}

std::uint32_t surface_at(const SurfaceMap& map, Vec2 p) {
  const int column = bucket_index(p.x - map.box.min.x, map.columns), row = bucket_index(p.y - map.box.min.y, map.rows);
  for (const std::uint32_t candidate : candidates_at(map, column, row))
    if (covers_point(map.surfaces[candidate], p)) return candidate;
  return kNoSurface;
}

double clearance_m(const SurfaceMap& map, Vec2 p, int priority, double reach_m) {
  double nearest_m = reach_m;
  const BucketRange range = buckets_of(map, {{p.x - reach_m, p.y - reach_m}, {p.x + reach_m, p.y + reach_m}});
  for (int row = range.first_row; row <= range.last_row; ++row)
    for (int column = range.first_column; column <= range.last_column; ++column)
      for (const std::uint32_t candidate : candidates_at(map, column, row)) {
        const Surface& surface = map.surfaces[candidate];
        // sorted from the top down: none of this priority can follow
        if (map::values_of(surface.surface).priority < priority) break;
        if (covers_point(surface, p)) return 0;
        nearest_m = std::min(nearest_m, distance_to_border(surface, p));
      }
  return nearest_m;
}

}  // namespace citykiln::ground
