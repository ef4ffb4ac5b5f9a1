#include "grammars/derivation/derive.h"

#include <algorithm>

#include "grammars/derivation/execute.h"
#include "grammars/language/lexer.h"

namespace citykiln::grammars {
namespace {

constexpr std::size_t kMostTroubles = 1000;  // a mistake in a loop says the same thing a million times in new words

std::tuple<std::uint32_t, std::uint32_t, std::uint32_t> order_of(TextPosition place) {
  return {place.file, place.line, place.column};
}

Shape first_shape(Run& run) {
  Shape shape = run.initial;
  // a birth of its own, so that the start's dice are not the attributes'
  run.nodes.push_back({0, "start", 0});
  shape.in_split.since = shape.in_comp.since = 0;
  return shape;
}

// A house's. What asks for more finds it; what asks for less has taken no memory that is touched.
void make_room(Run& run) {
  constexpr std::size_t kTerminals = 256, kShapes = 1024;
  run.out.terminals.reserve(kTerminals), run.notes.reserve(kTerminals);
  run.nodes.reserve(kShapes);
  run.memo.entries.reserve(kTerminals);
  run.tables.textures.reserve(kTerminals);
}

Outcome begin(Run& run) {
  const std::string& start = run.options.start.empty() ? run.program.start : run.options.start;
  const auto rule = run.program.rule_of.find(start);
  if (rule == run.program.rule_of.end()) return end_as_terminal(run, first_shape(run), start, 0);
  const Rule& first = run.program.rules[rule->second];
  // a start rule asks for nothing that nobody gives; missing arguments are zero
  return apply_rule(run, first_shape(run), first, Frame(first.parameters.size(), Value(0.0)), 1, 0);
}

void tell_ids(Run& run) {
  for (std::size_t i = 0; i < run.notes.size(); ++i) run.out.terminals[i].id = run.id_of(run.notes[i].birth);
  for (std::size_t i = 0; i < run.report_births.size(); ++i) run.out.reports[i].shape = run.id_of(run.report_births[i]);
}

void sort_troubles(Run& run) {
  for (auto& [key, warning] : run.warnings) run.out.warnings.push_back(std::move(warning));
  std::stable_sort(run.out.warnings.begin(), run.out.warnings.end(),
                   [](const Warning& a, const Warning& b) { return order_of(a.place) < order_of(b.place); });
}

}  // namespace

StableId Run::id_of(std::uint32_t birth) {
  if (ids.size() < nodes.size()) ids.resize(nodes.size());
  if (ids[birth] != StableId{}) return ids[birth];
  const DerivationNode& born = nodes[birth];
  const StableId parent = birth == 0 ? initial.id : id_of(born.parent);
  return ids[birth] = stable_id(parent, born.name, born.ordinal);
}

void Run::depends_on(std::uint32_t since) {
  for (std::size_t i = memo.open.size(); i-- > 0 && memo.open[i].birth >= since;) memo.open[i].repeats = false;
}

void Run::record_draw(const RandomDraw& thrown) {
  if (!memo.open.empty()) throws.push_back(thrown);
}

void Run::warning(TextPosition place, const std::string& message) {
  depends_on(0);
  ++troubles_told;
  const std::string key = position_text(program.files[place.file], place);
  const auto found = warnings.find({key, message});
  if (found != warnings.end()) return void(++found->second.times);
  if (warnings.size() < kMostTroubles) warnings[{key, message}] = {place, message, 1};
}

bool Run::spend(std::uint64_t steps) {
  out.steps += steps;
  return out.steps <= options.limits.steps;
}

void Run::hit(LimitKind kind, const std::string& rule, TextPosition place) {
  depends_on(0);
  for (LimitHit& hit : out.limits)
    if (hit.kind == kind) return void(++hit.times);
  out.limits.push_back({kind, rule, place, 1});
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

std::uint32_t Run::appearance_index(std::uint32_t look) {
  looks_in_out.resize(tables.looks.size());
  std::uint32_t& in_out = looks_in_out[look];
  if (in_out == 0) {
    out.looks.push_back(tables.looks[look]);
    in_out = static_cast<std::uint32_t>(out.looks.size());
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
  Run run{program, options, initial};
  run.attributes.resize(program.attributes.size());
  run.attribute_under_way.resize(program.attributes.size());
  run.constants.resize(program.functions.size());
  run.add_path(0, "");
  run.memo.bodies.resize(program.bodies);
  run.reaches.first_of.resize(program.bodies);
  run.out.shapes = 1;
  make_room(run);
  begin(run);
  sort_troubles(run);
  if (options.ids) tell_ids(run);
  for (const Terminal& terminal : run.out.terminals) run.out.error_m = std::max(run.out.error_m, terminal.error_m);
  return std::move(run.out);
}

std::string path_name(const Derivation& derivation, std::uint32_t path) {
  if (path == 0 || path >= derivation.paths.size()) return "";
  const PathNode& node = derivation.paths[path];
  return node.parent == 0 ? node.rule : path_name(derivation, node.parent) + "/" + node.rule;
}

std::string warning_line(const Program& program, const Warning& warning) {
  const std::string line = position_text(program.files[warning.place.file], warning.place) + ": " + warning.message;
  return warning.times == 1 ? line : line + " (" + std::to_string(warning.times) + " times)";
}

std::string limit_line(const Program& program, const LimitHit& hit) {
  constexpr const char* kNames[] = {"depth", "shapes", "steps"};
  return position_text(program.files[hit.place.file], hit.place) + ": the limit of " +
         kNames[static_cast<std::size_t>(hit.kind)] + " ended " + std::to_string(hit.times) +
         " shapes, the first of rule " + hit.rule;
}

}  // namespace citykiln::grammars
