#include "compiler/roads/corner_pavements.h"

#include <algorithm>

#include "compiler/roads/arm_lines.h"
#include "compiler/roads/junction_ring.h"

namespace citykiln::roads {
namespace {

double raised_left_of(std::span<const Road> roads, const Arm& arm) {
  return arm.step > 0 ? raised_left_m(roads[arm.road]) : raised_right_m(roads[arm.road]);
}

double raised_right_of(std::span<const Road> roads, const Arm& arm) {
  return arm.step > 0 ? raised_right_m(roads[arm.road]) : raised_left_m(roads[arm.road]);
}

std::optional<Ring> stroke_corner(std::span<const Road> roads, const Arm& arm, const Arm& next, double radius_m) {
  const double left = raised_left_of(roads, arm), right = raised_right_of(roads, next);
  if (left == 0 || right == 0) return std::nullopt;
  ArmPath path = path_of(roads, arm), next_path = path_of(roads, next);
  path.left_m += left, next_path.right_m += right;
  const auto fillet = fillet_between(path, next_path, std::max(0.0, radius_m - std::min(left, right)));
  return fillet ? corner_ring(path, next_path, *fillet) : std::nullopt;
}

}  // namespace

std::vector<Ring> stroke_corner_pavements(const Junction& junction, std::span<const Road> roads,
                                          std::span<const Arm> arms) {
  std::vector<ArmLine> lines;
  for (const Arm& arm : arms) lines.push_back(line_of(roads, arm));
  const std::vector<std::uint32_t> next = next_at_place(lines);
  std::vector<Ring> rings;
  for (std::uint32_t a = 0; a < arms.size(); ++a) {
    if (next[a] == a) continue;
    if (auto ring = stroke_corner(roads, arms[a], arms[next[a]], junction.cuts[a].radius_m))
      rings.push_back(std::move(*ring));
  }
  return rings;
}

}  // namespace citykiln::roads
