#include "grammars/memo.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "grammars/run.h"

namespace citykiln::grammars {
namespace {

// what is larger costs more to compare than the second of its kind would save
constexpr std::size_t kMostVertices = 12;
// a body that made so few shapes so often is not worth a note, nor one that never met its like
constexpr std::uint64_t kFewShapes = 3;
constexpr std::uint32_t kManyTimes = 8, kManyMisses = 64;
// more dice hardly ever fall alike twice: two panes of a window do, those of a floor do not
constexpr std::size_t kMostThrows = 6, kMostVariants = 24;

std::int64_t whole(double v) {
  const double scaled = v * (1 / kSame_m);
  if (!(std::abs(scaled) < 0x1p62)) return std::bit_cast<std::int64_t>(v);
  return static_cast<std::int64_t>(std::floor(scaled + 0.5));
}

void add(MemoKey& key, Vec3 v) { key.insert(key.end(), {whole(v.x), whole(v.y), whole(v.z)}); }

void add(MemoKey& key, const Value& value) {
  key.push_back(static_cast<std::int64_t>(value.index()));
  const std::string* text = std::get_if<std::string>(&value);
  if (text == nullptr) return key.push_back(whole(number_of(value)));
  key.push_back(static_cast<std::int64_t>(text->size()));
  for (const char c : *text) key.push_back(c);
}

void add_face(MemoKey& key, const Face& face, const Scope& scope) {
  key.insert(key.end(), {static_cast<std::int64_t>(face.outer.size()), static_cast<std::int64_t>(face.tag), face.street,
                         static_cast<std::int64_t>(face.street_edges.size())});
  for (const Vec3 p : face.outer) {
    const Vec3 v = p - scope.origin;
    add(key, Vec3{dot(scope.axis[0], v), dot(scope.axis[1], v), dot(scope.axis[2], v)});
  }
  for (const std::uint8_t street : face.street_edges) key.push_back(street);
}

void add_inherited(MemoKey& key, const Shape& shape) {
  const bool same = shape.projection == shape.texture;
  key.insert(key.end(), {shape.look, shape.attributes, shape.projection == 0, shape.texture == 0, same});
}

// up as the scope sees it: a motion may turn the shape about the vertical alone
void make_key(const Execution& execution, const Body& body, MemoKey& key) {
  const Shape& shape = execution.shape;
  const Scope& scope = shape.scope;
  key.clear();
  key.insert(key.end(), {body.number, execution.path, execution.depth});
  add_face(key, shape.faces.front(), scope);
  add(key, Vec3{scope.size_m[0], scope.size_m[1], scope.size_m[2]});
  add(key, Vec3{scope.axis[0].z, scope.axis[1].z, scope.axis[2].z});
  add_inherited(key, shape);
  for (const Value& value : execution.frame) add(key, value);
}

bool is_frame(const Scope& scope) {
  constexpr double kNearly = 1e-9;
  const auto& [x, y, z] = scope.axis;
  return length(cross(x, y) - z) < kNearly && std::abs(length(x) - 1) < kNearly && std::abs(dot(x, y)) < kNearly;
}

bool may_repeat(const Shape& shape) {
  if (shape.faces.size() != 1 || !shape.asset.empty() || !is_frame(shape.scope)) return false;
  const Face& face = shape.faces.front();
  return face.holes.empty() && face.outer.size() >= 3 && face.outer.size() <= kMostVertices;
}

// a body that only names a successor leaves the note to it
bool only_names(const Body& body) {
  return body.kind == BodyKind::kStatements && body.statements.size() == 1 &&
         body.statements.front().kind == StatementKind::kSuccessor;
}

Made ends_of(const Run& run) {
  Made made;
  made.terminals.first = run.out.terminals.size();
  made.births.first = run.births.size();
  made.reports.first = run.out.reports.size();
  made.textures.first = run.tables.textures.size();
  made.throws.first = run.throws.size();
  made.shapes = run.out.shapes;
  made.steps = run.out.steps - run.attribute_steps;
  return made;
}

Made between(const Made& before, const Made& after, NodeTrace trace) {
  Made made = before;
  made.terminals.end = after.terminals.first;
  made.births.end = after.births.first;
  made.reports.end = after.reports.first;
  made.textures.end = after.textures.first;
  made.throws.end = after.throws.first;
  made.shapes = after.shapes - before.shapes;
  made.steps = after.steps - before.steps;
  made.trace = trace;
  return made;
}

// what the rules would have been stopped at, they have to reach themselves
bool fits_limits(const Run& run, const Made& made) {
  const Limits& limits = run.options.limits;
  return run.out.shapes + made.shapes <= limits.shapes && run.out.steps + made.steps <= limits.steps;
}

bool make_pattern(const Run& run, MemoEntry& entry) {
  std::optional<Pattern> pattern = pattern_of(run, entry.shape, entry.made);
  if (!pattern) return false;
  entry.pattern = std::move(*pattern);
  entry.state = MemoState::kPattern;
  return true;
}

Recording first_of_its_kind(Execution& execution, MemoEntry& entry) {
  Memo& memo = execution.run.memo;
  // one that was lost is made a pattern as soon as it is derived again
  const bool lost = entry.state == MemoState::kLost;
  if (!lost) entry.state = MemoState::kUnderWay;
  entry.shape = execution.shape;
  memo.open.push_back({execution.shape.birth, true});
  return {&entry, false, ends_of(execution.run)};
}

// of those that are derived, whichever's dice fell as this shape's will
MemoEntry* variant_of(Run& run, const Shape& shape, const MemoVariants& variants) {
  for (const std::unique_ptr<MemoEntry>& entry : variants)
    if (would_throw(run, shape.birth, entry->throws)) return entry.get();
  return nullptr;
}

bool any_under_way(const MemoVariants& variants) {
  return std::any_of(variants.begin(), variants.end(),
                     [](const auto& entry) { return entry->state == MemoState::kUnderWay; });
}

}  // namespace

std::size_t MemoKeyHash::operator()(const MemoKey& key) const {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const std::int64_t word : key) hash = (hash ^ static_cast<std::uint64_t>(word)) * 0x9e3779b97f4a7c15u;
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
  return hash ^ (hash >> 31);
}

