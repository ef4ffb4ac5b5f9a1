#include "compiler/ground/profiles/graph/grade_rules.h"

#include <algorithm>

namespace citykiln::ground {
namespace {

using map::LandCoverClass;

struct Row {
  LandCoverClass surface;
  GradeRule rule;
};

constexpr Row kRows[] = {
#define GRADED(surface, limit, smooth_m) {LandCoverClass::surface, {limit, smooth_m}},
#include "compiler/ground/profiles/graph/grade_rules.inc"
#undef GRADED
};

const Row* row_of(LandCoverClass surface) {
  const Row* found = std::ranges::find(kRows, surface, &Row::surface);
  return found == std::end(kRows) ? nullptr : found;
}

}  // namespace

bool has_profile(LandCoverClass surface) { return row_of(surface) != nullptr; }

GradeRule grade_rule_of(LandCoverClass surface) {
  if (const Row* row = row_of(surface)) return row->rule;
  return {0.50, 24};
}

}  // namespace citykiln::ground
