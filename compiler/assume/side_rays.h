// Sample points along a stretch of road, each with a ray to the left and a ray to the right, square to the axis.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/assume/beside.h"
#include "compiler/geometry/segment.h"
#include "compiler/map/cross_section.h"

namespace citykiln::assume {

/// A ray from a sample to one side.
struct SideRay {
  Vec2 at;            ///< On the axis, plane metres.
  Vec2 along, out;    ///< The direction of the axis, and that of the ray. Length 1.
  double kerb_m = 0;  ///< The distance from the axis to the kerb, by the cross-section.
  bool is_left = false;
};

/// Calls look(ray, lines) for samples about every 8 m, at least one per segment of the axis, left side first. `lines`
/// has the indices in Surroundings::lines that touch the box of the segment widened by about_m, and some near it. It is
/// valid during the call. Segments must have a length. O(samples * lines near).
template <typename Look>
void for_each_side_ray(const Surroundings& surroundings, const map::Track& stretch, double about_m, Look look) {
  constexpr double kSampleEvery_m = 8;
  const double left_m = map::left_kerb_m(stretch.section), right_m = map::right_kerb_m(stretch.section);
  for (std::size_t i = 0; i + 1 < stretch.axis.size(); ++i) {
    const Vec2 a = stretch.axis[i], b = stretch.axis[i + 1], along = unit(b - a), out = left_of(along);
    const std::vector<std::uint32_t> near = boxes_about(surroundings.line_grid, box_of_segment(a, b).widened(about_m));
    const int count = std::max(1, static_cast<int>(std::floor(distance(a, b) / kSampleEvery_m + 0.5)));
    for (int k = 0; k < count; ++k) {
      const Vec2 at = a + (b - a) * ((k + 0.5) / count);
      look(SideRay{at, along, out, left_m, true}, std::span<const std::uint32_t>(near));
      look(SideRay{at, along, out * -1.0, right_m, false}, std::span<const std::uint32_t>(near));
    }
  }
}

/// Returns the distance from the axis to the farther kerb.
inline double farther_kerb_m(const map::CrossSection& section) {
  return std::max(map::left_kerb_m(section), map::right_kerb_m(section));
}

}  // namespace citykiln::assume
