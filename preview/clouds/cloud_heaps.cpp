// Surfaces after Schneider, Vos, "The Real-time Volumetric Cloudscapes of Horizon Zero Dawn" (SIGGRAPH 2015 courses):
// cellular noise erodes a smooth body. The body is that of sky::generate_cloud(), and noise moves its surface in
// metres.
#include "preview/clouds/cloud_heaps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace citykiln::preview {
namespace {

// The side of columns, the depth of soft edges and the size of the largest billows, as shares of the height of a layer
// in its frame.
constexpr double kColumnShare = 0.25, kSoftShare = 0.045, kBillowShare = 0.36;
// Soft edges of the other kinds, which have no crisp heads.
constexpr double kVeilSoftShare = 0.2;
// The height of the largest billows as a share of their size, the shares by which the size and the height of others
// are smaller than those before, and the number of sizes.
constexpr double kBillowHeight = 0.62, kSmaller = 0.47, kLower = 0.54;
constexpr int kSizes = 5;
// Billows move the surface outwards on the whole: heaps alone are smaller than clouds with all their particles.
constexpr double kOutwards = 0.1;
// Noise is hardly ever lower.
constexpr double kLeastNoise = 0.25;
// Heaps are joined over this share of their radius.
constexpr double kJoin = 0.35;
// Below this share of the layer's height edges are frayed, by so many times the depth of other edges.
constexpr double kFrayedShare = 0.22, kFrayed = 1.6;
// The depth of edges in coarse samples, as a share of the finest billows that they have.
constexpr double kBlur = 0.3;
// The share of the layer's height in which density rises from the base on.
constexpr double kBaseShare = 0.05;
// Spheres that are joined smoothly swell by this share.
constexpr double kSwollen = 1.1;
// A side has at most this many columns.
constexpr double kMostColumns = 2000;

double smooth_step(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// The larger of two numbers, rounded where they differ by less than k.
float rounded_max(float a, float b, float k) {
  const float h = std::max(k - std::abs(a - b), 0.0F);
  return std::max(a, b) + (k > 0 ? h * h / (4 * k) : 0);
}

std::vector<sky::CloudParticle> heaps_around(const sky::CloudLayer& layer, const sky::LayerFrame& frame, Vec3 eye,
                                             std::size_t& clouds) {
  std::vector<sky::CloudParticle> all;
  const Box2 around = sky::within_limit(layer, Box2{in_plan(eye), in_plan(eye)}.widened(kFarthestCloud_m));
  for (const sky::Cloud& cloud : sky::clouds_in(layer, around)) {
    if (length(in_plan(frame.out_of(at_height(cloud.centre, 0)) - eye)) > kFarthestCloud_m) continue;
    const sky::CloudParticles heaps = sky::generate_cloud(layer, cloud, std::numeric_limits<double>::infinity());
    all.insert(all.end(), heaps.spheres.begin(), heaps.spheres.end());
    ++clouds;
  }
  return all;
}

}  // namespace

CloudHeaps::CloudHeaps(const sky::CloudLayer& layer, Vec3 eye)
    : frame_(sky::frame_of(layer)),
      extinction_per_m_(sky::extinction_per_m(layer.kind)),
      soft_m_(frame_.height_m * (layer.kind == sky::CloudKind::kCumulus ? kSoftShare : kVeilSoftShare)),
      billow_m_(frame_.height_m * kBillowShare) {
  build(heaps_around(layer, frame_, eye, clouds_));
}

CloudHeaps::CloudHeaps(const sky::CloudLayer& layer, std::span<const sky::CloudParticle> spheres, CloudEdges edges)
    : frame_(sky::frame_of(layer)),
      extinction_per_m_(sky::extinction_per_m(layer.kind)),
      edges_(edges),
      soft_m_(frame_.height_m * kSoftShare),
      billow_m_(frame_.height_m * kBillowShare),
      clouds_(1) {
  build(spheres);
}

double CloudHeaps::around_m(const sky::CloudParticle& sphere) const { return sphere.radius_m * kSwollen + reach_m_; }

void CloudHeaps::build(std::span<const sky::CloudParticle> spheres) {
  if (edges_ == CloudEdges::kBillowed) {
    const double all_m = billow_m_ * kBillowHeight * (1 - std::pow(kLower, kSizes)) / (1 - kLower);
    reach_m_ = all_m * (1 - noise_.mean() + kOutwards);
    deep_m_ = all_m * (noise_.mean() - kLeastNoise - kOutwards) + soft_m_ * (1 + kFrayed);
  }
  if (spheres.empty()) return;
  Box2 box;
  for (const sky::CloudParticle& sphere : spheres)
    for (const double side : {-1, 1}) box.grow(in_plan(sphere.centre) + Vec2{side, side} * around_m(sphere));
  column_m_ = std::max(frame_.height_m * kColumnShare, std::max(box.width(), box.height()) / kMostColumns);
  low_ = box.min;
  columns_ = static_cast<std::int64_t>(box.width() / column_m_) + 1;
  rows_ = static_cast<std::int64_t>(box.height() / column_m_) + 1;
  keep(by_column(spheres));
}

std::vector<std::vector<CloudHeaps::Heap>> CloudHeaps::by_column(std::span<const sky::CloudParticle> spheres) const {
  std::vector<std::vector<Heap>> columns(static_cast<std::size_t>(columns_ * rows_));
  const auto index = [&](double m, std::int64_t count) {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(m / column_m_)), 0, count - 1);
  };
  for (const sky::CloudParticle& sphere : spheres) {
    const Heap heap{static_cast<float>(sphere.centre.x), static_cast<float>(sphere.centre.y),
                    static_cast<float>(sphere.centre.z), static_cast<float>(sphere.radius_m)};
    const Vec2 at = in_plan(sphere.centre) - low_;
    const double away_m = around_m(sphere);
    for (std::int64_t row = index(at.y - away_m, rows_); row <= index(at.y + away_m, rows_); ++row)
      for (std::int64_t column = index(at.x - away_m, columns_); column <= index(at.x + away_m, columns_); ++column)
        columns[static_cast<std::size_t>(row * columns_ + column)].push_back(heap);
  }
  return columns;
}

