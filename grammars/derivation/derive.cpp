#include "grammars/derivation/derive.h"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "compiler/contract/texts/utf8.h"
#include "grammars/derivation/execute.h"
#include "grammars/language/lexer.h"

namespace citykiln::grammars {
namespace {

constexpr std::size_t kMostWarnings = 1000;  // of different texts: a mistake in a loop can produce a million

auto order_of(const Warning& warning) {
  return std::tuple(warning.position.file, warning.position.line, warning.position.column);
}

Shape first_shape(Run& run) {
  Shape shape = run.initial;
  // with an id other than the building's, which attributes draw from
  run.nodes.push_back({0, "start", 0});
  shape.in_split.since_node = shape.in_comp.since_node = 0;
  return shape;
}

// Reserves the usual size of a house.
void reserve_tables(Run& run) {
  constexpr std::size_t kTerminals = 256, kShapes = 1024;
  run.out.terminals.reserve(kTerminals), run.origins.reserve(kTerminals);
  run.nodes.reserve(kShapes);
  run.memo.entries.reserve(kTerminals);
  run.tables.textures.reserve(kTerminals);
}

NodeTrace begin(Run& run) {
  const std::string& start = run.options.start.empty() ? run.program.start : run.options.start;
  const auto rule = run.program.rule_of.find(start);
  if (rule == run.program.rule_of.end()) return end_as_terminal(run, first_shape(run), start, 0);
  const Rule& first = run.program.rules[rule->second];
  // parameters of a start rule are zero
  return apply_rule(run, first_shape(run), first, Slots(first.parameters.size(), Value(0.0)), 1, 0);
}

void set_ids(Run& run) {
  for (std::size_t i = 0; i < run.origins.size(); ++i) run.out.terminals[i].id = run.id_of(run.origins[i].node);
  for (std::size_t i = 0; i < run.report_nodes.size(); ++i) run.out.reports[i].shape = run.id_of(run.report_nodes[i]);
}

void collect_warnings(Run& run) {
  for (auto& [key, warning] : run.warnings) run.out.warnings.push_back(std::move(warning));
  std::ranges::stable_sort(run.out.warnings, {}, order_of);
}

// The definition that holds a position: ", rule Building", ", attr height" or ", function rise"; "" for none.
std::string definition_at(const Program& program, TextPosition position) {
  std::string found;
  std::uint32_t line = 0;
  const auto look_in = [&](const auto& definitions, const char* kind) {
    for (const auto& one : definitions) {
      if (one.position.file != position.file || one.position.line > position.line || one.position.line < line) continue;
      line = one.position.line, found = std::string(", ") + kind + " " + one.name;
    }
  };
  look_in(program.attributes, "attr"), look_in(program.functions, "function"), look_in(program.rules, "rule");
  return found;
}

std::string place_in(const Program& program, TextPosition position) {
  return to_valid_utf8(position_text(program.files[position.file], position)) + definition_at(program, position);
}

constexpr const char* kLimitNames[] = {"depth", "shapes", "steps"};

std::string fault_of(const LimitHit& hit) {
  const std::string text =
      std::string("the limit of ") + kLimitNames[static_cast<std::size_t>(hit.kind)] + " is reached";
  return hit.kind == LimitKind::kDepth ? text + "; the rule calls itself without end" : text;
}

}  // namespace

StableId Run::id_of(std::uint32_t node) {
  if (ids.size() < nodes.size()) ids.resize(nodes.size());
  if (ids[node] != StableId{}) return ids[node];
  const DerivationNode& child = nodes[node];
  const StableId parent = node == 0 ? initial.id : id_of(child.parent);
  return ids[node] = stable_id(parent, child.name, child.ordinal);
}

void Run::depends_on(std::uint32_t since_node) {
  for (std::size_t i = memo.open.size(); i-- > 0 && memo.open[i].node >= since_node;)
    memo.open[i].is_repeatable = false;
}

void Run::record_draw(const RandomDraw& draw) {
  if (!memo.open.empty()) draws.push_back(draw);
}

void Run::warn(TextPosition position, const std::string& message) {
  depends_on(0);
  ++warnings_raised;
  const std::string key = position_text(program.files[position.file], position);
  const auto found = warnings.find({key, message});
  if (found != warnings.end()) return void(++found->second.times);
  if (warnings.size() < kMostWarnings) warnings[{key, message}] = {position, message, 1};
}

bool Run::spend(std::uint64_t steps) {
  out.steps += steps;
  return out.steps <= options.limits.steps;
}

void Run::hit(LimitKind kind, const std::string& rule, TextPosition position) {
  depends_on(0);
  depth_hits += kind == LimitKind::kDepth;
  for (LimitHit& hit : out.limits)
    if (hit.kind == kind) return void(++hit.times);
  out.limits.push_back({kind, rule, position, 1});
}

std::uint32_t Run::path(std::uint32_t parent, const std::string& rule) {
  if (!options.ids) return 0;
  for (std::uint32_t i = first_below[parent]; i != 0; i = known_paths[i - 1].next)
    if (known_paths[i - 1].name == &rule) return known_paths[i - 1].path;
  auto path = static_cast<std::uint32_t>(out.paths.size());
  for (std::uint32_t i = first_below[parent]; i != 0; i = known_paths[i - 1].next)
    if (*known_paths[i - 1].name == rule) path = known_paths[i - 1].path;
  known_paths.push_back({&rule, path, first_below[parent]});
  first_below[parent] = static_cast<std::uint32_t>(known_paths.size());
  if (path == out.paths.size()) add_path(parent, rule);
  return path;
}

void Run::add_path(std::uint32_t parent, const std::string& rule) {
  out.paths.push_back({parent, rule});
  first_below.push_back(0);
}

std::uint32_t Run::appearance_index(std::uint32_t appearance) {
  appearances_in_out.resize(tables.appearances.size());
  std::uint32_t& in_out = appearances_in_out[appearance];
  if (in_out == 0) {
    out.appearances.push_back(tables.appearances[appearance]);
    in_out = static_cast<std::uint32_t>(out.appearances.size());
  }
  return in_out - 1;
}

double metres(const Argument& argument) { return std::clamp(number_of(argument.value), -kMost_m, kMost_m); }

Shape lot(const Polygon& footprint, double height_m, std::size_t front, StableId id,
          const std::vector<std::size_t>& street) {
  Shape shape;
  shape.id = id;
  shape.scope.origin = shape.parent_scope.origin = {0, 0, height_m};
  const std::size_t n = footprint.outer.size();
  if (n < 3) return shape;
  Face& face = shape.faces.emplace_back();
  for (const Vec2 p : footprint.outer) face.outer.push_back(at_height(p, height_m));
  for (const Ring& hole : footprint.holes) {
    Ring3& ring = face.holes.emplace_back();
    for (const Vec2 p : hole) ring.push_back(at_height(p, height_m));
  }
  face.street_edges.assign(street.empty() ? 0 : n, 0);
  for (const std::size_t edge : street) face.street_edges[edge % n] = 1;
  const Vec3 along = face.outer[(front + 1) % n] - face.outer[front % n];
  const Vec3 x = length(along) > 0 ? unit(along) : Vec3{1, 0, 0};
  shape.scope = scope_around(shape.faces, {x, Vec3{0, 0, 1}, cross(x, Vec3{0, 0, 1})}, {0, 0, height_m});
  shape.parent_scope = shape.scope;
  return shape;
}

Derivation derive(const Program& program, const Shape& initial, const DeriveOptions& options) {
  assert(options.tolerance_m >= 0);
  Run run{program, options, initial};
  run.attributes.resize(program.attributes.size());
  run.attribute_under_way.resize(program.attributes.size());
  run.constants.resize(program.functions.size());
  run.add_path(0, "");
  run.memo.bodies.resize(program.bodies);
  run.bounds.first_of.resize(program.bodies);
  run.out.shapes = 1;
  reserve_tables(run);
  begin(run);
  collect_warnings(run);
  if (options.ids) set_ids(run);
  for (const Terminal& terminal : run.out.terminals) run.out.error_m = std::max(run.out.error_m, terminal.error_m);
  return std::move(run.out);
}

std::string path_name(const Derivation& derivation, std::uint32_t path) {
  if (path == 0 || path >= derivation.paths.size()) return "";
  const PathNode& node = derivation.paths[path];
  return node.parent == 0 ? node.rule : path_name(derivation, node.parent) + "/" + node.rule;
}

std::string warning_line(const Program& program, const Warning& warning) {
  const std::string line =
      position_text(program.files[warning.position.file], warning.position) + ": " + warning.message;
  return warning.times == 1 ? line : line + " (" + std::to_string(warning.times) + " times)";
}

std::vector<RuleFault> rule_faults(const Program& program, const Derivation& derivation) {
  std::vector<RuleFault> faults;
  for (const LimitHit& hit : derivation.limits)
    faults.push_back({place_in(program, hit.position) + ": " + fault_of(hit), hit.times});
  for (const Warning& warning : derivation.warnings)
    if (faults.size() < kMostRuleFaults)
      faults.push_back({place_in(program, warning.position) + ": " + warning.message, warning.times});
  return faults;
}

std::string limit_line(const Program& program, const LimitHit& hit) {
  return position_text(program.files[hit.position.file], hit.position) + ": the limit of " +
         kLimitNames[static_cast<std::size_t>(hit.kind)] + " ended " + std::to_string(hit.times) +
         " shapes, the first of rule " + hit.rule;
}

}  // namespace citykiln::grammars
