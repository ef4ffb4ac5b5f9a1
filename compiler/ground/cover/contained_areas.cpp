#include "compiler/ground/cover/contained_areas.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "compiler/geometry/box_grid.h"
#include "compiler/ground/cover/inside_rings.h"

namespace citykiln::ground {
namespace {

using map::LandCoverClass;

// rings that share edges are drawn with errors of centimetres
constexpr double kInset_m = 0.1;
constexpr double kInsideShare = 0.9;
// two outlines of one thing differ by less
constexpr double kLargerBy = 1.05;

// A point inside of the polygon near each edge of its outline, and the length of the edge.
struct OutlineSample {
  Vec2 at;
  double length_m;
};

std::vector<OutlineSample> outline_samples(const Ring& outer) {
  std::vector<OutlineSample> samples;
  for (std::size_t i = 0, j = outer.size() - 1; i < outer.size(); j = i++) {
    const Vec2 along = outer[i] - outer[j];
    const double length_m = length(along);
    if (length_m < 2 * kInset_m) continue;
    // outer rings are counter-clockwise: the inside is to the left
    const Vec2 inward = Vec2{-along.y, along.x} * (kInset_m / length_m);
    samples.push_back({(outer[j] + outer[i]) * 0.5 + inward, length_m});
  }
  return samples;
}

bool lies_in(const std::vector<OutlineSample>& samples, const BandedRings& rings) {
  double inside_m = 0, all_m = 0;
  for (const OutlineSample& sample : samples) {
    all_m += sample.length_m;
    if (is_inside(rings, sample.at)) inside_m += sample.length_m;
  }
  return inside_m > 0 && inside_m >= kInsideShare * all_m;
}

bool may_be_raised(const LandCoverPolygon& area) {
  return !is_yard(area) && !area.rings.empty() && area.rings.front().size() >= 3;
}

// All areas, to be asked in which of them others lie. Bands are made for those that are asked.
struct Containers {
  std::vector<Box2> boxes;
  BoxGrid grid;
  std::vector<std::optional<BandedRings>> rings;
};

Containers containers_of(const std::vector<LandCoverPolygon>& areas) {
  constexpr double kBucket_m = 64;
  Containers containers;
  for (const LandCoverPolygon& area : areas) containers.boxes.push_back(box_of(area));
  containers.grid = grid_of(containers.boxes, kBucket_m);
  containers.rings.resize(areas.size());
  return containers;
}

// The highest priority above `own` of the areas in which area i lies; else 0. Larger areas have theirs already.
std::uint8_t raised_priority(const std::vector<LandCoverPolygon>& areas, std::uint32_t i, Containers& containers) {
  const std::vector<OutlineSample> samples = outline_samples(areas[i].rings.front());
  if (samples.empty()) return 0;
  int highest = map::values_of(areas[i].surface).priority;
  const int own = highest;
  for (const std::uint32_t k : boxes_about(containers.grid, containers.boxes[i])) {
    const LandCoverPolygon& larger = areas[k];
    if (k == i || larger.surface == LandCoverClass::kBuilding || priority_of(larger) <= highest ||
        larger.area_m2 < kLargerBy * areas[i].area_m2)
      continue;
    if (!containers.rings[k]) containers.rings[k] = band_rings(larger);
    if (lies_in(samples, *containers.rings[k])) highest = priority_of(larger);
  }
  return highest > own ? static_cast<std::uint8_t>(highest) : 0;
}

}  // namespace

std::vector<LandCoverPolygon> with_contained_on_top(std::vector<LandCoverPolygon> areas) {
  if (areas.empty()) return areas;
  Containers containers = containers_of(areas);
  std::vector<std::uint32_t> from_largest(areas.size());
  std::iota(from_largest.begin(), from_largest.end(), 0u);
  std::ranges::stable_sort(from_largest, std::greater(), [&](std::uint32_t i) { return areas[i].area_m2; });
  for (const std::uint32_t i : from_largest)
    if (may_be_raised(areas[i])) areas[i].raised_priority = raised_priority(areas, i, containers);
  return areas;
}

}  // namespace citykiln::ground
