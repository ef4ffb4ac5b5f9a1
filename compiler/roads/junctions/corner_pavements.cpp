#include "compiler/roads/junctions/corner_pavements.h"

#include <algorithm>
#include <cassert>

#include "compiler/roads/junctions/arm_lines.h"
#include "compiler/roads/junctions/junction_ring.h"

namespace citykiln::roads {
namespace {

// Widths up to the outermost pavement: verges outside pavements do not lead round corners.
double paved_left_of(std::span<const Road> roads, const Arm& arm) {
  return arm.step > 0 ? paved_left_m(roads[arm.road]) : paved_right_m(roads[arm.road]);
}

double paved_right_of(std::span<const Road> roads, const Arm& arm) {
  return arm.step > 0 ? paved_right_m(roads[arm.road]) : paved_left_m(roads[arm.road]);
}

// An arm with the width of its pavement and the length along which that may be part of a corner.
struct RaisedArm {
  ArmPath path;
  double raised_m = 0, limit_m = 0;
};

RaisedArm raised_arm(std::span<const Road> roads, const Arm& arm, double raised_m, const Cut& cut) {
  return {arm_path(roads, arm), raised_m, std::min(cut.length_m, kJunctionRadius_m) + raised_m};
}

// The outline of a corner up to an arc that lies raised_m of both arms outside the kerb's arc.
std::optional<Ring> stroke_corner(RaisedArm arm, RaisedArm next, double radius_m) {
  if (arm.raised_m == 0 || next.raised_m == 0) return std::nullopt;
  arm.path.left_m += arm.raised_m, next.path.right_m += next.raised_m;
  const auto fillet =
      fillet_between(arm.path, next.path, std::max(0.0, radius_m - std::min(arm.raised_m, next.raised_m)));
  if (!fillet || fillet->arm.along_m > arm.limit_m || fillet->next.along_m > next.limit_m) return std::nullopt;
  return corner_ring(arm.path, next.path, *fillet);
}

// Strokes all corners of a junction whose arms both have pavement, of which at most widest_m count.
std::vector<Ring> stroke_corners(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms,
                                 double widest_m) {
  assert(arms.size() == junction.cuts.size());
  const std::vector<ArmLine> lines = arm_lines(roads, arms);
  const std::vector<std::uint32_t> next = next_at_node(lines);
  std::vector<Ring> rings;
  for (std::uint32_t a = 0; a < arms.size(); ++a) {
    if (next[a] == a) continue;
    const Arm &arm = arms[a], &other = arms[next[a]];
    const double arm_m = std::min(paved_left_of(roads, arm), widest_m),
                 other_m = std::min(paved_right_of(roads, other), widest_m);
    if (auto ring = stroke_corner(raised_arm(roads, arm, arm_m, junction.cuts[a]),
                                  raised_arm(roads, other, other_m, junction.cuts[next[a]]), junction.cuts[a].radius_m))
      rings.push_back(std::move(*ring));
  }
  return rings;
}

}  // namespace

std::vector<Ring> stroke_corner_pavements(const Junction& junction, std::span<const Road> roads,
                                          std::span<const Arm> arms) {
  constexpr double kWidest_m = 6;
  return stroke_corners(junction, roads, arms, kWidest_m);
}

std::vector<Ring> stroke_corner_kerbs(const Junction& junction, std::span<const Road> roads, std::span<const Arm> arms,
                                      double kerb_m) {
  return stroke_corners(junction, roads, arms, kerb_m);
}

}  // namespace citykiln::roads
