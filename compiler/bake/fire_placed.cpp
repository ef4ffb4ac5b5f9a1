#include "compiler/bake/fire_placed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/bake/merge.h"

namespace citykiln::bake {
namespace {

// A shared mesh and where it stands. Nothing is left of it below the tolerance. `size_m`: of what a scale of 1 stands
// for.
void fire_instances(Firing& firing, const std::string& name, std::vector<Primitive> primitives,
                    const imprint::Cutout& cutout, const std::vector<Placement>& placements, double size_m = 1) {
  if (primitives.empty() || placements.empty()) return;
  Instanced instanced{name, std::move(primitives), {}, {}, {}, {}, cutout};
  for (const Placement& p : placements) {
    instanced.translations.push_back(offset_from(firing.tile.origin, p.at));
    // half of the turn about z, from cos and sin of the whole
    const double c = std::sqrt(std::max(0.0, (1 + p.cos_yaw) / 2)), s = std::sqrt(std::max(0.0, (1 - p.cos_yaw) / 2));
    instanced.rotations.push_back(
        {0, 0, static_cast<float>(p.sin_yaw < 0 ? -s : s) + 0.0f, static_cast<float>(c) + 0.0f});
    instanced.scales.push_back(static_cast<float>(p.scale / size_m));
    instanced.features.push_back(number_of(firing.tile, p.feature));
  }
  firing.tile.instanced.push_back(std::move(instanced));
}

// "oak_3".
std::string name_of(plants::Prototype prototype) {
  return fmt::format("{}_{}", plants::values_of(prototype.species).file, prototype.variant);
}

double tallest(const std::vector<Placement>& placements) {
  double tallest_m = 0;
  for (const Placement& p : placements) tallest_m = std::max(tallest_m, p.scale);
  return tallest_m;
}

// The same for nearly all tiles, so that they have the same shapes.
double height_m_for(plants::Prototype prototype, const std::vector<Placement>& placements) {
  const double species_m = plants::values_of(prototype.species).tallest_m, here_m = tallest(placements);
  return here_m <= species_m ? species_m : std::max(here_m, plants::kTallestTree_m);
}

plants::Placed told_apart(const plants::Placed& placed, double tolerance_m) {
  const int variants = plants::variants_at(tolerance_m);
  plants::Placed apart;
  for (const auto& [prototype, placements] : placed) {
    const auto variant = static_cast<std::uint8_t>(prototype.variant % variants);
    std::vector<Placement>& together = apart[{prototype.species, variant}];
    together.insert(together.end(), placements.begin(), placements.end());
  }
  return apart;
}

// What stands of one kind; false where the tolerance leaves nothing of it.
bool fire_kind(Firing& firing, const Lamps& lamps, const ground::Carving& carving, props::LampKind kind) {
  constexpr const char* kNames[] = {"PostTopLamp", "ArmLamp"};
  std::vector<Placement> placements;
  for (const props::StreetLamp& lamp : lamps.standing)
    if (lamp.kind == kind) placements.push_back(props::place(lamp, carving));
  const props::Expanded lamp = props::lamp_mesh(kind, tallest(placements), firing.tolerance_m);
  for (const Placement& p : placements) firing.certify(lamp.error_m, bounds_of(p));
  fire_instances(firing, kNames[static_cast<std::size_t>(kind)], shared_primitives(lamp.meshes), {}, placements);
  return !lamp.meshes.empty();
}

}  // namespace

Placed placed_in(const Firing& firing, const Common& common) {
  Placed placed{common.trees, common.lamps};
  if (firing.tolerance_m <= plants::kBlades_m)
    for (const auto& [prototype, placements] : common.blades) placed.trees[prototype] = placements;
  if (!firing.part) return placed;
  for (auto& [prototype, placements] : placed.trees)
    std::erase_if(placements, [&](const Placement& p) { return !firing.holds(bounds_of(p)); });
  placed.lamps = {};
  for (std::size_t i = 0; i < common.lamps.standing.size(); ++i) {
    const props::StreetLamp& lamp = common.lamps.standing[i];
    if (!firing.holds(bounds_of(props::place(lamp, common.carving)))) continue;
    placed.lamps.standing.push_back(lamp);
    if (i < common.lamps.mapped) ++placed.lamps.mapped;
  }
  return placed;
}

void fire_canopy(Firing& firing, const Common& common, Placed& placed) {
  const auto found = common.canopies.find(firing.tolerance_m);
  if (firing.part || found == common.canopies.end()) return;
  plants::Canopy canopy = found->second;
  plants::gather(canopy, firing.chunk.woods, placed.trees);
  firing.tile.plant_error_m = canopy.error_m;
  firing.take(std::move(canopy.meshes));
}

void name_placed(Firing& firing, const Placed& placed) {
  for (const auto& [prototype, placements] : placed.trees)
    for (const Placement& p : placements) firing.features.insert(p.feature);
  for (const props::StreetLamp& lamp : placed.lamps.standing) firing.features.insert(lamp.feature);
}

void fire_trees(Firing& firing, const plants::Placed& placed, const Grove& grove) {
  for (const auto& [prototype, placements] : told_apart(placed, firing.tolerance_m)) {
    const PlantShape& shape = grove.shape(prototype, height_m_for(prototype, placements), firing.tolerance_m);
    firing.tile.plant_error_m = std::max(firing.tile.plant_error_m, shape.error_per_m * tallest(placements));
    fire_instances(firing, name_of(prototype), shape.primitives, shape.cutout, placements, kShape_m);
  }
}

void fire_pits(Firing& firing, const Common& common) {
  for (const props::TreePit& pit : common.pits) {
    const Bounds bounds = bounds_of(Placement{at_height(pit.at, land_m(common.carving, pit.at)), 1, 0, pit.side_m, {}});
    if (!firing.holds(bounds)) continue;
    props::Expanded expanded = props::expand(pit, common.carving, firing.tolerance_m);
    firing.certify(expanded.error_m, bounds);
    firing.take(std::move(expanded.meshes));
  }
}

void fire_lamps(Firing& firing, const Lamps& lamps, const ground::Carving& carving, Report& report) {
  const bool is_left[] = {fire_kind(firing, lamps, carving, props::LampKind::kPostTop),
                          fire_kind(firing, lamps, carving, props::LampKind::kArm)};
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
