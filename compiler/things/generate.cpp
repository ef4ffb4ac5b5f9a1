#include "compiler/things/generate.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "compiler/buildings/meshes/terminal_meshes.h"
#include "compiler/contract/texts/hex_colour.h"
#include "compiler/geometry/snap.h"
#include "compiler/things/facing.h"
#include "grammars/derivation/derive.h"
#include "grammars/derivation/form_roofs.h"

namespace citykiln::things {
namespace {

constexpr std::uint64_t kMostThingShapes = 200'000, kMostThingSteps = 20'000'000;

// The id from which a variant's random numbers follow; no element of a map has it.
StableId id_of_variant(const Form& form) { return stable_id(stable_id(ObjectId{}), "thing", form.variant); }

std::map<std::string, grammars::Value> attributes_of(const Form& form, bool is_night) {
  return {{"width", form.width_m},
          {"depth", form.depth_m},
          {"height", form.height_m},
          {"kind", form.value},
          {"colour", hex_colour(form.colour)},
          {"material", form.material},
          {"text", form.text},
          {"capacity", static_cast<double>(form.capacity)},
          {"country", std::string(map::name_of(form.country))},
          {"variant", static_cast<double>(form.variant)},
          {"night", is_night}};
}

// The box of a form as the first shape of a derivation.
grammars::Shape box_of_form(const Form& form) {
  const double w = form.width_m / 2, d = form.depth_m / 2, h = form.height_m;
  const auto corner = [&](int i) { return Vec3{i & 1 ? w : -w, i & 2 ? d : -d, i & 4 ? h : 0}; };
  constexpr std::array<std::array<int, 4>, 6> kFaces = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  grammars::Shape shape;
  shape.id = id_of_variant(form);
  for (const std::array<int, 4>& corners : kFaces) {
    grammars::Face& face = shape.faces.emplace_back();
    for (const int i : corners) face.outer.push_back(corner(i));
  }
  shape.scope = {.origin = corner(0),
                 .axis = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}},
                 .size_m = {form.width_m, form.depth_m, form.height_m}};
  shape.parent_scope = shape.scope;
  return shape;
}

grammars::DeriveOptions options_of(const Form& form, std::uint64_t seed, bool is_night, double tolerance_m) {
  grammars::DeriveOptions options;
  options.start = "Thing";
  options.attributes = attributes_of(form, is_night);
  options.seed = seed;
  options.tolerance_m = tolerance_m;
  options.keep_appearances = true, options.ids = false, options.prune_early = true;
  options.roofs = grammars::form_roofs(kQuantum_m);
  options.limits.shapes = kMostThingShapes, options.limits.steps = kMostThingSteps;
  return options;
}

// Terminals on which wires hang, at the upper or the lower end of their scope.
struct HoldName {
  std::string_view terminal;
  WireKind kind;
  bool is_above;
};
constexpr HoldName kHoldNames[] = {{"WireBelow", WireKind::kConductor, false},
                                   {"WireAbove", WireKind::kConductor, true},
                                   {"EarthWireAbove", WireKind::kEarthWire, true},
                                   {"CableAbove", WireKind::kCable, true}};

Vec3 middle_of_end(const grammars::Scope& scope, bool is_above) {
  return scope.to_space(scope.size_m[0] / 2, scope.size_m[1] / 2, is_above ? scope.size_m[2] : 0);
}

}  // namespace

std::vector<WireHold> wire_holds(const Form& form, const Kind& kind, std::uint64_t seed) {
  grammars::DeriveOptions options = options_of(form, seed, false, 0);
  options.prune_early = false;
  std::vector<WireHold> holds;
  for (const grammars::Terminal& terminal : grammars::derive(kind.rules, box_of_form(form), options).terminals)
    for (const HoldName& name : kHoldNames)
      if (terminal.name == name.terminal) holds.push_back({name.kind, middle_of_end(terminal.scope, name.is_above)});
  return holds;
}

bool is_shown(const Form& form, const map::ThingRow& row, double tolerance_m) {
  return tolerance_m < std::max(form.height_m, row.detail_m.value_or(0));
}

namespace {

// Returns the faults of rules; those of user-defined rules at full detail, which a level may omit.
std::vector<grammars::RuleFault> faults_of(const Form& form, const Kind& kind, std::uint64_t seed,
                                           const grammars::Derivation& derivation) {
  if (kind.rules.is_shipped) return grammars::rule_faults(kind.rules, derivation);
  grammars::DeriveOptions options = options_of(form, seed, false, 0);
  options.prune_early = false;
  return grammars::rule_faults(kind.rules, grammars::derive(kind.rules, box_of_form(form), options));
}

}  // namespace

GeneratedThing generate(const Form& form, const Kind& kind, std::uint64_t seed, bool is_night, double tolerance_m) {
  assert(tolerance_m > 0);
  if (!is_shown(form, kind.row, tolerance_m)) return {{}, form.height_m};
  const grammars::Derivation derivation =
      grammars::derive(kind.rules, box_of_form(form), options_of(form, seed, is_night, tolerance_m));
  return {buildings::terminal_meshes(derivation, {}, tolerance_m), derivation.error_m,
          faults_of(form, kind, seed, derivation)};
}

Placement place(const Thing& thing, const ground::GradedTerrain& ground) {
  const Vec2 facing = unit_vector(thing.direction), right{-facing.y, facing.x};
  double z_m = land_m(ground, thing.at);
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      z_m = std::min(z_m,
                     land_m(ground, thing.at + right * (x * thing.form.width_m) + facing * (y * thing.form.depth_m)));
  if (thing.foot_m) z_m = *thing.foot_m;
  // the mesh faces -y
  return {.at = at_height(thing.at, snapped(z_m)), .cos_yaw = right.x, .sin_yaw = right.y, .feature = thing.id.osm};
}

}  // namespace citykiln::things
