#include "compiler/ground/grading/road_influence.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "compiler/geometry/segment.h"

namespace citykiln::ground {
namespace {

// About the influence radius of a road of two lanes: few segments per bucket.
constexpr double kRoadBucket_m = 32;
// Buckets of the index that each sample looks into: small for tiles, which are sampled densely.
double near_bucket_m(const Box2& box) {
  constexpr double kTile_m = 4096, kNearBucket_m = 8;
  return std::max(box.width(), box.height()) <= kTile_m ? kNearBucket_m : kRoadBucket_m;
}

// Roads are blended up to kAlike_m; from kParted_m on the higher one keeps its height to its edge. Both are limits of
// spread_m(), and of the difference of two roads.
constexpr double kAlike_m = 0.0625, kParted_m = 0.5;

// Beyond all edges the weight falls with the cube of the distance, so the nearest road dominates; on a road this term
// is negligible.
constexpr double kFarWeight = 0.002, kNearest_m = 0.25;

bool has_graded_height(const roads::Road& road, double kerb_m) { return !road.profile.empty() || kerb_m > 0; }

double kerb_of(const roads::Road& road) {
  return roads::raised_left_m(road) > 0 || roads::raised_right_m(road) > 0 ? kKerbRise_m : 0;
}

void add_segments(const roads::Road& road, double kerb_m, RoadInfluenceIndex& index) {
  const std::vector<double> along = roads::distances_along(road);
  const double left_m = roads::left_m(road) + roads::raised_left_m(road),
               right_m = roads::right_m(road) + roads::raised_right_m(road);
  const auto drift_m = [&](std::size_t vertex) { return roads::drift_m(road, along[vertex]); };
  const auto number = static_cast<std::uint32_t>(index.profiles.size());
  for (std::size_t i = 0; i + 1 < road.axis.size(); ++i)
    index.segments.push_back({.from = road.axis[i],
                              .to = road.axis[i + 1],
                              .from_m = along[i],
                              .to_m = along[i + 1],
                              .left_m = left_m + std::max(drift_m(i), drift_m(i + 1)),
                              .right_m = right_m - std::min(drift_m(i), drift_m(i + 1)),
                              .kerb_m = kerb_m,
                              .road = number});
  index.profiles.push_back(road.profile);
  index.cuttings.push_back(road.cuttings);
}

double segment_reach_m(const GradedSegment& s) { return std::max(s.left_m, s.right_m) + kGrading_m; }

Box2 reach_of(const GradedSegment& s) { return box_of_segment(s.from, s.to).widened(segment_reach_m(s)); }

// Returns false only where no place of the box is within the segment's influence.
bool may_reach(const GradedSegment& s, const Box2& box) {
  const Vec2 centre = box.centre();
  constexpr double kSlack_m = 0x1p-10;
  return distance_to_segment(s.from, s.to, centre) <= segment_reach_m(s) + distance(centre, box.max) + kSlack_m;
}

SegmentLine line_of(const GradedSegment& s, const Profile& profile) {
  const Vec2 along = s.to - s.from;
  const double length2_m2 = dot(along, along);
  const std::span<const Knot> knots = between(profile, s.from_m, s.to_m);
  return {along, length2_m2, std::sqrt(length2_m2), static_cast<std::uint32_t>(knots.data() - profile.data()),
          static_cast<std::uint32_t>(knots.size())};
}

// Segments near a place and where it lies beside each: structure of arrays, so that compilers vectorise the loop below.
struct SegmentBatch {
  static constexpr std::size_t kMost = 32;
  template <typename T>
  using Of = std::array<T, kMost>;

  std::size_t count = 0;
  Of<std::uint32_t> numbers;
  Of<double> from_x, from_y, along_x, along_y, length2_m2, length_m, left_m, right_m;
  Of<double> share, aside_m, beyond_m, weight;

  void add(const RoadInfluenceIndex& index, std::uint32_t number) {
    const GradedSegment& s = index.segments[number];
    const SegmentLine& line = index.lines[number];
    numbers[count] = number;
    from_x[count] = s.from.x, from_y[count] = s.from.y, left_m[count] = s.left_m, right_m[count] = s.right_m;
    along_x[count] = line.along.x, along_y[count] = line.along.y;
    length2_m2[count] = line.length2_m2, length_m[count] = line.length_m;
    ++count;
  }

