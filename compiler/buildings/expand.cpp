#include "compiler/buildings/expand.h"

#include <algorithm>
#include <utility>

#include "compiler/buildings/dress.h"
#include "compiler/buildings/dress_terminals.h"
#include "compiler/buildings/mass.h"
#include "compiler/buildings/rule_values.h"
#include "compiler/contract/tolerance.h"
#include "grammars/form_roofs.h"

namespace citykiln::buildings {
namespace {

using materials::DressedMesh;

// Tolerances at which nobody counts windows.
constexpr double kFar_m = 1;

// A tower of a hundred floors with a balcony at every window asks for half a million shapes.
constexpr std::uint64_t kMostShapes = 4'000'000, kMostSteps = 400'000'000;

DressedMesh wall_mesh(const Building& building, std::uint64_t seed) {
  return {{}, building.wall, wall_tint(building, seed), building.id.osm};
}

// Roof planes and eaves, and gables, which are wall.
void add_roof(const Building& building, const roofs::Roof& roof, Mesh& wall, Mesh& top) {
  for (Mesh* mesh : {&wall, &top}) {
    const auto first = static_cast<std::uint32_t>(mesh->positions.size());
    for (const Vec3 p : roof.positions) mesh->positions.push_back({p.x, p.y, p.z + eaves_m(building)});
    for (std::size_t i = 0; i < roof.triangles.size(); ++i) {
      const auto [a, b, c] = roof.triangles[i];
      const bool is_wall = roof.parts[i] == roofs::Part::kGable;
      if (is_wall == (mesh == &wall)) mesh->triangles.push_back({first + a, first + b, first + c});
    }
  }
}

void expand_plain(const Building& building, const Mass& mass, std::uint64_t seed, Expanded& expanded) {
  DressedMesh wall = wall_mesh(building, seed);
  DressedMesh top{{}, building.roof, roof_tint(building, seed), building.id.osm};
  for (const grammars::Face& face : mass.walls) add_face(face, wall.mesh);
  add_roof(building, mass.roof, wall.mesh, top.mesh);
  for (DressedMesh* mesh : {&wall, &top})
    if (!mesh->mesh.triangles.empty()) expanded.meshes.push_back(std::move(*mesh));
}

// Of the wall's own stuff; under walls that rules colour, of stone.
void add_foundation(const Building& building, const Mass& mass, bool has_rules, std::uint64_t seed,
                    Expanded& expanded) {
  DressedMesh mesh = wall_mesh(building, seed);
  if (has_rules) mesh.material = materials::Material::kStone, mesh.tint = materials::kNoTint;
  for (const grammars::Face& face : mass.foundation) add_face(face, mesh);
  if (!mesh.mesh.triangles.empty()) expanded.meshes.push_back(std::move(mesh));
}

std::uint64_t times_of(const grammars::Derivation& derivation) {
  std::uint64_t times = 0;
  for (const grammars::Trouble& trouble : derivation.troubles) times += trouble.times;
  for (const grammars::LimitHit& limit : derivation.limits) times += limit.times;
  return times;
}

void expand_by_rules(const Building& building, const Mass& mass, const grammars::Program& program, std::uint64_t seed,
                     double tolerance_m, Expanded& expanded, Report& report) {
  grammars::DeriveOptions options;
  options.attributes = rule_values_of(building, mass.roof.form);
  options.seed = seed;
  options.tolerance_m = tolerance_m;
  options.keep_start = true;
  // from afar windows are no wider than what may be left out, and what moves little is known ahead
  options.keep_looks = tolerance_m < kFar_m, options.ahead = true;
  // roofs that rules put up are whole on every level: what a level leaves out of them the derivation certifies
  options.roofs = grammars::form_roofs(kQuantum_m);
  options.limits.shapes = kMostShapes, options.limits.steps = kMostSteps;
  const grammars::Derivation derivation = grammars::derive(program, shape_of(building, mass), options);
  const std::uint64_t times = times_of(derivation);
  if (times > 0) report.add(Code::kRuleTrouble, building.id.osm, static_cast<double>(times));
  expanded.error_m += derivation.error_m;
  for (DressedMesh& mesh : meshes_of(derivation, building.id.osm)) expanded.meshes.push_back(std::move(mesh));
}

// Half of it. Rules are told the roof's form and build on its planes, so it keeps its form under them.
double roof_tolerance_m(const Building& building, bool has_rules, double tolerance_m) {
  const double rise_m = building.roof_shape.height_m;
  return has_rules && rise_m > 0 ? std::min(tolerance_m / 2, rise_m * 0.99) : tolerance_m / 2;
}

// A building no higher than the tolerance, with all that rules put on its roof, is dropped: the ground is that near.
Expanded without_what_is_low(const Building& building, double tolerance_m, Expanded expanded) {
  if (building.top_m - building.bottom_m >= tolerance_m) return expanded;
  double top_m = building.top_m;
  for (const DressedMesh& dressed : expanded.meshes)
    for (const Vec3 p : dressed.mesh.positions) top_m = std::max(top_m, p.z);
  const double error_m = top_m - building.bottom_m + expanded.error_m;
  return error_m < tolerance_m ? Expanded{{}, error_m} : std::move(expanded);
}

}  // namespace

Expanded expand(const Building& building, const Rulebook& rulebook, std::uint64_t seed, double tolerance_m,
                Report& report) {
  const auto program = rulebook.find(building.style);
  const Mass mass = mass_of(building, roof_tolerance_m(building, program != rulebook.end(), tolerance_m), report);
  Expanded expanded{{}, mass.roof.error_m};
  add_foundation(building, mass, program != rulebook.end(), seed, expanded);
  if (program == rulebook.end()) {
    expand_plain(building, mass, seed, expanded);
  } else {
    // what the roof has left of the tolerance is for rules
    expand_by_rules(building, mass, program->second, seed, tolerance_m - mass.roof.error_m, expanded, report);
  }
  return without_what_is_low(building, tolerance_m, std::move(expanded));
}

}  // namespace citykiln::buildings
