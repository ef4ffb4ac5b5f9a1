#include "compiler/roads/junctions/through_road.h"

#include <algorithm>
#include <cmath>

#include "compiler/roads/junctions/arm_lines.h"

namespace citykiln::roads {
namespace {

bool are_one_road(const ArmLine& a, const ArmLine& b) {
  constexpr double kSameWidth_m = 0.25, kStraightCosine = -0.8;
  return std::abs(a.left_m - b.right_m) < kSameWidth_m && std::abs(a.right_m - b.left_m) < kSameWidth_m &&
         dot(a.along, b.along) < kStraightCosine;
}

}  // namespace

bool has_through_road(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms) {
  if (junction.family != Family::kStreet || junction.nodes.size() != 1 || arms.size() < 3) return false;
  if (disk_radius_m(roads, arms) > 0 || has_signals(roads, arms)) return false;
  const int highest = priority_of(main_road(roads, arms));
  std::vector<ArmLine> main;
  for (const Arm& arm : arms)
    if (priority_of(roads[arm.road]) == highest) main.push_back(arm_line(roads, arm));
  return main.size() == 2 && are_one_road(main[0], main[1]);
}

}  // namespace citykiln::roads