  // Uses selections instead of branches: only those are vectorised.
  void compute(Vec2 p) {
    const auto larger = [](double a, double b) { return a > b ? a : b; };
    const auto smaller = [](double a, double b) { return a < b ? a : b; };
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 from{from_x[i], from_y[i]}, along{along_x[i], along_y[i]};
      share[i] = smaller(larger(dot(p - from, along) / length2_m2[i], 0), 1);
      aside_m[i] = cross(along, p - from) / length_m[i];
      const double left = left_m[i], right = right_m[i], half_m = aside_m[i] >= 0 ? left : right;
      const double from_axis_m = distance(p, from + along * share[i]);
      beyond_m[i] = larger(from_axis_m - half_m, 0);
      const double t = from_axis_m / (half_m + kBlend_m), slack = larger(1 - t * t, 0);
      const double far_m = beyond_m[i] + kNearest_m;
      weight[i] = slack * slack + kFarWeight / (far_m * far_m * far_m);
    }
  }
};

// The height of a cutting's walls at a distance along the whole way.
double wall_at_m(std::span<const roads::Cutting> cuttings, double at_m) {
  double most_m = 0;
  for (const roads::Cutting& c : cuttings) {
    const double from_end_m = std::min(c.from_m > 0 ? at_m - c.from_m : kCuttingEnd_m, c.to_m - at_m);
    most_m = std::max(most_m, kCuttingWall_m * std::min(1.0, from_end_m / kCuttingEnd_m));
  }
  return most_m;
}

// Fills a result in place: copying would wait for what was just written.
void fill(RoadInfluence& influence, const RoadInfluenceIndex& index, const SegmentBatch& batch, std::size_t i,
          double terrain_m) {
  const std::uint32_t number = batch.numbers[i];
  const GradedSegment& s = index.segments[number];
  influence.kerb_m = s.kerb_m, influence.beyond_m = batch.beyond_m[i], influence.weight = batch.weight[i];
  influence.is_graded = index.lines[number].knot_count > 0;
  if (!influence.is_graded) return void(influence.z_m = terrain_m);
  const Knot knot = knot_on(index, number, batch.share[i]);
  influence.z_m = knot.z_m + knot.tilt * std::clamp(batch.aside_m[i], -s.right_m, s.left_m);
  if (const std::vector<roads::Cutting>& cuttings = index.cuttings[s.road]; !cuttings.empty())
    influence.wall_m = wall_at_m(cuttings, s.from_m + (s.to_m - s.from_m) * batch.share[i]);
}

void take_batch(std::pmr::vector<RoadInfluence>& influences, const RoadInfluenceIndex& index, SegmentBatch& batch,
                Vec2 p, double terrain_m) {
  batch.compute(p);
  for (std::size_t i = 0; i < batch.count; ++i)
    if (batch.beyond_m[i] < kGrading_m) fill(influences.emplace_back(), index, batch, i, terrain_m);
  batch.count = 0;
}

// The weighted mean; weights are multiplied by `share`.
template <typename Share>
RoadHeight mean_of(std::span<const RoadInfluence> influences, Share share) {
  double sum = 0;
  RoadHeight mean;
  for (const RoadInfluence& influence : influences) {
    const double weight = influence.weight * share(influence);
    sum += weight;
    mean.z_m += weight * influence.z_m, mean.kerb_m += weight * influence.kerb_m;
  }
  return {mean.z_m / sum, mean.kerb_m / sum};
}

// The weighted mean distance of the influences' heights from their mean.
double spread_m(std::span<const RoadInfluence> influences, double mean_m) {
  double sum = 0, weight = 0;
  for (const RoadInfluence& influence : influences)
    sum += influence.weight * std::abs(influence.z_m - mean_m), weight += influence.weight;
  return sum / weight;
}

double share_between(double none, double all, double value) {
  return std::clamp((value - none) / (all - none), 0.0, 1.0);
}

// 1 on a road and up to the top of the wall beside it, 0 from the wall's foot on.
double inside(const RoadInfluence& influence) { return share_between(kWallFoot_m, kWallTop_m, influence.beyond_m); }

// The share of a road among roads of different heights: what higher roads leave, by how far each covers the place.
// Beyond a wall's foot a road covers nothing.
double share_where_parted(std::span<const RoadInfluence> influences, const RoadInfluence& own) {
  double left = inside(own);
  if (left == 0) return kFarWeight;
  for (const RoadInfluence& other : influences)
    if (other.beyond_m < kWallFoot_m)
      left *= 1 - inside(other) * share_between(kAlike_m, kParted_m, other.z_m - own.z_m);
  return left + kFarWeight;
}

}  // namespace

RoadInfluenceIndex index_road_influence(std::span<const roads::Road> roads, bool has_kerbs) {
  RoadInfluenceIndex index;
  for (const roads::Road& road : roads) {
    const double kerb_m = has_kerbs ? kerb_of(road) : 0;
    if (has_graded_height(road, kerb_m)) add_segments(road, kerb_m, index);
  }
  for (const GradedSegment& s : index.segments) {
    index.lines.push_back(line_of(s, index.profiles[s.road]));
    index.influence_boxes.push_back(reach_of(s));
  }
  index.grid = grid_of(index.influence_boxes, kRoadBucket_m);
  index.near = grid_of(index.influence_boxes, near_bucket_m(index.grid.box),
                       [&](std::uint32_t i, const Box2& bucket) { return may_reach(index.segments[i], bucket); });
  return index;
}

Knot knot_on(const RoadInfluenceIndex& index, std::uint32_t segment, double share) {
  assert(index.lines[segment].knot_count > 0 && share >= 0 && share <= 1);
  const GradedSegment& s = index.segments[segment];
  const SegmentLine& line = index.lines[segment];
  const auto knots = std::span(index.profiles[s.road]).subspan(line.first_knot, line.knot_count);
  return knot_at(knots, s.from_m + (s.to_m - s.from_m) * share);
}

std::pmr::vector<RoadInfluence> road_influences_at(const RoadInfluenceIndex& index, Vec2 p, double terrain_m,
                                                   std::pmr::memory_resource* memory) {
  std::pmr::vector<RoadInfluence> influences(memory);
  const std::span<const std::uint32_t> near = boxes_about(index.near, p);
  influences.reserve(near.size());
  SegmentBatch batch;
  for (const std::uint32_t i : near) {
    if (!index.influence_boxes[i].contains(p)) continue;
    batch.add(index, i);
    if (batch.count == SegmentBatch::kMost) take_batch(influences, index, batch, p, terrain_m);
  }
  take_batch(influences, index, batch, p, terrain_m);
  return influences;
}

RoadHeight blend(std::span<const RoadInfluence> influences) {
  assert(!influences.empty());
  const RoadHeight all = mean_of(influences, [](const RoadInfluence&) { return 1.0; });
  const double parted = share_between(kAlike_m, kParted_m, spread_m(influences, all.z_m));
  if (parted == 0) return all;
  return mean_of(influences,
                 [&](const RoadInfluence& s) { return 1 + (share_where_parted(influences, s) - 1) * parted; });
}

}  // namespace citykiln::ground
