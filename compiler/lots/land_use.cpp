#include "compiler/lots/land_use.h"

#include <utility>

#include "compiler/lots/land_of.h"

namespace citykiln::lots {
namespace {

constexpr double kUseBucket_m = 64;

}  // namespace

using map::LandCoverClass;

LandUse index_land_use(const map::FeatureView& features) {
  LandUse uses{features.areas, {}, {}};
  std::vector<Box2> boxes;
  for (std::uint32_t i = 0; i < uses.areas.size(); ++i) {
    if (!is_land_of_yards(uses.areas[i].surface) || uses.areas[i].polygon.outer.empty()) continue;
    uses.numbers.push_back(i);
    boxes.push_back(box_of(uses.areas[i].polygon.outer));
  }
  if (!boxes.empty()) uses.grid = grid_of(boxes, kUseBucket_m);
  return uses;
}

LandCoverClass land_use_at(const LandUse& uses, Vec2 p) {
  const map::AreaFeature* smallest = nullptr;
  if (uses.numbers.empty()) return LandCoverClass::kUnknown;
  for (const std::uint32_t i : boxes_about(uses.grid, p)) {
    const map::AreaFeature& area = uses.areas[uses.numbers[i]];
    const bool is_smaller = !smallest || std::pair(area.area_m2, area.id) < std::pair(smallest->area_m2, smallest->id);
    if (is_smaller && contains(area.polygon, p)) smallest = &area;
  }
  return smallest ? smallest->surface : LandCoverClass::kUnknown;
}

}  // namespace citykiln::lots
