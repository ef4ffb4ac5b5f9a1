#include "compiler/props/mapped_kerbs.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"

namespace citykiln::props {
namespace {

// A piece of a road's axis, and the distances from it to the kerbs.
struct KerbedSegment {
  Vec2 a, b;
  double left_m = 0, right_m = 0;
};

struct KerbedSegments {
  std::vector<KerbedSegment> all;
  BoxGrid grid;
};

KerbedSegments kerbed_segments(std::span<const roads::Road> roads) {
  constexpr double kBucket_m = 32;
  KerbedSegments found;
  std::vector<Box2> boxes;
  for (const roads::Road& road : roads) {
    const bool has_left = roads::raised_left_m(road) > 0, has_right = roads::raised_right_m(road) > 0;
    if (!map::is_street(road.surface) || (!has_left && !has_right)) continue;
    for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
      found.all.push_back(
          {road.axis[i], road.axis[i + 1], has_left ? roads::left_m(road) : 0, has_right ? roads::right_m(road) : 0});
      boxes.push_back(box_of_segment(road.axis[i], road.axis[i + 1])
                          .widened(std::max(found.all.back().left_m, found.all.back().right_m) + kSameKerbOutside_m));
    }
  }
  found.grid = grid_of(boxes, kBucket_m);
  return found;
}

bool is_at_kerb(const KerbedSegments& segments, Vec2 p) {
  return std::ranges::any_of(boxes_about(segments.grid, p), [&](std::uint32_t i) {
    const KerbedSegment& segment = segments.all[i];
    const bool is_left = cross(segment.b - segment.a, p - segment.a) > 0;
    const double kerb_m = is_left ? segment.left_m : segment.right_m;
    const double beyond_m = distance_to_segment(segment.a, segment.b, p) - kerb_m;
    return kerb_m > 0 && -kSameKerbInside_m <= beyond_m && beyond_m <= kSameKerbOutside_m;
  });
}

double share_at_kerbs(const KerbedSegments& segments, const Polyline& axis) {
  constexpr double kSample_m = 2;
  double samples = 0, found = 0;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const double count = std::ceil(distance(axis[i], axis[i + 1]) / kSample_m);
    for (double k = 0; k < count; ++k) {
      samples += 1;
      found += is_at_kerb(segments, axis[i] + (axis[i + 1] - axis[i]) * ((k + 0.5) / count)) ? 1 : 0;
    }
  }
  return samples > 0 ? found / samples : 0;
}

}  // namespace

std::vector<bool> kerbs_of_streets(std::span<const map::Barrier> barriers, std::span<const roads::Road> roads) {
  constexpr double kMost = 0.7;
  std::vector<bool> are(barriers.size(), false);
  const auto is_kerb = [](const map::Barrier& barrier) { return barrier.kind == map::BarrierKind::kKerb; };
  if (std::ranges::none_of(barriers, is_kerb)) return are;
  const KerbedSegments segments = kerbed_segments(roads);
  for (std::size_t i = 0; i < barriers.size(); ++i)
    are[i] = is_kerb(barriers[i]) && share_at_kerbs(segments, barriers[i].axis) >= kMost;
  return are;
}

}  // namespace citykiln::props
