#include "compiler/bake/parts/bake_instances.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/bake/baked_cell.h"
#include "compiler/bake/merge.h"
#include "compiler/bake/parts/stands.h"
#include "compiler/contract/detail_tolerances.h"

namespace citykiln::bake {
InstancedMesh instances_of(const Baking& baking, const std::string& name, const std::vector<Placement>& placements,
                           double size_m) {
  InstancedMesh instanced{.name = name, .primitives = {}};
  for (const Placement& p : placements) {
    instanced.translations.push_back(offset_from(baking.tile.origin, p.at));
    // half of the rotation about z, from cosine and sine of the whole
    const double c = std::sqrt(std::max(0.0, (1 + p.cos_yaw) / 2)), s = std::sqrt(std::max(0.0, (1 - p.cos_yaw) / 2));
    instanced.rotations.push_back(
        {0, 0, static_cast<float>(p.sin_yaw < 0 ? -s : s) + 0.0f, static_cast<float>(c) + 0.0f});
    instanced.scales.push_back(static_cast<float>(p.scale / size_m));
    instanced.features.push_back(feature_index(baking.tile, p.feature));
  }
  return instanced;
}

void tilt(InstancedMesh& instanced, std::size_t copy, Vec3 up) {
  if (up == Vec3{0, 0, 1}) return;
  // the shortest turn from z to `up`, after that about z
  const double norm = std::sqrt(2 * (1 + up.z)), x = -up.y / norm, y = up.x / norm, w = (1 + up.z) / norm;
  const double z0 = instanced.rotations[copy][2], w0 = instanced.rotations[copy][3];
  instanced.rotations[copy] = {static_cast<float>(x * w0 + y * z0), static_cast<float>(y * w0 - x * z0),
                               static_cast<float>(w * z0), static_cast<float>(w * w0)};
}

namespace {

// "oak_3".
std::string name_of(const plants::SpeciesTable& table, plants::Prototype prototype) {
  return fmt::format("{}_{}", table[prototype.species].file, prototype.variant);
}

double tallest(const std::vector<Placement>& placements) {
  double tallest_m = 0;
  for (const Placement& p : placements) tallest_m = std::max(tallest_m, p.scale);
  return tallest_m;
}

plants::PlacedPlants merged_variants(const plants::PlacedPlants& placed, double tolerance_m) {
  plants::PlacedPlants merged;
  for (const auto& [prototype, placements] : placed) {
    std::vector<Placement>& all = merged[merged_variant(prototype, tolerance_m)];
    all.insert(all.end(), placements.begin(), placements.end());
  }
  return merged;
}

// Adds each stand as one instance.
void bake_stands(Baking& baking, const Stands& stands, const PrototypeCache& prototypes) {
  for (const auto& [key, placements] : stands) {
    const plants::Prototype prototype = key.prototype;
    const double height_m = prototype_height_m(tallest(placements));
    const BakedPrototype& baked = prototypes.prototype(
        prototype, height_m,
        stand_tolerance_m(prototypes.species()[prototype.species], baking.tolerance_m, key.is_inner));
    if (baked.primitives.empty()) continue;
    baking.tile.plant_error_m = std::max(baking.tile.plant_error_m, baked.error_per_m * tallest(placements));
    InstancedMesh stand =
        stand_mesh(baked, height_m, placements, baking.tile.origin, feature_index(baking.tile, key.element));
    stand.name = fmt::format("stand_of_{}", name_of(prototypes.species(), prototype));
    baking.tile.instanced.push_back(std::move(stand));
  }
}

// The size for which the mesh of a kind of lamp is made.
double tallest_of(const Baking& baking, props::LampKind kind, const std::vector<Placement>& placements) {
  return baking.cell ? baking.cell->tallest_lamps_m.at(kind) : tallest(placements);
}

// Adds the lamps of one kind; returns false where the tolerance drops them.
bool bake_lamp_kind(Baking& baking, const Lamps& lamps, const ground::GradedTerrain& graded, props::LampKind kind) {
  std::vector<Placement> placements;
  for (const props::StreetLamp& lamp : lamps.standing)
    if (lamp.kind == kind) placements.push_back(props::place(lamp, graded));
  if (placements.empty()) return true;
  const double tallest_m = tallest_of(baking, kind, placements), height_m = prototype_height_m(tallest_m);
  props::GeneratedProp lamp = props::lamp_mesh(kind, tallest_m, baking.tolerance_m,
                                               scene::are_lamps_lit(baking.header.shown, baking.header.sky));
  for (materials::MaterialMesh& part : lamp.meshes)
    for (Vec3& p : part.mesh.positions) p = p * height_m;
  for (const Placement& p : placements) baking.certify(lamp.error_m, bounds_of(p));
  if (lamp.meshes.empty()) return false;
  InstancedMesh instanced = instances_of(baking, std::string(props::name_of(kind)), placements, height_m);
  instanced.primitives = instanced_primitives(lamp.meshes, Layer::kProps);
  baking.tile.instanced.push_back(std::move(instanced));
  return true;
}

// The distance from the foot to the rim of the widest crown, at the height of its top, as a share of the height. Leaves
// of shipped plants other than blades are at most 1.15 heights away.
constexpr double kReach = 1.25;
static_assert(kReach * kReach == 1 + plants::kWidestCrown * plants::kWidestCrown / 4);
constexpr double kHighestLeftOut_m = 2;

void leave_out_low_plants(Placed& placed, double tolerance_m) {
  const double highest_m = std::min(kHighestLeftOut_m, tolerance_m / kReach);
  for (auto& [prototype, placements] : placed.trees)
    std::erase_if(placements, [&](const Placement& p) {
      if (p.scale > highest_m) return false;
      placed.left_out_m = std::max(placed.left_out_m, kReach * p.scale);
      return true;
    });
}

}  // namespace

plants::Prototype merged_variant(plants::Prototype prototype, double tolerance_m) {
  const int variants = plants::variants_at(tolerance_m);
  return {prototype.species, static_cast<std::uint8_t>(prototype.variant % variants)};
}

Placed placed_in(const Baking& baking, const SharedByLevels& shared) {
  Placed placed{shared.trees, shared.lamps, shared.things};
  if (has_detail(Detail::kGrassBlades, baking.tolerance_m))
    for (const auto& [prototype, placements] : shared.blades) placed.trees[prototype] = placements;
  leave_out_low_plants(placed, baking.tolerance_m);
  if (!baking.part) {
    placed.drawn_left_out_m = leave_out_drawn(baking.header, baking.chunk, baking.tolerance_m, placed.things);
    return placed;
  }
  for (auto& [prototype, placements] : placed.trees)
    std::erase_if(placements, [&](const Placement& p) { return !baking.holds(bounds_of(p)); });
  std::erase_if(placed.things, [&](const PlacedThing& thing) { return !baking.holds(bounds_of(thing)); });
  placed.lamps = {};
  for (std::size_t i = 0; i < shared.lamps.standing.size(); ++i) {
    const props::StreetLamp& lamp = shared.lamps.standing[i];
    if (!baking.holds(bounds_of(props::place(lamp, *shared.graded)))) continue;
    placed.lamps.standing.push_back(lamp);
    if (i < shared.lamps.mapped) ++placed.lamps.mapped;
  }
  return placed;
}

void bake_canopy(Baking& baking, const TileLevel& level, Placed& placed) {
  if (!level.canopy) return;
  plants::Canopy canopy = level.shared->canopies[*level.canopy];
  plants::remove_trees_below(canopy, baking.chunk.woods, placed.trees);
  baking.tile.plant_error_m = canopy.error_m;
  baking.take(std::move(canopy.meshes), Layer::kPlants);
}

void add_features_of(Baking& baking, const Placed& placed) {
  for (const auto& [prototype, placements] : placed.trees)
    for (const Placement& p : placements) baking.features.insert(p.feature);
  for (const props::StreetLamp& lamp : placed.lamps.standing) baking.features.insert(lamp.feature);
  for (const PlacedThing& thing : placed.things) baking.features.insert(thing.placement.feature);
}

void bake_trees(Baking& baking, const Placed& placed, const PrototypeCache& prototypes, std::size_t most_instances) {
  plants::PlacedPlants trees = placed.trees;
  baking.tile.plant_error_m = std::max(baking.tile.plant_error_m, placed.left_out_m);
  const std::size_t others = placed.lamps.standing.size() + placed.things.size();
  bake_stands(baking,
              take_stands(trees, {scene::box_of(baking.header, baking.chunk.tile), baking.chunk.roads},
                          baking.tolerance_m, most_instances - std::min(others, most_instances), prototypes.species()),
              prototypes);
  for (const auto& [prototype, placements] : merged_variants(trees, baking.tolerance_m)) {
    if (placements.empty()) continue;
    const double tallest_m = baking.cell ? baking.cell->tallest_plants_m.at(prototype) : tallest(placements);
    const double height_m = prototype_height_m(tallest_m);
    const BakedPrototype& baked = prototypes.prototype(prototype, height_m, baking.tolerance_m);
    baking.tile.plant_error_m = std::max(baking.tile.plant_error_m, baked.error_per_m * tallest_m);
    if (baked.primitives.empty()) continue;
    InstancedMesh instanced = instances_of(baking, name_of(prototypes.species(), prototype), placements, height_m);
    instanced.cutout = baked.cutout;
    if (!baking.cell) instanced.primitives = baked.primitives;
    baking.cell ? baking.cell->plants.push_back({&baked, std::move(instanced)})
                : baking.tile.instanced.push_back(std::move(instanced));
  }
}

Bounds bounds_of_pit(const props::TreePit& pit, const ground::GradedTerrain& graded) {
  const double ground_m = land_m(graded, pit.at);
  return {Box2{pit.at, pit.at}.widened(pit.side_m / 2), ground_m, ground_m + pit.side_m};
}

void bake_tree_pits(Baking& baking, const SharedByLevels& shared) {
  for (const props::TreePit& pit : shared.pits) {
    const Bounds bounds = bounds_of_pit(pit, *shared.graded);
    if (!baking.holds(bounds)) continue;
    props::GeneratedProp generated = props::generate(pit, *shared.graded, baking.tolerance_m);
    baking.certify(generated.error_m, bounds);
    baking.take(std::move(generated.meshes), Layer::kProps);
  }
}

void bake_lamps(Baking& baking, const Lamps& lamps, const ground::GradedTerrain& graded, Report& report) {
  const bool is_left[] = {bake_lamp_kind(baking, lamps, graded, props::LampKind::kPostTop),
                          bake_lamp_kind(baking, lamps, graded, props::LampKind::kArm)};
  Account mapped, derived;
  for (std::size_t i = 0; i < lamps.standing.size(); ++i) {
    const props::StreetLamp& lamp = lamps.standing[i];
    Account& account = i < lamps.mapped ? mapped : derived;
    ++account.in;
    if (is_left[static_cast<std::size_t>(lamp.kind)])
      ++account.out;
    else if (i < lamps.mapped)
      report.drop(account, Code::kBelowTolerance, lamp.feature, lamp.height_m);
    else
      ++account.dropped[Code::kBelowTolerance];
  }
  report.account("bake", "lamp") = mapped;
  report.account("bake", "derived lamp") = derived;
}

}  // namespace citykiln::bake
