#include "compiler/sky/clouds/place_clouds.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/mathematics.h"
#include "compiler/geometry/trig.h"

namespace citykiln::sky {
namespace {

// The spacing and scaling of clouds of a kind. `spacing` is in heights of the layer's frame.
struct KindShape {
  double spacing, stretch, flatten;
};

KindShape shape_of(CloudKind kind) {
  switch (kind) {
    case CloudKind::kStratus:
      return {1.2, 1, 0.3};
    case CloudKind::kCirrus:
      return {1.5, 8, 0.35};
    default:
      return {1.7, 1, 1};
  }
}

// The mean square radius with which discs at independent places cover the wanted share, or nearly all of the sky.
double mean_square_radius_m2(double cover, double kept, double spacing_m) {
  const double wanted = -logarithm(1 - std::min(cover, 0.97));
  return wanted * spacing_m * spacing_m / (kPi * kept);
}

// The square of a cloud's radius, as a multiple of the mean square: many small clouds and few large ones.
constexpr double kLeastSize = 0.25, kMostSize = 2.5;
double size_of(double random) { return kLeastSize + (kMostSize - kLeastSize) * random * random; }

// The share of cells that have a cloud.
double kept_share(double cover) { return 0.3 + 0.7 * cover; }

// Squares of kGroup cells have more clouds or fewer than that, up to this share, so that clouds stand in groups with
// gaps between them.
constexpr std::int64_t kGroup = 4;
constexpr double kMostSpread = 0.75;
double kept_near(const CloudLayer& layer, StableId whole, std::int64_t column, std::int64_t row) {
  const auto group_of = [](std::int64_t cell) {
    return static_cast<std::uint64_t>(cell >= 0 ? cell / kGroup : -((kGroup - 1 - cell) / kGroup));
  };
  const StableId group = stable_id(stable_id(whole, "groups", group_of(row)), "group", group_of(column));
  const double share = kept_share(layer.cover), spread = std::min(kMostSpread, 1 / share - 1);
  return share * (1 + spread * RandomSequence(layer.seed, group, "kept").between(-1, 1, 0));
}

Cloud cloud_at(const CloudLayer& layer, const LayerFrame& frame, std::int64_t column, std::int64_t row) {
  const double spacing_m = shape_of(layer.kind).spacing * frame.height_m;
  const StableId whole = stable_id(ObjectId{{OsmType::kNone, static_cast<std::int64_t>(layer.kind)}}),
                 in_row = stable_id(whole, "row", static_cast<std::uint64_t>(row)),
                 id = stable_id(in_row, "cloud", static_cast<std::uint64_t>(column));
  const RandomSequence draw(layer.seed, id, "place");
  Cloud cloud;
  cloud.id = id;
  if (draw.unit(0) >= kept_near(layer, whole, column, row)) return cloud;
  cloud.centre = {(static_cast<double>(column) + draw.between(0.1, 0.9, 1)) * spacing_m,
                  (static_cast<double>(row) + draw.between(0.1, 0.9, 2)) * spacing_m};
  const double mean = mean_square_radius_m2(layer.cover, kept_share(layer.cover), spacing_m);
  const double size = size_of(draw.unit(3));
  cloud.radius_m = std::sqrt(mean * size);
  const double share = layer.kind == CloudKind::kCumulus ? 0.25 + 0.45 * size : draw.between(0.8, 1, 4);
  cloud.height_m = frame.height_m * std::min(share, 1.0);
  return cloud;
}

}  // namespace

Vec3 LayerFrame::into_direction(Vec3 p) const {
  return {(p.x * along.x + p.y * along.y) / stretch, p.y * along.x - p.x * along.y, p.z / flatten};
}

Vec3 LayerFrame::into(Vec3 p) const { return into_direction({p.x, p.y, p.z - base_m}); }

Vec3 LayerFrame::out_of(Vec3 p) const {
  const double u = p.x * stretch;
  return {u * along.x - p.y * along.y, u * along.y + p.y * along.x, p.z * flatten + base_m};
}

LayerFrame frame_of(const CloudLayer& layer) {
  assert(is_sound(layer));
  const KindShape shape = shape_of(layer.kind);
  const Vec2 along = length(layer.wind) > 0 ? unit(layer.wind) : Vec2{1, 0};
  return {along, shape.stretch, shape.flatten, layer.base_m, (layer.top_m - layer.base_m) / shape.flatten};
}

double largest_radius_m(const CloudLayer& layer) {
  const double spacing_m = shape_of(layer.kind).spacing * frame_of(layer).height_m;
  return std::sqrt(kMostSize * mean_square_radius_m2(layer.cover, kept_share(layer.cover), spacing_m));
}

Box2 within_limit(const CloudLayer& layer, const Box2& plan) {
  const LayerFrame frame = frame_of(layer);
  const double spacing_m = shape_of(layer.kind).spacing * frame.height_m;
  const double cells = plan.width() * plan.height() / (frame.stretch * spacing_m * spacing_m);
  if (plan.is_empty() || cells <= kMostClouds) return plan;
  const Vec2 half = (plan.max - plan.min) * (0.5 * std::sqrt(kMostClouds / cells));
  return {plan.centre() - half, plan.centre() + half};
}

std::vector<Cloud> clouds_in(const CloudLayer& layer, const Box2& plan) {
  if (layer.cover <= 0 || plan.is_empty()) return {};
  const LayerFrame frame = frame_of(layer);
  const double spacing_m = shape_of(layer.kind).spacing * frame.height_m;
  Box2 own;
  for (const Vec2 corner : {plan.min, plan.max, Vec2{plan.min.x, plan.max.y}, Vec2{plan.max.x, plan.min.y}})
    own.grow(in_plan(frame.into(at_height(corner, 0))));
  const auto cell = [&](double m) { return static_cast<std::int64_t>(std::floor(m / spacing_m)); };
  std::vector<Cloud> clouds;
  for (std::int64_t row = cell(own.min.y); row <= cell(own.max.y); ++row)
    for (std::int64_t column = cell(own.min.x); column <= cell(own.max.x); ++column) {
      const Cloud cloud = cloud_at(layer, frame, column, row);
      const bool is_inside = plan.contains_half_open(in_plan(frame.out_of(at_height(cloud.centre, 0))));
      if (cloud.radius_m > 0 && is_inside) clouds.push_back(cloud);
    }
  return clouds;
}

}  // namespace citykiln::sky
