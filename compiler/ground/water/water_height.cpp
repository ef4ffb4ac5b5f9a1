#include "compiler/ground/water/water_height.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace citykiln::ground {
namespace {

constexpr double kBucket_m = 32;
// Nearer is on it. Below what a shore's vertices are snapped to.
constexpr double kOn_m = 0x1p-9;

struct Foot {
  double distance_m, share;  // from a to b
};

Foot foot_on(Vec2 a, Vec2 b, Vec2 p) {
  const Vec2 along = b - a;
  const double t = std::clamp(dot(p - a, along) / std::max(dot(along, along), 1e-300), 0.0, 1.0);
  return {distance(p, a + along * t), t};
}

// An axis cut at its vertices and its knots, so that a height is linear along each piece.
void add_pieces(WaterIndex& index, const roads::Strip& stream) {
  const std::vector<double> along = roads::distances_along(stream.axis, stream.start_along_m);
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    const Vec2 a = stream.axis[i], b = stream.axis[i + 1];
    const auto place = [&](double at_m) { return a + (b - a) * ((at_m - along[i]) / (along[i + 1] - along[i])); };
    WaterIndex::Piece piece{a, b, knot_at(stream.profile, along[i]).z_m, 0, reach_m(stream)};
    auto knot = std::ranges::upper_bound(stream.profile, along[i], {}, &Knot::at_m);
    for (; knot != stream.profile.end() && knot->at_m < along[i + 1]; ++knot) {
      piece.b = place(knot->at_m), piece.to_m = knot->z_m;
      index.pieces.push_back(piece);
      piece.a = piece.b, piece.from_m = piece.to_m;
    }
    piece.b = b, piece.to_m = knot_at(stream.profile, along[i + 1]).z_m;
    index.pieces.push_back(piece);
  }
}

void add_shores(WaterIndex& index, const LandCoverPolygon& surface) {
  for (const Ring& ring : surface.rings)
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
      index.shores.push_back({ring[j], ring[i], *surface.level_m});
}

int bucket_of(double offset_m, int count) {
  return static_cast<int>(std::clamp(offset_m / kBucket_m, 0.0, count - 1.0));
}

// Every bucket that the box touches.
template <typename Visit>
void for_each_bucket(WaterIndex& index, const Box2& box, Visit visit) {
  const Box2 all{index.corner, index.corner + Vec2{index.columns * kBucket_m, index.rows * kBucket_m}};
  if (!box.touches(all)) return;
  for (int r = bucket_of(box.min.y - index.corner.y, index.rows);
       r <= bucket_of(box.max.y - index.corner.y, index.rows); ++r)
    for (int c = bucket_of(box.min.x - index.corner.x, index.columns);
         c <= bucket_of(box.max.x - index.corner.x, index.columns); ++c)
      visit(index.buckets[static_cast<std::size_t>(r) * index.columns + c]);
}

void fill_buckets(WaterIndex& index) {
  for (std::uint32_t i = 0; i < index.pieces.size(); ++i) {
    const Box2 box = box_of(std::array{index.pieces[i].a, index.pieces[i].b}).widened(index.pieces[i].reach_m);
    for_each_bucket(index, box, [&](WaterIndex::Bucket& bucket) { bucket.pieces.push_back(i); });
  }
  for (std::uint32_t i = 0; i < index.shores.size(); ++i) {
    const Box2 box = box_of(std::array{index.shores[i].a, index.shores[i].b}).widened(kStandingInfluence_m);
    for_each_bucket(index, box, [&](WaterIndex::Bucket& bucket) { bucket.shores.push_back(i); });
  }
}

struct NearShore {
  double distance_m = kStandingInfluence_m;
  std::optional<double> level_m;
};

// Of two as near, the one whose surface came first.
NearShore nearest_shore(const WaterIndex& index, const WaterIndex::Bucket& bucket, Vec2 p) {
  NearShore nearest;
  for (const std::uint32_t i : bucket.shores) {
    const WaterIndex::Shore& shore = index.shores[i];
    const double d = foot_on(shore.a, shore.b, p).distance_m;
    if (d < nearest.distance_m) nearest = {d, shore.level_m};
  }
  return nearest;
}

// Weights are infinite on an axis and vanish at its reach: those of a ditch's own axis outweigh a wide river's beside
// it.
std::optional<double> running_m(const WaterIndex& index, const WaterIndex::Bucket& bucket, Vec2 p) {
  double sum = 0, weights = 0;
  for (const std::uint32_t i : bucket.pieces) {
    const WaterIndex::Piece& piece = index.pieces[i];
    const Foot foot = foot_on(piece.a, piece.b, p);
    if (foot.distance_m >= piece.reach_m) continue;
    const double nearness = 1 / std::max(foot.distance_m, kOn_m / 8) - 1 / piece.reach_m;
    const double weight = nearness * nearness * nearness * nearness;
    sum += weight * (piece.from_m + (piece.to_m - piece.from_m) * foot.share);
    weights += weight;
  }
  if (weights == 0) return std::nullopt;
  return sum / weights;
}

}  // namespace

double reach_m(const roads::Strip& stream) {
  return std::max(stream.reach_m, 1.25 * std::max(stream.left_m, stream.right_m) + 0.5);
}

WaterIndex index_waters(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams,
                        const Box2& box) {
  WaterIndex index;
  for (const LandCoverPolygon& surface : surfaces)
    if (surface.level_m) index.standing.push_back(surface);
  index.map = index_land_cover(index.standing, box);
  for (const LandCoverPolygon& surface : index.standing) add_shores(index, surface);
  for (const roads::Strip& stream : streams)
    if (!stream.profile.empty()) add_pieces(index, stream);
  index.corner = box.min;
  index.columns = std::max(1, static_cast<int>(std::ceil(box.width() / kBucket_m)));
  index.rows = std::max(1, static_cast<int>(std::ceil(box.height() / kBucket_m)));
  index.buckets.resize(static_cast<std::size_t>(index.columns) * index.rows);
  fill_buckets(index);
  return index;
}

std::optional<double> water_m(const WaterIndex& index, Vec2 p) {
  const int column = bucket_of(p.x - index.corner.x, index.columns), row = bucket_of(p.y - index.corner.y, index.rows);
  const WaterIndex::Bucket& bucket = index.buckets[static_cast<std::size_t>(row) * index.columns + column];
  const NearShore shore = nearest_shore(index, bucket, p);
  if (shore.distance_m <= kOn_m) return shore.level_m;
  const std::uint32_t around = land_cover_at(index.map, p);
  if (around != kNoLandCover) return index.standing[around].level_m;
  if (const auto running = running_m(index, bucket, p)) return running;
  return shore.level_m;
}

}  // namespace citykiln::ground