Recording begin_recording(Execution& execution, const Body& body) {
  Run& run = execution.run;
  BodyRecord& record = run.memo.bodies[body.number];
  if (!run.options.copies || record.never || only_names(body) || !may_repeat(execution.shape)) return {};
  make_key(execution, body, run.memo.asked);
  MemoVariants& variants = run.memo.entries[run.memo.asked];
  if (any_under_way(variants)) return {};
  MemoEntry* known = variant_of(run, execution.shape, variants);
  if (known == nullptr && variants.size() >= kMostVariants) return {};
  const bool is_new = known == nullptr;
  record.misses += is_new;
  MemoEntry& entry = is_new ? *variants.emplace_back(std::make_unique<MemoEntry>()) : *known;
  if (is_new || entry.state == MemoState::kLost) return first_of_its_kind(execution, entry);
  if (!fits_limits(run, entry.made)) return {};
  if (entry.state == MemoState::kSeen && !make_pattern(run, entry)) {
    record.never = true;
    return {};
  }
  ++record.hits;
  return {&entry, true, {}};
}

NodeTrace repeat(Execution& execution, const MemoEntry& entry) {
  Run& run = execution.run;
  copy_pattern(run, entry.pattern, execution.shape);
  run.out.shapes += entry.made.shapes;
  run.out.copied += entry.made.shapes;
  run.out.steps += entry.made.steps;
  NodeTrace trace = entry.made.trace;
  // both the shape and its like are as large as the other but for kSame_m, at each of their ends
  if (!trace.vanished) trace.moved = trace.moved + Displacement{4 * kSame_m, 4 * kSame_m};
  return trace;
}

void end_recording(Run& run, const Body& body, const Recording& recording, NodeTrace trace) {
  if (recording.entry == nullptr) return;
  Memo& memo = run.memo;
  BodyRecord& record = memo.bodies[body.number];
  MemoEntry& entry = *recording.entry;
  const bool lost = entry.state == MemoState::kLost;
  entry.made = between(recording.before, ends_of(run), trace);
  const IndexRange throws = entry.made.throws;
  const bool repeats = memo.open.back().repeats && throws.end - throws.first <= kMostThrows;
  memo.open.pop_back();
  const bool is_small = entry.made.shapes <= kFewShapes;
  record.small_ones += is_small;
  record.never |= is_small && body.kind == BodyKind::kStatements;
  record.never |= !repeats || record.small_ones >= kManyTimes || (record.misses >= kManyMisses && record.hits == 0);
  entry.state = MemoState::kUnderWay;
  if (!repeats) return;
  entry.throws = throws_of(run, entry.shape.birth, throws);
  if (lost) {
    record.never |= !make_pattern(run, entry);
  } else {
    entry.state = MemoState::kSeen;
    memo.seen.push_back(&entry);
  }
}

void forget_terminals(Memo& memo, std::size_t first) {
  while (!memo.seen.empty() && memo.seen.back()->made.terminals.end > first) {
    if (memo.seen.back()->state == MemoState::kSeen) memo.seen.back()->state = MemoState::kLost;
    memo.seen.pop_back();
  }
}

}  // namespace citykiln::grammars
