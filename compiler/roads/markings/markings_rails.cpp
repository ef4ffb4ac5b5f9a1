// Rails: on sleepers in ballast, grooved in a street, or between asphalt at a level crossing.
// Source: rail 54E1 (head 70 mm, foot 140 mm), grooved rail 60R2 (head 56 mm, groove 36 mm); sleepers every 0.6 m, 0.26
// m wide and 2.6 m long at standard gauge.
#include <algorithm>

#include "compiler/roads/markings/markings_parts.h"

namespace citykiln::roads {
namespace {

using Texel = materials::TextureImage::Texel;

constexpr Texel kSteel = {152, 147, 142}, kRust = {88, 66, 53}, kSleeper = {141, 136, 127}, kGroove = {38, 36, 35};

void add_band(double left_m, double right_m, Texel colour, Marks& marks) {
  marks.push_back({rectangle({left_m, 0}, {right_m, kLayoutLength_m}), colour});
}

void add_sleepers(double middle_m, double half_length_m, Marks& marks) {
  constexpr int kCount = 20;
  constexpr double kSleeper_m = 0.26, kPeriod_m = kLayoutLength_m / kCount;
  for (int i = 0; i < kCount; ++i) {
    const double v_m = (i + 0.5) * kPeriod_m;
    marks.push_back(
        {rectangle({middle_m - half_length_m, v_m - kSleeper_m / 2}, {middle_m + half_length_m, v_m + kSleeper_m / 2}),
         kSleeper});
  }
}

// @param inner_m  The gauge face, where wheel flanges run. @param side  -1: left rail, 1: right rail.
void add_rail(double inner_m, double side, Marks& marks) {
  constexpr double kHead_m = 0.07, kFootBeyondHead_m = 0.035;
  const double outer_m = inner_m + side * kHead_m;
  add_band(std::min(inner_m, outer_m) - kFootBeyondHead_m, std::max(inner_m, outer_m) + kFootBeyondHead_m, kRust,
           marks);
  add_band(std::min(inner_m, outer_m), std::max(inner_m, outer_m), kSteel, marks);
}

void add_grooved_rail(double inner_m, double side, Marks& marks) {
  constexpr double kHead_m = 0.056, kGroove_m = 0.045;
  const double groove_m = inner_m - side * kGroove_m, outer_m = inner_m + side * kHead_m;
  add_band(std::min(inner_m, groove_m), std::max(inner_m, groove_m), kGroove, marks);
  add_band(std::min(inner_m, outer_m), std::max(inner_m, outer_m), kSteel, marks);
}

}  // namespace

void add_rails(const MarkingLayout& layout, Marks& marks) {
  constexpr double kLeastGauge_m = 0.3, kSleeperBeyondRail_m = 0.58;
  const bool is_on_ballast = map::values_of(layout.surface).material == materials::Material::kBallast &&
                             layout.stretch != StretchKind::kLevelCrossing;
  const std::vector<double> sides_m = lane_sides_m(layout);
  for (std::size_t i = 0; i < layout.lanes.size(); ++i) {
    if (layout.lanes[i].kind != map::LaneKind::kRail) continue;
    const double middle_m = (sides_m[i] + sides_m[i + 1]) / 2, half_lane_m = layout.lanes[i].width_m / 2;
    // rails and sleepers stay in their lane
    const double half_gauge_m = std::min(std::max(layout.gauge_m, kLeastGauge_m) / 2, half_lane_m * 0.75);
    if (is_on_ballast) add_sleepers(middle_m, std::min(half_gauge_m + kSleeperBeyondRail_m, half_lane_m), marks);
    for (const double side : {-1.0, 1.0})
      (is_on_ballast ? add_rail : add_grooved_rail)(middle_m + side * half_gauge_m, side, marks);
  }
}

}  // namespace citykiln::roads
