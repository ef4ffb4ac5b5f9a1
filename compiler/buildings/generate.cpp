#include "compiler/buildings/generate.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

#include "compiler/buildings/meshes/cut_passageways.h"
#include "compiler/buildings/meshes/mass_model.h"
#include "compiler/buildings/meshes/posts.h"
#include "compiler/buildings/meshes/rule_attributes.h"
#include "compiler/buildings/meshes/terminal_meshes.h"
#include "compiler/buildings/planning/doors.h"
#include "compiler/buildings/styles/building_materials.h"
#include "compiler/contract/detail_tolerances.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/contract/texts/utf8.h"
#include "compiler/contract/tolerance.h"
#include "grammars/derivation/context_query.h"
#include "grammars/derivation/form_roofs.h"

namespace citykiln::buildings {
namespace {

using materials::MaterialMesh;

// Returns one line for each of Building::fronts, in the same order, plane metres. The seed, the building and the index
// of the front select one of the fascia colours of its kind (map::FrontValues::colours).
// By day no front is lit.
std::vector<grammars::FrontLine> front_lines(const Building& building, const SceneContext& context) {
  const std::optional<WeekTime>& night = context.night;
  const std::uint64_t seed = context.seed;
  const Ring& ring = building.footprint.outer;
  const RandomSequence colours(seed, stable_id(building.id), "front colour");
  std::vector<grammars::FrontLine> lines;
  for (std::uint32_t i = 0; i < building.fronts.size(); ++i) {
    const Front& front = building.fronts[i];
    const map::FrontValues& values = map::values_of(front.kind);
    const Vec2 from = ring[front.edge], along = unit(ring[(front.edge + 1) % ring.size()] - from);
    lines.push_back({.from = from + along * front.from_m,
                     .to = from + along * front.to_m,
                     .kind = std::string(values.name),
                     .colour = std::string(values.colours[colours.below(map::kFasciaColours, i)]),
                     .is_lit = night && is_front_lit(building, i, *night, seed, context.lit_share)});
  }
  return lines;
}

// At this tolerance a roof has all its planes.
constexpr double kWholeRoof_m = 0.02;

// A tower of a hundred floors with a balcony at every window takes half a million shapes.
constexpr std::uint64_t kMaxShapes = 4'000'000, kMaxSteps = 400'000'000;

// One building at one tolerance.
struct Level {
  const Building& building;
  const grammars::Program* rules;  // null: none
  SceneContext context;
  double tolerance_m;
  const DetailedFacades* detailed;  // null: no facade textures
  std::span<const grammars::RuleFault>
      more_faults;  // of all detail: a level omits faults with the detail that has them
};

void add_mesh(MaterialMesh&& mesh, std::vector<MaterialMesh>& meshes) {
  if (!mesh.mesh.triangles.empty()) meshes.push_back(std::move(mesh));
}

MaterialMesh wall_mesh(const Level& level) {
  const Building& building = level.building;
  return {{}, building.wall, wall_tint(building, level.context.seed), building.id.osm};
}

// Roof planes and eaves; gables have the wall's material.
void add_roof(const Building& building, const roofs::Roof& roof, Mesh& wall, Mesh& top) {
  for (Mesh* mesh : {&wall, &top}) {
    const auto first = static_cast<std::uint32_t>(mesh->positions.size());
    for (const Vec3 p : roof.positions) mesh->positions.push_back({p.x, p.y, p.z + eaves_m(building)});
    for (std::size_t i = 0; i < roof.triangles.size(); ++i) {
      const auto [a, b, c] = roof.triangles[i];
      const bool is_wall = roof.parts[i] == roofs::RoofPart::kGable;
      if (is_wall == (mesh == &wall)) mesh->triangles.push_back({first + a, first + b, first + c});
    }
  }
}

void add_mass_model(const Level& level, const MassModel& mass, std::vector<MaterialMesh>& meshes) {
  const Building& building = level.building;
  MaterialMesh wall = wall_mesh(level);
  MaterialMesh top{{}, building.roof, roof_tint(building, level.context.seed), building.id.osm};
  for (const grammars::Face& face : mass.walls) add_face(face, wall.mesh);
  add_roof(building, mass.roof, wall.mesh, top.mesh);
  add_mesh(std::move(wall), meshes);
  add_mesh(std::move(top), meshes);
}

// Rules choose the colour of walls, so under them the foundation is stone.
void add_foundation(const Level& level, const MassModel& mass, std::vector<MaterialMesh>& meshes) {
  MaterialMesh mesh = wall_mesh(level);
  if (level.rules) mesh.material = materials::Material::kStone, mesh.tint = materials::kNoTint;
  for (const grammars::Face& face : mass.foundation) add_face(face, mesh);
  add_mesh(std::move(mesh), meshes);
}

void add_posts(const Level& level, std::vector<MaterialMesh>& meshes) {
  MaterialMesh mesh = wall_mesh(level);
  if (level.rules) mesh.material = materials::Material::kConcrete, mesh.tint = materials::kNoTint;
  for (const grammars::Face& face : post_faces(level.building)) add_face(face, mesh);
  add_mesh(std::move(mesh), meshes);
}

// Reports each fault of the rules, with its file, line and rule.
void report_rule_faults(const Level& level, const grammars::Derivation& derivation, Report& report) {
  std::vector<grammars::RuleFault> faults = grammars::rule_faults(*level.rules, derivation);
  for (const grammars::RuleFault& more : level.more_faults)
    if (std::ranges::find(faults, more.text, &grammars::RuleFault::text) == faults.end()) faults.push_back(more);
  for (grammars::RuleFault& fault : faults)
    report.add({.code = Code::kRuleErrors,
                .object = level.building.id.osm,
                .size = static_cast<double>(fault.times),
                .tag = std::move(fault.text)});
}

// The number of shapes with results of operations that no mesh shows: models, textures and their coordinates.
std::size_t count_without_effect(const grammars::Derivation& derivation) {
  const auto is_left_out = [&](const grammars::Terminal& terminal) {
    return !terminal.asset.empty() || terminal.texture ||
           !derivation.appearances[terminal.appearance].colour_map.empty();
  };
  return static_cast<std::size_t>(std::ranges::count_if(derivation.terminals, is_left_out));
}

// The answers to queries about the surroundings of a shape: entrances and lit rooms.
grammars::AnswerContextQuery surroundings_of(const Level& level, std::vector<Vec2> doors) {
  grammars::AnswerContextQuery entrances, lit;
  if (!doors.empty()) entrances = grammars::answer_from_entrances(std::move(doors));
  if (level.context.night)
    lit = lit_windows(level.building, *level.context.night, level.context.seed, level.context.lit_share);
  if (!lit) return entrances;
  return [entrances = std::move(entrances), lit = std::move(lit)](grammars::ContextQuery query,
                                                                  const grammars::Shape& shape) {
    if (query == grammars::ContextQuery::kIsLit) return lit(query, shape);
    return entrances && entrances(query, shape);
  };
}

grammars::DeriveOptions options_of(const Level& level, const MassModel& mass, double tolerance_m) {
  grammars::DeriveOptions options;
  options.attributes = rule_attributes_of(level.building, mass.roof.form);
  const std::optional<WeekTime>& night = level.context.night;
  options.attributes["night"] = night.has_value();
  options.attributes["shop_lit"] =
      night && is_shop_lit(level.building, *night, level.context.seed, level.context.lit_share);
  std::vector<Vec2> doors = door_positions(level.building);
  options.attributes["entrances"] = static_cast<double>(doors.size());
  options.attributes["fronts"] = static_cast<double>(level.building.fronts.size());
  options.answer_context_query = surroundings_of(level, std::move(doors));
  if (!level.building.fronts.empty())
    options.find_front = grammars::find_among_fronts(front_lines(level.building, level.context));
  options.seed = level.context.seed;
  options.tolerance_m = tolerance_m;
  options.keep_start = true, options.ids = false;
  // facade textures show what a level omits; without them the faces it keeps have to have its mean colours
  options.keep_appearances = level.detailed == nullptr, options.prune_early = true;
  options.draw_elements =
      level.context.pictures && !level.context.is_for_blocks && has_detail(Detail::kFacadeElements, level.tolerance_m);
  // roofs made by rules have all planes at every tolerance: the derivation certifies what it omits of them
  options.roofs = grammars::form_roofs(kQuantum_m);
  options.limits.shapes = kMaxShapes, options.limits.steps = kMaxSteps;
  return options;
}

grammars::Derivation derive(const Level& level, const MassModel& mass, double tolerance_m) {
  return grammars::derive(*level.rules, shape_of(level.building, mass), options_of(level, mass, tolerance_m));
}

// Half of the tolerance is the roof's. Rules read the roof's form and build on its planes, so with rules the roof is
// never simplified to a flat one.
double roof_tolerance_m(const Level& level, double tolerance_m) {
  const double rise_m = level.building.roof_shape.height_m;
  return level.rules && rise_m > 0 ? std::min(tolerance_m / 2, rise_m * 0.99) : tolerance_m / 2;
}

MassModel mass_model(const Level& level, double tolerance_m, Report& report) {
  return mass_model_of(level.building, roof_tolerance_m(level, tolerance_m), report);
}

// A mass model that rules are applied to, and a bound of what they omit on its roof.
struct RuledMass {
  MassModel mass;
  double omitted_m = 0;
};

// On a simplified roof rules may find no room for a chimney, and the derivation cannot count it as omitted. The error
// is therefore taken from a derivation on the whole roof. If that and the roof's own error exceed the tolerance, the
// roof stays whole.
RuledMass ruled_mass(const Level& level, Report& report) {
  RuledMass simplified{mass_model(level, level.tolerance_m, report)};
  if (!level.rules || simplified.mass.roof.error_m == 0) return simplified;
  Report repeated;
  RuledMass whole{mass_model(level, kWholeRoof_m, repeated)};
  simplified.omitted_m = derive(level, whole.mass, level.tolerance_m).error_m;
  return simplified.omitted_m + simplified.mass.roof.error_m > level.tolerance_m ? whole : simplified;
}

// The model that facade textures are rendered from.
DetailedFacades detailed_model(Level level, NeededModels needed) {
  level.tolerance_m = kDetailedModel_m, level.detailed = nullptr;
  Report repeated;
  const MassModel mass = mass_model(level, kDetailedModel_m, repeated);
  return detailed_facades(derive(level, mass, kDetailedModel_m - mass.roof.error_m), level.context.pictures, needed,
                          level.building.id.osm);
}

// The models that facade textures of some levels are rendered from.
NeededModels models_for(std::span<const double> tolerances_m) {
  NeededModels needed{};
  for (const double tolerance_m : tolerances_m)
    if (has_detail(Detail::kFacadeTextures, tolerance_m))
      (has_detail(Detail::kFacadeRows, tolerance_m) ? needed.walls : needed.whole) = true;
  return needed;
}

void add_ruled(const Level& level, const RuledMass& ruled, GeneratedBuilding& generated, Report& report) {
  const OsmId feature = level.building.id.osm;
  // rules may use what the roof leaves of the tolerance
  const double tolerance_m = level.tolerance_m - ruled.mass.roof.error_m;
  const grammars::Derivation derivation = derive(level, ruled.mass, tolerance_m);
  report_rule_faults(level, derivation, report);
  if (const std::size_t shapes = count_without_effect(derivation); shapes > 0)
    report.add({.code = Code::kRuleWithoutEffect,
                .object = feature,
                .size = static_cast<double>(shapes),
                .tag = to_valid_utf8(level.rules->files.front())});
  FacadeMeshes faces;
  if (level.detailed)
    faces = texture_facades(derivation, *level.detailed, level.tolerance_m, tolerance_m, feature);
  else
    faces.meshes = terminal_meshes(derivation, feature, level.tolerance_m);
  if (!derivation.elements.empty()) add_elements(derivation, *level.context.pictures, feature, faces);
  generated.error_m += std::max({derivation.error_m, ruled.omitted_m, faces.error_m});
  for (MaterialMesh& mesh : faces.meshes) generated.meshes.push_back(std::move(mesh));
  generated.textured_faces = std::move(faces.textured_faces);
}

// Drops a building on the ground that, roof structures included, is lower than the tolerance: the ground is that near.
// Slabs above the ground stay: several of them, each thin, may carry a tower.
GeneratedBuilding drop_if_low(const Level& level, GeneratedBuilding generated) {
  const Building& building = level.building;
  if (!building.stands_on_ground && building.posts.empty()) return generated;
  const double foot_m = building.posts.empty() ? building.bottom_m : building.post_foot_m;
  if (level.context.is_for_blocks || building.top_m - foot_m >= level.tolerance_m) return generated;
  double top_m = building.top_m;
  for (const MaterialMesh& mesh : generated.meshes)
    for (const Vec3 p : mesh.mesh.positions) top_m = std::max(top_m, p.z);
  for (const TexturedFace& face : generated.textured_faces)
    for (const Vec3 p : face.mesh.mesh.positions) top_m = std::max(top_m, p.z);
  const double error_m = top_m - foot_m + generated.error_m;
  return error_m < level.tolerance_m ? GeneratedBuilding{{}, error_m} : std::move(generated);
}

// Returns the faults of user-defined rules at full detail. Shipped rules have none, as tests show.
std::vector<grammars::RuleFault> faults_of_own_rules(const Level& level) {
  if (level.rules == nullptr || level.rules->is_shipped || level.context.is_for_blocks) return {};
  Report repeated;
  const MassModel mass = mass_model(level, kWholeRoof_m, repeated);
  grammars::DeriveOptions options = options_of(level, mass, 0);
  options.prune_early = false, options.limits = {};
  grammars::Derivation derivation = grammars::derive(*level.rules, shape_of(level.building, mass), options);
  // levels may take more shapes and steps than this test
  std::erase_if(derivation.limits,
                [](const grammars::LimitHit& hit) { return hit.kind != grammars::LimitKind::kDepth; });
  return grammars::rule_faults(*level.rules, derivation);
}

GeneratedBuilding generate_level(const Level& level, Report& report) {
  const RuledMass ruled = ruled_mass(level, report);
  GeneratedBuilding generated{{}, ruled.mass.roof.error_m};
  add_foundation(level, ruled.mass, generated.meshes);
  add_posts(level, generated.meshes);
  if (level.rules)
    add_ruled(level, ruled, generated, report);
  else
    add_mass_model(level, ruled.mass, generated.meshes);
  cut_passageways(level.building, wall_mesh(level), generated);
  return drop_if_low(level, std::move(generated));
}

}  // namespace

GeneratedBuilding generate(const Building& building, const Rulebook& rulebook, SceneContext context, double tolerance_m,
                           Report& report) {
  return std::move(generate(building, rulebook, context, std::span(&tolerance_m, 1), std::span(&report, 1)).front());
}

std::vector<GeneratedBuilding> generate(const Building& building, const Rulebook& rulebook, SceneContext context,
                                        std::span<const double> tolerances_m, std::span<Report> reports) {
  assert(reports.size() == tolerances_m.size());
  const auto found = rulebook.find(building.style);
  Level level{building, found != rulebook.end() ? &found->second : nullptr, context, 0, nullptr, {}};
  const std::vector<grammars::RuleFault> faults = faults_of_own_rules(level);
  level.more_faults = faults;
  std::optional<DetailedFacades> detailed;
  std::vector<GeneratedBuilding> levels;
  for (std::size_t i = 0; i < tolerances_m.size(); ++i) {
    assert(tolerances_m[i] > 0);
    const bool has_textures =
        level.rules && !context.is_for_blocks && has_detail(Detail::kFacadeTextures, tolerances_m[i]);
    if (has_textures && !detailed) detailed = detailed_model(level, models_for(tolerances_m));
    level.tolerance_m = tolerances_m[i], level.detailed = has_textures ? &*detailed : nullptr;
    levels.push_back(generate_level(level, reports[i]));
  }
  return levels;
}

}  // namespace citykiln::buildings
