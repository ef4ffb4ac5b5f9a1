#include "compiler/structures/generate.h"

#include <algorithm>
#include <cassert>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/ground/grading/road_influence.h"
#include "compiler/structures/deck.h"
#include "compiler/structures/railing.h"
#include "compiler/structures/supports.h"

namespace citykiln::structures {
namespace {

// Shares of the tolerance: errors of omitted ribs and of omitted parts add up.
constexpr double kRibShare = 0.25, kPartShare = 0.75;

// Decides which parts are omitted, and keeps the largest error.
struct Budget {
  double tolerance_m;
  double error_m = 0;
  bool keeps(double part_m) {
    if (part_m > tolerance_m) return true;
    error_m = std::max(error_m, part_m);
    return false;
  }
};

void add_bridge_concrete(Mesh&& mesh, const Span& bridge, GeneratedStructure& generated) {
  if (mesh.triangles.empty()) return;
  generated.meshes.push_back({std::move(mesh), materials::Material::kConcrete, materials::kNoTint, bridge.id.osm});
}

void add_railings(const Span& bridge, std::span<const Rib> ribs, const DeckDimensions& shape, Budget& budget,
                  GeneratedStructure& generated) {
  if (shape.railing_m == 0) return;
  // its error is measured from the road, since the parapet under it may be omitted too
  const RailingDetail detail = railing_detail(shape.railing_m, budget.tolerance_m);
  budget.error_m = std::max(budget.error_m, detail.error_m);
  Mesh mesh;
  for (const EdgeRun& run : edge_runs(bridge, ribs)) {
    if (!run.is_left_open)
      add_railing(run.ribs, shape.left_m + kParapet_m / 2, shape.parapet_m, shape.railing_m, detail.form, mesh);
    if (!run.is_right_open)
      add_railing(run.ribs, -shape.right_m - kParapet_m / 2, shape.parapet_m, shape.railing_m, detail.form, mesh);
  }
  if (!mesh.triangles.empty())
    generated.meshes.push_back(
        {std::move(mesh), materials::Material::kPaintedMetal, materials::kNoTint, bridge.id.osm});
}

void add_supports(const Span& bridge, std::span<const Rib> ribs, const DeckDimensions& shape, Budget& budget,
                  GeneratedStructure& generated) {
  Mesh mesh;
  for (const Pier& pier : bridge.piers)
    // the middle of an omitted pier is half its height away from deck and ground
    if (budget.keeps((rib_at(ribs, pier.at_m).z_m - pier.foot_m) / 2)) add_pier(ribs, shape, pier, mesh);
  const bool has_abutments = budget.keeps(kAbutment_m);
  if (has_abutments && is_on_ground(bridge.from)) add_abutment(ribs, shape, true, mesh);
  if (has_abutments && is_on_ground(bridge.to)) add_abutment(ribs, shape, false, mesh);
  add_bridge_concrete(std::move(mesh), bridge, generated);
}

DeckDetail detail_of(const DeckDimensions& shape, double tolerance_m, Budget& budget) {
  DeckDetail detail;
  detail.has_kerbs = has_detail(Detail::kRoadSurfaces, tolerance_m);
  if (!detail.has_kerbs) budget.error_m = ground::kKerbRise_m;
  detail.has_slab = budget.keeps(length(Vec2{shape.thickness_m, kParapet_m}));
  detail.has_parapets = detail.has_slab && budget.keeps(length(Vec2{shape.parapet_m, kParapet_m}));
  return detail;
}

}  // namespace

GeneratedStructure generate(const Span& bridge, double tolerance_m) {
  assert(tolerance_m > 0);
  GeneratedStructure generated;
  const std::vector<Rib> all = ribs_of(bridge);
  if (all.empty()) return generated;
  const DeckDimensions shape = deck_dimensions(bridge, longest_bay_m(bridge));
  SimplifiedRibs few =
      simplify_ribs(all, shape.left_m + kParapet_m, shape.right_m + kParapet_m, kRibShare * tolerance_m);
  Budget budget{kPartShare * tolerance_m};
  const DeckDetail detail = detail_of(shape, tolerance_m, budget);
  if (detail.has_parapets) few.ribs = split_at_gaps(bridge, few.ribs);
  add_deck(bridge, few.ribs, shape, detail, tolerance_m, generated);
  add_railings(bridge, few.ribs, shape, budget, generated);
  add_supports(bridge, few.ribs, shape, budget, generated);
  generated.error_m = few.error_m + budget.error_m;
  return generated;
}

}  // namespace citykiln::structures
