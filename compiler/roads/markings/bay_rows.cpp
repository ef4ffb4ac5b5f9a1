#include "compiler/roads/markings/bay_rows.h"

namespace citykiln::roads {

BayRow bays_of(const map::Lane& lane, map::DrivingSide side) {
  constexpr double kSlant = 0.577;  // 60 degrees from the kerb
  if (lane.width_m < kSlantedRow_m) return {.step_m = 6, .depth_m = lane.width_m, .is_along = true};
  if (lane.width_m >= kSquareRow_m) return {.step_m = 2.4, .depth_m = lane.width_m};
  // drivers turn half into slanted bays: those of both kerbs lean in the direction of traffic
  const double rise_m = side == map::DrivingSide::kRight ? lane.width_m * kSlant : -lane.width_m * kSlant;
  return {.step_m = 3, .depth_m = lane.width_m, .rise_m = rise_m};
}

}  // namespace citykiln::roads
