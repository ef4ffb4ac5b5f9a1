#include "compiler/buildings/vertical_support.h"

#include <algorithm>
#include <cassert>

#include "compiler/geometry/box_grid.h"
#include "compiler/map/buildings/building_classes.h"

namespace citykiln::buildings {
namespace {

using map::Footprint;

constexpr double kSupportBucket_m = 32;
// A lower footprint may end this far below: heights are estimated from storeys.
constexpr double kMaxGap_m = 3.5;
// Whatever begins higher lacks more than a base: a dome without its drum must not become a column.
constexpr double kMaxBase_m = 12;
// Bays and bridges between houses are smaller.
constexpr double kMaxBay_m2 = 150;
// The share of sample points that need a footprint below; fewer is imprecision of the drawn outlines.
constexpr double kMinSupportedShare = 0.02;
constexpr int kSamplesPerSide = 16;
constexpr double kTrackSpacing_m = 2;

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

// Footprints that a way on the ground or on a bridge passes under; tunnels pass under everything.
std::vector<bool> passed_under(const BuiltFootprints& built, std::span<const map::Track> tracks) {
  std::vector<bool> passed(built.footprints.size());
  for (const map::Track& track : tracks) {
    if (track.passage == map::Passage::kTunnel) continue;
    for (std::size_t i = 0; i + 1 < track.axis.size(); ++i) {
      const Vec2 a = track.axis[i], b = track.axis[i + 1];
      const int steps = 1 + static_cast<int>(distance(a, b) / kTrackSpacing_m);
      for (int k = 0; k < steps; ++k)
        built.each_at(a + (b - a) * (static_cast<double>(k) / steps), [&](std::uint32_t f) { passed[f] = true; });
    }
  }
  return passed;
}

bool is_bay(const Footprint& f, std::span<const SharedWall> shared, std::span<const Footprint> footprints) {
  return area_m2(f.polygon) < kMaxBay_m2 && std::ranges::any_of(shared, [&](const SharedWall& wall) {
           const Footprint& other = footprints[wall.neighbour];
           return other.min_height_m <= f.min_height_m && other.height_m > f.min_height_m;
         });
}

bool needs_support(const Footprint& f, bool is_passed) {
  const bool is_roof = static_cast<map::BuildingClass>(f.building_class) == map::BuildingClass::kRoof;
  return f.min_height_m > 0 && f.min_height_m <= kMaxBase_m && is_built(f) && !is_roof && !is_passed;
}

}  // namespace

std::vector<bool> find_supported(std::span<const Footprint> footprints, std::span<const std::vector<SharedWall>> shared,
                                 std::span<const map::Track> tracks) {
  assert(shared.size() == footprints.size());
  const BuiltFootprints built = index_built(footprints);
  const std::vector<bool> passed = passed_under(built, tracks);
  std::vector<bool> supported(footprints.size(), true);
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    const Footprint& f = footprints[i];
    if (needs_support(f, passed[i])) supported[i] = is_bay(f, shared[i], footprints) || has_footprint_below(built, f);
  }
  return supported;
}

}  // namespace citykiln::buildings
