#include "compiler/buildings/generate.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "compiler/buildings/building_materials.h"
#include "compiler/buildings/doors.h"
#include "compiler/buildings/mass_model.h"
#include "compiler/buildings/rule_attributes.h"
#include "compiler/buildings/terminal_meshes.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/contract/tolerance.h"
#include "grammars/derivation/form_roofs.h"

namespace citykiln::buildings {
namespace {

using materials::MaterialMesh;

// What pictures show is as fine as this, whatever the level, so that levels share it: windows keep reveals and frames,
// railings their bars.
constexpr double kLooks_m = 0.05;

// Roofs are whole to this.
constexpr double kWhole_m = 0.02;

// A tower of a hundred floors with a balcony at every window asks for half a million shapes.
constexpr std::uint64_t kMostShapes = 4'000'000, kMostSteps = 400'000'000;

MaterialMesh wall_mesh(const Building& building, std::uint64_t seed) {
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

void expand_plain(const Building& building, const MassModel& mass, std::uint64_t seed, GeneratedBuilding& generated) {
  MaterialMesh wall = wall_mesh(building, seed);
  MaterialMesh top{{}, building.roof, roof_tint(building, seed), building.id.osm};
  for (const grammars::Face& face : mass.walls) add_face(face, wall.mesh);
  add_roof(building, mass.roof, wall.mesh, top.mesh);
  for (MaterialMesh* mesh : {&wall, &top})
    if (!mesh->mesh.triangles.empty()) generated.meshes.push_back(std::move(*mesh));
}

// Of the wall's own stuff; under walls that rules colour, of stone.
void add_foundation(const Building& building, const MassModel& mass, bool has_rules, std::uint64_t seed,
                    GeneratedBuilding& generated) {
  MaterialMesh mesh = wall_mesh(building, seed);
  if (has_rules) mesh.material = materials::Material::kStone, mesh.tint = materials::kNoTint;
  for (const grammars::Face& face : mass.foundation) add_face(face, mesh);
  if (!mesh.mesh.triangles.empty()) generated.meshes.push_back(std::move(mesh));
}

std::uint64_t times_of(const grammars::Derivation& derivation) {
  std::uint64_t times = 0;
  for (const grammars::Warning& warning : derivation.warnings) times += warning.times;
  for (const grammars::LimitHit& limit : derivation.limits) times += limit.times;
  return times;
}

grammars::Derivation derive_on(const Building& building, const MassModel& mass, const grammars::Program& program,
                               SceneContext setting, double tolerance_m, bool keep_appearances) {
  grammars::DeriveOptions options;
  options.attributes = rule_attributes_of(building, mass.roof.form);
  options.attributes["night"] = setting.is_night;
  std::vector<Vec2> doors = door_positions(building);
  options.attributes["entrances"] = static_cast<double>(doors.size());
  if (!doors.empty()) options.occlusion = grammars::entrances_at(std::move(doors));
  options.seed = setting.seed;
  options.tolerance_m = tolerance_m;
  options.keep_start = true, options.ids = false;
  // where pictures show what is left out, looks are theirs; what moves little is known ahead
  options.keep_appearances = keep_appearances, options.ahead = true;
  // roofs that rules put up are whole on every level: what a level leaves out of them the derivation certifies
  options.roofs = grammars::form_roofs(kQuantum_m);
  options.limits.shapes = kMostShapes, options.limits.steps = kMostSteps;
  return grammars::derive(program, shape_of(building, mass), options);
}

// Half of it. Rules are told the roof's form and build on its planes, so it keeps its form under them.
double roof_tolerance_m(const Building& building, bool has_rules, double tolerance_m) {
  const double rise_m = building.roof_shape.height_m;
  return has_rules && rise_m > 0 ? std::min(tolerance_m / 2, rise_m * 0.99) : tolerance_m / 2;
}

// One level, and what all those that show it as pictures share.
struct LevelOf {
  double tolerance_m;
  const impostor::Model* looks;
};

// A mass under rules, and what the level leaves out at most of what they put on its roof.
struct Dressable {
  MassModel mass;
  double left_out_m = 0;
};

// On a roof whose eaves or knees a level does not see rules may find no room for a chimney, which is left out all the
// same. Where both together are more than the tolerance the roof is whole.
Dressable dressable_of(const Building& building, const grammars::Program& program, SceneContext setting, LevelOf level,
                       Report& report) {
  Dressable simple{mass_model_of(building, roof_tolerance_m(building, true, level.tolerance_m), report)};
  if (simple.mass.roof.error_m == 0) return simple;
  Report told_already;
  Dressable whole{mass_model_of(building, roof_tolerance_m(building, true, kWhole_m), told_already)};
  simple.left_out_m =
      derive_on(building, whole.mass, program, setting, level.tolerance_m, level.looks == nullptr).error_m;
  return simple.left_out_m + simple.mass.roof.error_m > level.tolerance_m ? whole : simple;
}

// What the rules make of a building at its full looks.
impostor::Model looks_of(const Building& building, const grammars::Program& program, SceneContext setting) {
  Report told_elsewhere;
  const MassModel mass = mass_model_of(building, roof_tolerance_m(building, true, kLooks_m), told_elsewhere);
  return impostor::model_of(terminal_meshes(
      derive_on(building, mass, program, setting, kLooks_m - mass.roof.error_m, true), building.id.osm));
}

void expand_by_rules(const Building& building, const Dressable& dressable, const grammars::Program& program,
                     SceneContext setting, LevelOf level, GeneratedBuilding& generated, Report& report) {
  const MassModel& mass = dressable.mass;
  // what the roof has left of the tolerance is for rules
  const double tolerance_m = level.tolerance_m - mass.roof.error_m;
  const grammars::Derivation derivation =
      derive_on(building, mass, program, setting, tolerance_m, level.looks == nullptr);
  const std::uint64_t times = times_of(derivation);
  if (times > 0) report.add(Code::kRuleErrors, building.id.osm, static_cast<double>(times));
  FacadeMeshes faces;
  if (level.looks != nullptr)
    faces = texture_facades(derivation, *level.looks, level.tolerance_m, tolerance_m, building.id.osm);
  else
    faces.meshes = terminal_meshes(derivation, building.id.osm);
  generated.error_m += std::max({derivation.error_m, dressable.left_out_m, faces.error_m});
  for (MaterialMesh& mesh : faces.meshes) generated.meshes.push_back(std::move(mesh));
  generated.textured_faces = std::move(faces.textured_faces);
}

// A building no higher than the tolerance, with all that rules put on its roof, is dropped: the ground is that near.
GeneratedBuilding without_what_is_low(const Building& building, double tolerance_m, GeneratedBuilding generated) {
  if (building.top_m - building.bottom_m >= tolerance_m) return generated;
  double top_m = building.top_m;
  for (const MaterialMesh& dressed : generated.meshes)
    for (const Vec3 p : dressed.mesh.positions) top_m = std::max(top_m, p.z);
  for (const TexturedFace& textured_faces : generated.textured_faces)
    for (const Vec3 p : textured_faces.mesh.mesh.positions) top_m = std::max(top_m, p.z);
  const double error_m = top_m - building.bottom_m + generated.error_m;
  return error_m < tolerance_m ? GeneratedBuilding{{}, error_m} : std::move(generated);
}

GeneratedBuilding expand_level(const Building& building, const Rulebook& rulebook, SceneContext setting, LevelOf level,
                               Report& report) {
  const auto program = rulebook.find(building.style);
  const bool has_rules = program != rulebook.end();
  const Dressable dressable =
      has_rules ? dressable_of(building, program->second, setting, level, report)
                : Dressable{mass_model_of(building, roof_tolerance_m(building, false, level.tolerance_m), report)};
  GeneratedBuilding generated{{}, dressable.mass.roof.error_m};
  add_foundation(building, dressable.mass, has_rules, setting.seed, generated);
  if (has_rules) {
    expand_by_rules(building, dressable, program->second, setting, level, generated, report);
  } else {
    expand_plain(building, dressable.mass, setting.seed, generated);
  }
  return without_what_is_low(building, level.tolerance_m, std::move(generated));
}

}  // namespace

GeneratedBuilding generate(const Building& building, const Rulebook& rulebook, SceneContext setting, double tolerance_m,
                           Report& report) {
  return std::move(generate(building, rulebook, setting, std::span(&tolerance_m, 1), std::span(&report, 1)).front());
}

std::vector<GeneratedBuilding> generate(const Building& building, const Rulebook& rulebook, SceneContext setting,
                                        std::span<const double> tolerances_m, std::span<Report> reports) {
  const auto program = rulebook.find(building.style);
  std::optional<impostor::Model> looks;
  std::vector<GeneratedBuilding> levels;
  for (std::size_t i = 0; i < tolerances_m.size(); ++i) {
    const bool is_imprinted = program != rulebook.end() && has_detail(Detail::kFacadeTextures, tolerances_m[i]);
    if (is_imprinted && !looks) looks = looks_of(building, program->second, setting);
    const LevelOf level{tolerances_m[i], is_imprinted ? &*looks : nullptr};
    levels.push_back(expand_level(building, rulebook, setting, level, reports[i]));
  }
  return levels;
}

}  // namespace citykiln::buildings
