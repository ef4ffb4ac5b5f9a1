// Marks of speed humps: dark ramps with triangles that point up them, for the traffic that arrives.
//
//     4 m  |  v   v  |   the far ramp         Sources: TSRGD 2016, diagram 1062: white triangles on both ramps; MUTCD
//          |         |   the top              3B.25. They are 7.5 to 10 cm high, less than the finest usual tolerance,
//     0    |  ^   ^  |   the near ramp        so they are drawn only.
#include <algorithm>
#include <cmath>

#include "compiler/roads/markings/marking_rules.h"
#include "compiler/roads/markings/markings_parts.h"

namespace citykiln::roads {
namespace {

constexpr materials::TextureImage::Texel kRamp = {74, 73, 72}, kRedTop = {112, 68, 62}, kPavedTop = {142, 134, 124};
constexpr double kRampLength_m = 1.0, kTriangleBase_m = 0.6;

// Triangles on the ramp at the start of the layout, and mirrored ones on that at its end.
void add_triangles(double left_m, double right_m, double low_m, double high_m, Marks& marks) {
  const double middle_m = (left_m + right_m) / 2, half_m = std::min(kTriangleBase_m, right_m - left_m) / 2;
  for (const double side : {-1.0, 1.0}) {
    const double u_m = right_m - left_m > 4 * half_m ? middle_m + side * (right_m - left_m) / 4 : middle_m;
    marks.push_back({{{u_m - half_m, low_m}, {u_m + half_m, low_m}, {u_m, low_m + kRampLength_m}}, kWhite});
    marks.push_back({{{u_m + half_m, high_m}, {u_m - half_m, high_m}, {u_m, high_m - kRampLength_m}}, kWhite});
  }
}

void add_cushions(const MarkingLayout& layout, Marks& marks) {
  constexpr double kCushion_m = 1.7, kFrom_m = 0.5, kTo_m = 3.5;
  const std::vector<double> sides_m = lane_sides_m(layout);
  for (std::size_t i = 0; i < layout.lanes.size(); ++i) {
    if (!is_driven(layout.lanes[i]) || layout.lanes[i].width_m < kCushion_m) continue;
    const auto count = std::max(1.0, std::floor(layout.lanes[i].width_m / 3));
    for (double k = 0; k < count; ++k) {
      const double middle_m = sides_m[i] + layout.lanes[i].width_m * (k + 0.5) / count;
      marks.push_back({rectangle({middle_m - kCushion_m / 2, kFrom_m}, {middle_m + kCushion_m / 2, kTo_m}), kRedTop});
      add_triangles(middle_m - kCushion_m / 2, middle_m + kCushion_m / 2, kFrom_m, kTo_m, marks);
    }
  }
}

}  // namespace

void add_hump(const MarkingLayout& layout, Marks& marks) {
  if (layout.stretch == StretchKind::kSpeedCushions) return add_cushions(layout, marks);
  if (std::ranges::none_of(layout.lanes, is_driven)) return;
  const double across_m = width_m(layout), top_m = kCrossingLength_m - kRampLength_m;
  const bool is_table = layout.stretch == StretchKind::kSpeedTable;
  marks.push_back({rectangle({0, 0}, {across_m, kCrossingLength_m}), kRamp});
  if (is_table) marks.push_back({rectangle({0, kRampLength_m}, {across_m, top_m}), kPavedTop});
  const std::vector<double> sides_m = lane_sides_m(layout);
  for (std::size_t i = 0; i < layout.lanes.size(); ++i)
    if (is_driven(layout.lanes[i])) add_triangles(sides_m[i], sides_m[i + 1], 0, kCrossingLength_m, marks);
}

}  // namespace citykiln::roads
