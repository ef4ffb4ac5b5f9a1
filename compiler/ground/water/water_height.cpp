#include "compiler/ground/water/water_height.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/geometry/segment.h"

namespace citykiln::ground {
namespace {

constexpr double kWaterBucket_m = 32;
// Places nearer than this are on the shore; less than the grid that its vertices are snapped to.
constexpr double kOn_m = 0x1p-9;

struct Foot {
  double distance_m, share;  // from a to b
};

Foot foot_on(Vec2 a, Vec2 b, Vec2 p) {
  const double share = nearest_share(a, b, p);
  return {distance(p, a + (b - a) * share), share};
}

// Adds an axis cut at its vertices and knots, so that the height is linear along each piece.
void add_pieces(WaterIndex& index, const roads::Strip& stream) {
  const std::vector<double> along = roads::distances_along(stream.axis, stream.start_along_m);
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    const Vec2 a = stream.axis[i], b = stream.axis[i + 1];
    const auto place = [&](double at_m) { return a + (b - a) * ((at_m - along[i]) / (along[i + 1] - along[i])); };
    WaterIndex::Piece piece{a, b, knot_at(stream.profile, along[i]).z_m, 0, influence_radius_m(stream)};
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

// Returns the box that a piece influences, within the box of the index.
Box2 influenced_box(const Box2& box, Vec2 a, Vec2 b, double influence_radius_m) {
  const Box2 near = box_of_segment(a, b).widened(influence_radius_m);
  return {{std::max(near.min.x, box.min.x), std::max(near.min.y, box.min.y)},
          {std::min(near.max.x, box.max.x), std::min(near.max.y, box.max.y)}};
}

// Drops pieces that influence nothing in the box and indexes the rest.
template <typename Part, typename RadiusOf>
BoxGrid index_near(std::vector<Part>& parts, const Box2& box, RadiusOf influence_radius_of) {
  const auto near = [&](const Part& part) { return influenced_box(box, part.a, part.b, influence_radius_of(part)); };
  std::erase_if(parts, [&](const Part& part) { return near(part).is_empty(); });
  std::vector<Box2> boxes;
  for (const Part& part : parts) boxes.push_back(near(part));
  return grid_of(boxes, kWaterBucket_m);
}

struct NearShore {
  double distance_m = kStandingInfluence_m;
  std::optional<double> level_m;
};

// On a tie the shore of the first polygon counts.
NearShore nearest_shore(const WaterIndex& index, Vec2 p) {
  NearShore nearest;
  for (const std::uint32_t i : boxes_about(index.shores_grid, p)) {
    const WaterIndex::Shore& shore = index.shores[i];
    const double d = foot_on(shore.a, shore.b, p).distance_m;
    if (d < nearest.distance_m) nearest = {d, shore.level_m};
  }
  return nearest;
}

// Weights are infinite on an axis and 0 at its radius, so a ditch's own axis outweighs a wide river's beside it.
std::optional<double> running_m(const WaterIndex& index, Vec2 p) {
  double sum = 0, weights = 0;
  for (const std::uint32_t i : boxes_about(index.pieces_grid, p)) {
    const WaterIndex::Piece& piece = index.pieces[i];
    const Foot foot = foot_on(piece.a, piece.b, p);
    if (foot.distance_m >= piece.influence_radius_m) continue;
    const double nearness = 1 / std::max(foot.distance_m, kOn_m / 8) - 1 / piece.influence_radius_m;
    const double weight = nearness * nearness * nearness * nearness;
    sum += weight * (piece.from_m + (piece.to_m - piece.from_m) * foot.share);
    weights += weight;
  }
  if (weights == 0) return std::nullopt;
  return sum / weights;
}

}  // namespace

double influence_radius_m(const roads::Strip& stream) {
  return std::max(stream.influence_radius_m, 1.25 * std::max(stream.left_m, stream.right_m) + 0.5);
}

WaterIndex index_waters(std::span<const LandCoverPolygon> surfaces, std::span<const roads::Strip> streams,
                        const Box2& box) {
  WaterIndex index;
  for (const LandCoverPolygon& surface : surfaces)
    if (surface.level_m) index.standing.push_back(surface);
  index.standing_index = index_land_cover(index.standing, box);
  for (const LandCoverPolygon& surface : index.standing) add_shores(index, surface);
  for (const roads::Strip& stream : streams)
    if (!stream.profile.empty()) add_pieces(index, stream);
  index.pieces_grid =
      index_near(index.pieces, box, [](const WaterIndex::Piece& piece) { return piece.influence_radius_m; });
  index.shores_grid = index_near(index.shores, box, [](const WaterIndex::Shore&) { return kStandingInfluence_m; });
  return index;
}

std::optional<double> water_m(const WaterIndex& index, Vec2 p) {
  assert(index.standing_index.box.contains(p));
  const NearShore shore = nearest_shore(index, p);
  if (shore.distance_m <= kOn_m) return shore.level_m;
  const std::uint32_t around = land_cover_at(index.standing_index, p);
  if (around != kNoLandCover) return index.standing[around].level_m;
  if (const auto running = running_m(index, p)) return running;
  return shore.level_m;
}

}  // namespace citykiln::ground
