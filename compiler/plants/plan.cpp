#include "compiler/plants/plan.h"

#include <algorithm>

namespace citykiln::plants {
namespace {

struct WoodRow {
  map::SurfaceClass surface;
  double spacing_m, height_m;
  int needle_255ths;
};

constexpr WoodRow kWoods[] = {
#define WOOD(surface, spacing_m, height_m, needles) {map::SurfaceClass::surface, spacing_m, height_m, needles},
#include "compiler/plants/woods_of.inc"
#undef WOOD
};

}  // namespace

Plants plan(const map::Features& features, std::span<const ground::Surface> surfaces, Report& report) {
  Plants plants;
  Account account;
  for (const map::PointFeature& point : features.points) {
    if (point.kind != map::PointKind::kTree) continue;
    ++account.in, ++account.out;
    plants.trees.push_back(
        {point.id, point.at, point.height_m, point.growth.leaves == map::LeafType::kNeedle ? Species::kSpruce : Species::kLime});
  }
  for (const ground::Surface& surface : surfaces)
    for (const WoodRow& row : kWoods)
      if (row.surface == surface.surface)
        plants.woods.push_back({surface.id, row.spacing_m, row.needle_255ths / 255.0, row.height_m});
  std::sort(plants.trees.begin(), plants.trees.end(), [](const Tree& a, const Tree& b) { return a.id < b.id; });
  std::sort(plants.woods.begin(), plants.woods.end(),
            [](const Wood& a, const Wood& b) { return a.surface < b.surface; });
  report.account("plants", "tree") = account;
  return plants;
}

}  // namespace citykiln::plants