void CloudHeaps::keep(const std::vector<std::vector<Heap>>& columns) {
  for (const std::vector<Heap>& column : columns) {
    first_.push_back(static_cast<std::uint32_t>(heaps_.size()));
    heaps_.insert(heaps_.end(), column.begin(), column.end());
    float top_m = 0;
    for (const Heap& heap : column)
      top_m = std::max(top_m, heap.z + heap.radius_m * static_cast<float>(kSwollen) + static_cast<float>(reach_m_));
    tops_m_.push_back(top_m);
    top_m_ = std::max<double>(top_m_, top_m);
  }
  first_.push_back(static_cast<std::uint32_t>(heaps_.size()));
}

std::int64_t CloudHeaps::column_at(double x, double y) const {
  const double column = (x - low_.x) / column_m_, row = (y - low_.y) / column_m_;
  if (column < 0 || row < 0 || column >= static_cast<double>(columns_) || row >= static_cast<double>(rows_)) return -1;
  return static_cast<std::int64_t>(row) * columns_ + static_cast<std::int64_t>(column);
}

CloudHeaps::Ray CloudHeaps::ray_of(Vec3 from, Vec3 direction) const {
  const Vec3 along = frame_.into_direction(direction);
  return {frame_.into(from), along, length(along)};
}

namespace {

// Cuts the part of a line where a coordinate is between two limits.
void cut_between(double from, double along, double low, double high, double& begin, double& end) {
  if (std::abs(along) < 1e-12) {
    if (from < low || from > high) end = begin;
    return;
  }
  const double a = (low - from) / along, b = (high - from) / along;
  begin = std::max(begin, std::min(a, b)), end = std::min(end, std::max(a, b));
}

// The cells of a line along an axis, one after the other, for a walk from column to column (Amanatides, Woo, "A Fast
// Voxel Traversal Algorithm for Ray Tracing", Eurographics 1987).
struct WalkAlong {
  double from, along, cell_m;
  std::int64_t count, at, to;

  WalkAlong(double from, double along, double begin, double cell_m, std::int64_t count)
      : from(from), along(along), cell_m(cell_m), count(count), to(along > 0 ? 1 : -1) {
    at = std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((from + along * begin) / cell_m)), 0, count - 1);
  }
  bool is_inside() const { return at >= 0 && at < count; }
  // The distance at which the line leaves the cell.
  double next() const {
    if (along == 0) return std::numeric_limits<double>::infinity();
    return (static_cast<double>(at + (to > 0)) * cell_m - from) / along;
  }
  void step() { at += to; }
};

}  // namespace

