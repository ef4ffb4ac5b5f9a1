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

void add(MemoKey& key, Vec3 v) { key.add(whole(v.x)), key.add(whole(v.y)), key.add(whole(v.z)); }

void add(MemoKey& key, const Value& value) {
  key.add(static_cast<std::int64_t>(value.index()));
  const std::string* text = std::get_if<std::string>(&value);
  if (text == nullptr) return key.add(whole(number_of(value)));
  key.add(static_cast<std::int64_t>(text->size()));
  for (const char c : *text) key.add(c);
}

void add_face(MemoKey& key, const Face& face, const Scope& scope) {
  key.add(static_cast<std::int64_t>(face.outer.size() << 32 | face.street_edges.size()));
  key.add(static_cast<std::int64_t>(face.tag) << 1 | face.street);
  for (const Vec3 p : face.outer) {
    const Vec3 v = p - scope.origin;
    add(key, Vec3{dot(scope.axis[0], v), dot(scope.axis[1], v), dot(scope.axis[2], v)});
  }
  for (const std::uint8_t street : face.street_edges) key.add(street);
}

void add_inherited(MemoKey& key, const Shape& shape) {
  const bool same = shape.projection == shape.texture;
  key.add(std::int64_t{shape.look} << 32 | shape.attributes);
  key.add((shape.projection == 0) << 2 | (shape.texture == 0) << 1 | same);
}

// up as the scope sees it: a motion may turn the shape about the vertical alone
MemoKey key_of(const Execution& execution, const Body& body) {
  const Shape& shape = execution.shape;
  const Scope& scope = shape.scope;
  MemoKey key;
  key.add(std::int64_t{body.number} << 32 | execution.path);
  key.add(execution.depth);
  add_face(key, shape.faces.front(), scope);
  add(key, Vec3{scope.size_m[0], scope.size_m[1], scope.size_m[2]});
  add(key, Vec3{scope.axis[0].z, scope.axis[1].z, scope.axis[2].z});
  add_inherited(key, shape);
  for (const Value& value : execution.frame) add(key, value);
  return key;
}

// a face without area has axes without length
bool is_frame(const Scope& scope) {
  constexpr double kNearly = 1e-9;
  const auto& [x, y, z] = scope.axis;
  const auto is_unit = [](Vec3 v) { return std::abs(dot(v, v) - 1) < kNearly; };
  return length(cross(x, y) - z) < kNearly && is_unit(x) && is_unit(y) && std::abs(dot(x, y)) < kNearly;
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

/// Those of one kind: the one that this shape's dice will make again, or where the next of them goes.
struct Kind {
  MemoEntry* known = nullptr;
  MemoEntry** end = nullptr;
  bool closed = false;  ///< One of them is under way or no pattern, or there are too many.
};

Kind kind_of(Run& run, const Shape& shape, MemoEntry*& first) {
  Kind kind{nullptr, &first};
  Dicing dicing{run, shape.birth};
  std::size_t count = 0;
  for (; *kind.end != nullptr && !kind.closed; kind.end = &(*kind.end)->next, ++count) {
    MemoEntry& entry = **kind.end;
    kind.closed = !entry.ready || count + 1 >= kMostVariants;
    if (entry.ready && kind.known == nullptr && dicing.would_fall_as(entry.pattern)) kind.known = &entry;
  }
  return kind;
}

Recording first_of_its_kind(Execution& execution, MemoEntry& entry) {
  Run& run = execution.run;
  entry.pattern.stand = stand_of(execution.shape);
  run.memo.open.push_back({execution.shape.birth, true});
  return {&entry, false, ends_of(run)};
}

}  // namespace

void MemoKey::add(std::int64_t word) {
  const auto w = static_cast<std::uint64_t>(word);
  a = (a ^ w) * 0x9e3779b97f4a7c15u, a ^= a >> 32;
  b = (b ^ w) * 0xd6e8feb86659fd93u, b ^= b >> 29;
}

Recording begin_recording(Execution& execution, const Body& body) {
  Run& run = execution.run;
  BodyRecord& record = run.memo.bodies[body.number];
  if (!run.options.copies || record.never || only_names(body) || !may_repeat(execution.shape)) return {};
  const Kind kind = kind_of(run, execution.shape, run.memo.first_of[key_of(execution, body)]);
  if (kind.known == nullptr) {
    if (kind.closed) return {};
    ++record.misses;
    *kind.end = &run.memo.entries.emplace_back();
    return first_of_its_kind(execution, **kind.end);
  }
  if (!fits_limits(run, kind.known->pattern.made)) return {};
  ++record.hits;
  return {kind.known, true, {}};
}

NodeTrace repeat(Execution& execution, const MemoEntry& entry) {
  Run& run = execution.run;
  const Made& made = entry.pattern.made;
  copy_pattern(run, entry.pattern, execution.shape);
  run.out.shapes += made.shapes;
  run.out.copied += made.shapes;
  run.out.steps += made.steps;
  NodeTrace trace = made.trace;
  // both the shape and its like are as large as the other but for kSame_m, at each of their ends
  if (!trace.vanished) trace.moved = trace.moved + Displacement{4 * kSame_m, 4 * kSame_m};
  return trace;
}

void end_recording(Run& run, const Body& body, const Recording& recording, NodeTrace trace) {
  if (recording.entry == nullptr) return;
  Memo& memo = run.memo;
  BodyRecord& record = memo.bodies[body.number];
  MemoEntry& entry = *recording.entry;
  const Made& made = entry.pattern.made = between(recording.before, ends_of(run), trace);
  const bool is_small = made.shapes <= kFewShapes;
  entry.ready = memo.open.back().repeats && made.throws.size() <= kMostThrows;
  memo.open.pop_back();
  record.small_ones += is_small;
  record.never |= is_small && body.kind == BodyKind::kStatements;
  record.never |= !entry.ready || record.small_ones >= kManyTimes || (record.misses >= kManyMisses && record.hits == 0);
  if (entry.ready) memo.seen.push_back(&entry);
}

void cut_away_from(Run& run, std::size_t first) {
  Memo& memo = run.memo;
  std::vector<Terminal>& terminals = run.out.terminals;
  const auto is_in = [&](const MemoEntry& entry) { return entry.pattern.made.terminals.end > first; };
  if (!memo.seen.empty() && is_in(*memo.seen.back())) {
    const auto from = static_cast<std::ptrdiff_t>(first);
    memo.cut_away.push_back(
        {first,
         {std::make_move_iterator(terminals.begin() + from), std::make_move_iterator(terminals.end())},
         {run.notes.begin() + from, run.notes.end()}});
  }
  for (; !memo.seen.empty() && is_in(*memo.seen.back()); memo.seen.pop_back())
    memo.seen.back()->pattern.cut_away = static_cast<std::uint32_t>(memo.cut_away.size());
  terminals.resize(first);
  run.notes.resize(first);
}

}  // namespace citykiln::grammars
