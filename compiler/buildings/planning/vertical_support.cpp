#include "compiler/buildings/planning/vertical_support.h"

#include <algorithm>
#include <cassert>
#include <set>

#include "compiler/geometry/box_grid.h"

namespace citykiln::buildings {
namespace {

using map::Footprint;

constexpr double kSupportBucket_m = 32;
// A lower footprint may end this far below: heights are estimated from storeys.
constexpr double kMaxGap_m = 3.5;
// Bays on one building are smaller.
constexpr double kMaxBay_m2 = 150;
// The share of sample points that need a footprint below; fewer is imprecision of the drawn outlines.
constexpr double kMinSupportedShare = 0.02;
constexpr int kSamplesPerSide = 16;

Box2 footprint_box(const Footprint& footprint) { return box_of(footprint.polygon.outer); }

bool is_built(const Footprint& f) { return !f.has_parts && f.polygon.outer.size() >= 3; }

// The footprints that become buildings, with a spatial index.
struct BuiltFootprints {
  std::span<const Footprint> footprints;
  std::vector<std::uint32_t> numbers;
  BoxGrid grid;

  template <typename Visit>
  void each_at(Vec2 p, Visit visit) const {
    for (const std::uint32_t i : boxes_about(grid, p)) {
      const Footprint& footprint = footprints[numbers[i]];
      if (footprint_box(footprint).contains(p) && contains(footprint.polygon, p)) visit(numbers[i]);
    }
  }
};

BuiltFootprints index_built(std::span<const Footprint> footprints) {
  BuiltFootprints built{footprints, {}, {}};
  std::vector<Box2> boxes;
  for (std::uint32_t i = 0; i < footprints.size(); ++i) {
    if (!is_built(footprints[i])) continue;
    built.numbers.push_back(i);
    boxes.push_back(footprint_box(footprints[i]));
  }
  built.grid = grid_of(boxes, kSupportBucket_m);
  return built;
}

bool reaches(const Footprint& lower, const Footprint& upper) {
  return lower.min_height_m < upper.min_height_m && lower.height_m + kMaxGap_m >= upper.min_height_m;
}

// Columns and shafts may be too thin for the samples: one whose centre lies below is enough.
bool has_column(const BuiltFootprints& built, const Footprint& upper) {
  return std::ranges::any_of(boxes_about(built.grid, footprint_box(upper)), [&](std::uint32_t i) {
    const Footprint& lower = built.footprints[built.numbers[i]];
    return reaches(lower, upper) && contains(upper.polygon, footprint_box(lower).centre());
  });
}

bool has_footprint_below(const BuiltFootprints& built, const Footprint& upper) {
  if (has_column(built, upper)) return true;
  const Box2 box = footprint_box(upper);
  int samples = 0, supported = 0;
  for (int i = 0; i < kSamplesPerSide * kSamplesPerSide; ++i) {
    const Vec2 share{(i % kSamplesPerSide + 0.5) / kSamplesPerSide, (i / kSamplesPerSide + 0.5) / kSamplesPerSide};
    const Vec2 p{box.min.x + share.x * box.width(), box.min.y + share.y * box.height()};
    if (!contains(upper.polygon, p)) continue;
    bool is_supported = false;
    built.each_at(p, [&](std::uint32_t lower) { is_supported |= reaches(built.footprints[lower], upper); });
    ++samples, supported += is_supported;
  }
  return supported > kMinSupportedShare * samples;
}

// Bays, and bridges between two buildings.
bool hangs_on_walls(const Footprint& f, std::span<const SharedWall> shared, std::span<const Footprint> footprints) {
  std::set<std::uint32_t> carrying;
  for (const SharedWall& wall : shared) {
    const Footprint& other = footprints[wall.neighbour];
    const bool carries = !other.is_open && other.min_height_m <= f.min_height_m && other.height_m > f.min_height_m;
    if (carries) carrying.insert(wall.neighbour);
  }
  return carrying.size() > 1 || (carrying.size() == 1 && area_m2(f.polygon) < kMaxBay_m2);
}

}  // namespace

std::vector<bool> find_supported(std::span<const Footprint> footprints,
                                 std::span<const std::vector<SharedWall>> shared) {
  assert(shared.size() == footprints.size());
  const BuiltFootprints built = index_built(footprints);
  std::vector<bool> supported(footprints.size(), true);
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    const Footprint& f = footprints[i];
    if (is_built(f) && f.min_height_m > 0)
      supported[i] = hangs_on_walls(f, shared[i], footprints) || has_footprint_below(built, f);
  }
  return supported;
}

}  // namespace citykiln::buildings