void CloudHeaps::stretches_of(Vec3 from, Vec3 direction, double distance_m, std::vector<HeapStretch>& stretches) const {
  stretches.clear();
  if (heaps_.empty()) return;
  const Ray ray = ray_of(from, direction);
  double begin = 0, end = std::min(distance_m, 8 * kFarthestCloud_m);
  cut_between(ray.from.z, ray.along.z, 0, top_m_, begin, end);
  cut_between(ray.from.x, ray.along.x, low_.x, low_.x + static_cast<double>(columns_) * column_m_, begin, end);
  cut_between(ray.from.y, ray.along.y, low_.y, low_.y + static_cast<double>(rows_) * column_m_, begin, end);
  if (!(begin < end)) return;
  WalkAlong x(ray.from.x - low_.x, ray.along.x, begin, column_m_, columns_);
  WalkAlong y(ray.from.y - low_.y, ray.along.y, begin, column_m_, rows_);
  while (begin < end && x.is_inside() && y.is_inside()) {
    const double leaves = std::max(begin, std::min({x.next(), y.next(), end}));
    const auto column = static_cast<std::uint32_t>(y.at * columns_ + x.at);
    double low = begin, high = leaves;
    cut_between(ray.from.z, ray.along.z, 0, tops_m_[column], low, high);
    if (tops_m_[column] > 0 && low < high) stretches.push_back({low, high, column});
    begin = leaves;
    (x.next() < y.next() ? x : y).step();
  }
}

float CloudHeaps::distance_inside(const Vec3& own, std::uint32_t column) const {
  float inside_m = -1e9F;
  const auto x = static_cast<float>(own.x), y = static_cast<float>(own.y), z = static_cast<float>(own.z);
  const bool is_joined = edges_ != CloudEdges::kSharp;
  for (std::uint32_t i = first_[column]; i < first_[column + 1]; ++i) {
    const Heap& heap = heaps_[i];
    // below their middles heaps go straight down to the flat base
    const float dx = x - heap.x, dy = y - heap.y, dz = is_joined ? std::max(z - heap.z, 0.0F) : z - heap.z;
    const float in_this_m = heap.radius_m - std::sqrt(dx * dx + dy * dy + dz * dz);
    inside_m = is_joined ? rounded_max(inside_m, in_this_m, static_cast<float>(kJoin) * heap.radius_m)
                         : std::max(inside_m, in_this_m);
  }
  return inside_m;
}

float CloudHeaps::billow(const Vec3& own, double finest_m) const {
  double size_m = billow_m_, height_m = billow_m_ * kBillowHeight;
  float sum_m = 0;
  for (int i = 0; i < kSizes; ++i, size_m *= kSmaller, height_m *= kLower) {
    // the mean of what is left out
    float above_mean = 0;
    if (size_m > finest_m) {
      const auto in_cells = [&](double v, double shift) { return static_cast<float>(v / size_m + shift * i); };
      above_mean = noise_.at(in_cells(own.x, 2.37), in_cells(own.y, 5.81), in_cells(own.z, 3.13)) - noise_.mean();
    }
    sum_m += static_cast<float>(height_m) * (above_mean + static_cast<float>(kOutwards));
  }
  return sum_m;
}

CloudHeaps::Sample CloudHeaps::sample(Vec3 own, std::uint32_t column, double finest_m) const {
  if (own.z <= 0) return {0, 0};
  double inside_m = distance_inside(own, column);
  if (edges_ == CloudEdges::kSharp) return {inside_m > 0 ? 1.0 : 0.0, std::max(0.0, -inside_m)};
  if (inside_m + reach_m_ <= 0) return {0, -inside_m - reach_m_};
  const double base = smooth_step(own.z / (kBaseShare * frame_.height_m));
  if (edges_ == CloudEdges::kBillowed && inside_m > deep_m_) return {base, 0};
  if (edges_ == CloudEdges::kBillowed) inside_m += billow(own, finest_m);
  const double frayed = 1 + kFrayed * (1 - smooth_step(own.z / (kFrayedShare * frame_.height_m)));
  const double edge_m = soft_m_ * frayed, blurred_m = std::max(edge_m, kBlur * finest_m);
  inside_m += (blurred_m - edge_m) / 2;
  if (inside_m <= 0) return {0, -inside_m * 0.5};
  return {smooth_step(inside_m / blurred_m) * base, 0};
}

double CloudHeaps::density(Vec3 own, double finest_m) const {
  const std::int64_t column = column_at(own.x, own.y);
  if (column < 0 || own.z <= 0) return 0;
  const auto index = static_cast<std::uint32_t>(column);
  return own.z < tops_m_[index] ? sample(own, index, finest_m).density : 0;
}

}  // namespace citykiln::preview
