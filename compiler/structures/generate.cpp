#include "compiler/structures/generate.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/ground/grading/road_influence.h"
#include "compiler/structures/deck.h"
#include "compiler/structures/loft.h"
#include "compiler/structures/plate_mesh.h"
#include "compiler/structures/supports.h"

namespace citykiln::structures {
namespace {

// ---- railings -------------------------------------------------------------------------------------------------------

enum class RailingForm { kPosts, kPanel, kNone };

struct RailingDetail {
  RailingForm form{};
  double error_m = 0;  // Deviation from the form kPosts.
};

// Thickness of posts and rails, and the largest distance between posts.
constexpr double kPost_m = 0.0625, kRail_m = 0.0625, kPostsApart_m = 2;
constexpr int kRails = 3;

void add_rail(std::span<const Rib> ribs, double left_m, double top_m, double high_m, Mesh& mesh) {
  const double l = left_m + kRail_m / 2, r = left_m - kRail_m / 2, bottom_m = top_m - high_m;
  add_tube(ribs, {{l, bottom_m}, {l, top_m}, {r, top_m}, {r, bottom_m}}, mesh);
}

void add_post(const Rib& rib, double left_m, double from_m, double to_m, Mesh& mesh) {
  const Vec2 across = unit(rib.out) * (kPost_m / 2), along = left_of(across);
  const Vec2 at = rib.at + rib.out * left_m;
  const double road_m = rib.z_m + rib.tilt * left_m;
  add_prism(std::array{at - across - along, at + across - along, at + across + along, at - across + along},
            road_m + from_m, road_m + to_m, mesh);
}

void add_posts(std::span<const Rib> ribs, double left_m, double from_m, double to_m, Mesh& mesh) {
  const double first_m = ribs.front().along_m + kPost_m, long_m = ribs.back().along_m - kPost_m - first_m;
  const int gaps = std::max(1, static_cast<int>(std::ceil(long_m / kPostsApart_m)));
  for (int i = 0; i <= gaps; ++i) add_post(rib_at(ribs, first_m + long_m * i / gaps), left_m, from_m, to_m, mesh);
}

// Returns the coarsest form of a railing within the tolerance.
// @param high_m  Height from its foot to its top.
RailingDetail railing_detail(double high_m, double tolerance_m) {
  assert(high_m > 0 && tolerance_m >= 0);
  // the middle between two rails is half their distance from them
  const double panel_error_m = high_m / kRails / 2 + kRail_m;
  if (tolerance_m < panel_error_m) return {RailingForm::kPosts, 0};
  if (tolerance_m < high_m) return {RailingForm::kPanel, panel_error_m};
  return {RailingForm::kNone, high_m};
}

// Adds a railing along ribs. Every post, rail and panel is closed.
// @param left_m        Distance of its middle to the left of the axis.
// @param from_m, to_m  Height of its foot and its top above the road.
void add_railing(std::span<const Rib> ribs, double left_m, double from_m, double to_m, RailingForm form, Mesh& mesh) {
  assert(ribs.size() >= 2 && from_m <= to_m);
  if (form == RailingForm::kPanel) add_rail(ribs, left_m, to_m, to_m - from_m, mesh);
  if (form != RailingForm::kPosts) return;
  for (int i = 1; i <= kRails; ++i) add_rail(ribs, left_m, from_m + (to_m - from_m) * i / kRails, kRail_m, mesh);
  add_posts(ribs, left_m, from_m, to_m - kRail_m, mesh);
}

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
  const bool has_abutments = bridge.deck != DeckForm::kNone && budget.keeps(kAbutment_m);
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

// The largest thickness of plates under paths and roads.
constexpr double kFootPlate_m = 0.75, kRoadPlate_m = 1;

// Railings along the walls of a plate.
void add_plate_railings(const Plate& plate, const DeckDimensions& shape, Budget& budget,
                        GeneratedStructure& generated) {
  if (shape.railing_m == 0) return;
  const RailingDetail detail = railing_detail(shape.railing_m, budget.tolerance_m);
  budget.error_m = std::max(budget.error_m, detail.error_m);
  Mesh mesh;
  for (const std::vector<Rib>& run : wall_runs(plate))
    add_railing(run, kParapet_m / 2, shape.parapet_m, shape.railing_m, detail.form, mesh);
  if (!mesh.triangles.empty())
    generated.meshes.push_back({std::move(mesh), materials::Material::kPaintedMetal, materials::kNoTint, plate.id});
}

void add_plates(const Span& bridge, Budget& budget, GeneratedStructure& generated) {
  DeckDimensions shape = deck_dimensions(bridge, longest_bay_m(bridge));
  // plates bear in two directions, and leave most of the clearance below the road's top free
  shape.thickness_m = std::min(shape.thickness_m, shape.railing_m > 0 ? kFootPlate_m : kRoadPlate_m);
  for (const Plate& plate : bridge.plates) {
    PlateDetail detail{.has_slab = budget.keeps(shape.thickness_m)};
    detail.has_parapets = budget.keeps(length(Vec2{shape.parapet_m, kParapet_m})) && detail.has_slab;
    add_plate(plate, shape, detail, generated);
    add_plate_railings(plate, shape, budget, generated);
  }
}

// A bridge on a plate: its road, and piers that reach into the plate.
void add_carried(const Span& bridge, const std::vector<Rib>& ribs, Budget& budget, GeneratedStructure& generated) {
  if (bridge.deck == DeckForm::kPlate) {
    const bool has_kerbs = has_detail(Detail::kRoadSurfaces, budget.tolerance_m / kPartShare);
    if (!has_kerbs) budget.error_m = std::max(budget.error_m, ground::kKerbRise_m);
    const Section road = add_road(bridge, ribs, has_kerbs, budget.tolerance_m / kPartShare, generated);
    Mesh kerbs;
    add_kerb_faces(ribs, road, kerbs);
    add_bridge_concrete(std::move(kerbs), bridge, generated);
  }
  add_supports(bridge, ribs, deck_dimensions(bridge, 0), budget, generated);
}

}  // namespace

GeneratedStructure generate(const Span& bridge, double tolerance_m) {
  assert(tolerance_m > 0);
  GeneratedStructure generated;
  Budget budget{kPartShare * tolerance_m};
  add_plates(bridge, budget, generated);
  const std::vector<Rib> all = ribs_of(bridge);
  generated.error_m = budget.error_m;
  if (all.empty()) return generated;
  if (bridge.deck != DeckForm::kOwn) {
    add_carried(bridge, all, budget, generated);
    generated.error_m = budget.error_m;
    return generated;
  }
  const DeckDimensions shape = deck_dimensions(bridge, longest_bay_m(bridge));
  SimplifiedRibs few =
      simplify_ribs(all, shape.left_m + kParapet_m, shape.right_m + kParapet_m, kRibShare * tolerance_m);
  const DeckDetail detail = detail_of(shape, tolerance_m, budget);
  if (detail.has_parapets) few.ribs = with_gap_ribs(bridge, few.ribs);
  add_deck(bridge, few.ribs, shape, detail, tolerance_m, generated);
  add_railings(bridge, few.ribs, shape, budget, generated);
  add_supports(bridge, few.ribs, shape, budget, generated);
  generated.error_m = few.error_m + budget.error_m;
  return generated;
}

}  // namespace citykiln::structures
