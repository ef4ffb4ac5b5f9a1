#include "grammars/derivation/memo.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "grammars/derivation/execution.h"

namespace citykiln::grammars {
namespace {

// The key of a larger face costs more than a copy would save.
constexpr std::size_t kMostVertices = 12;
// A body stops being recorded after so many results of at most kFewShapes shapes, or so many misses without a hit.
constexpr std::uint64_t kFewShapes = 3;
constexpr std::uint32_t kManyTimes = 8, kManyMisses = 64;
// More draws rarely agree twice: those of the two panes of a window do, those of a floor do not.
constexpr std::size_t kMostDraws = 6, kMostVariants = 24;

std::int64_t whole(double v) {
  const double scaled = v * (1 / kSame_m);
  if (!(std::abs(scaled) < 0x1p62)) return std::bit_cast<std::int64_t>(v);
  return static_cast<std::int64_t>(scaled + (scaled < 0 ? -0.5 : 0.5));
}

void add(MemoKey& key, Vec3 v) { key.add(whole(v.x), whole(v.y), whole(v.z)); }

void add(MemoKey& key, const Value& value) {
  key.add(static_cast<std::int64_t>(value.index()));
  const std::string* text = std::get_if<std::string>(&value);
  if (text == nullptr) return key.add(whole(number_of(value)));
  key.add(static_cast<std::int64_t>(text->size()));
  for (const char c : *text) key.add(c);
}

void add_street(MemoKey& key, const Face& face) {
  key.add(static_cast<std::int64_t>(face.street_edges.size() << 1 | face.street));
  for (const std::uint8_t street : face.street_edges) key.add(street);
}

void add_face(MemoKey& key, const Face& face, const Scope& scope) {
  key.add(static_cast<std::int64_t>(face.outer.size() << 8) | static_cast<std::int64_t>(face.tag));
  for (const Vec3 p : face.outer) {
    const Vec3 v = p - scope.origin;
    add(key, Vec3{dot(scope.axis[0], v), dot(scope.axis[1], v), dot(scope.axis[2], v)});
  }
}

void add_inherited(MemoKey& key, const Shape& shape) {
  const bool same = shape.projection == shape.texture;
  key.add(std::int64_t{shape.appearance} << 32 | shape.attributes);
  key.add((shape.projection == 0) << 2 | (shape.texture == 0) << 1 | same);
}

// The vertical in coordinates of the scope is part of the key, so motions are translations and turns about the
// vertical.
MemoKey memo_key(const Execution& execution, const Body& body) {
  const Shape& shape = execution.shape;
  const Scope& scope = shape.scope;
  MemoKey key;
  key.add(std::int64_t{body.number} << 32 | execution.path);
  // the start node, which keep_start excepts from simplification
  key.add((execution.run.is_in_element << 1) | (execution.depth <= 1));
  add_face(key, shape.faces.front(), scope);
  if (body.depends_on_street) add_street(key, shape.faces.front());
  add(key, Vec3{scope.size_m[0], scope.size_m[1], scope.size_m[2]});
  add(key, Vec3{scope.axis[0].z, scope.axis[1].z, scope.axis[2].z});
  key.add(whole(shape.deviation_m), shape.leaves_out_details, 0);
  add_inherited(key, shape);
  for (const Value& value : execution.slots) add(key, value);
  return key;
}

// False for a face without area, whose axes have no length.
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

// A body that only names a successor, or one of several: the successor is recorded instead.
bool only_names(const Body& body) {
  if (body.kind != BodyKind::kStatements)
    return std::ranges::all_of(body.branches, [](const Branch& branch) { return only_names(branch.body); });
  return body.statements.size() == 1 && body.statements.front().kind == StatementKind::kSuccessor;
}

SubtreeRows ends_of(const Run& run) {
  SubtreeRows made;
  made.terminals.first = run.out.terminals.size();
  made.nodes.first = run.nodes.size();
  made.reports.first = run.out.reports.size();
  made.textures.first = run.tables.textures.size();
  made.draws.first = run.draws.size();
  made.shapes = run.out.shapes;
  made.steps = run.out.steps - run.attribute_steps;
  return made;
}

SubtreeRows between(const SubtreeRows& before, const SubtreeRows& after, NodeTrace trace) {
  SubtreeRows made = before;
  made.terminals.end = after.terminals.first;
  made.nodes.end = after.nodes.first;
  made.reports.end = after.reports.first;
  made.textures.end = after.textures.first;
  made.draws.end = after.draws.first;
  made.shapes = after.shapes - before.shapes;
  made.steps = after.steps - before.steps;
  made.trace = trace;
  return made;
}

// A copy must not pass a limit that would have ended its derivation.
bool fits_limits(const Run& run, int depth, const SubtreeRows& made) {
  const Limits& limits = run.options.limits;
  return depth + made.nested_rules <= limits.depth && run.out.shapes + made.shapes <= limits.shapes &&
         run.out.steps + made.steps <= limits.steps;
}

/// The entries with one key: the one whose draws match those of a shape, and where the next one is linked.
struct Candidates {
  std::uint32_t known = 0;       ///< 1 + index into Memo::entries; 0 for none.
  std::uint32_t* end = nullptr;  ///< The link of the last entry; valid until the next entry is added.
  bool closed = false;           ///< No entry can be added: one of them is incomplete, or there are too many.
};

Candidates candidates_of(Run& run, const Shape& shape, std::uint32_t& first) {
  Candidates found{.end = &first};
  DrawReplay replay{run, shape.node};
  std::size_t count = 0;
  for (; *found.end != 0 && !found.closed; ++count) {
    MemoEntry& entry = run.memo.entries[*found.end - 1];
    found.closed = !entry.ready || count + 1 >= kMostVariants;
    if (entry.ready && found.known == 0 && replay.draws_match(entry.subtree)) found.known = *found.end;
    found.end = &entry.next;
  }
  return found;
}

Recording open_recording(Execution& execution, std::uint32_t& end) {
  Run& run = execution.run;
  std::vector<MemoEntry>& entries = run.memo.entries;
  const auto entry = end = static_cast<std::uint32_t>(entries.size() + 1);
  entries.emplace_back().subtree.pose = pose_of(execution.shape);
  run.memo.open.push_back({execution.shape.node, execution.depth, execution.depth});
  return {entry, false, ends_of(run)};
}

void rehash(MemoIndex& index) {
  MemoIndex larger;
  larger.slots.resize(2 * index.slots.size());
  for (const MemoIndex::Slot& slot : index.slots)
    if (slot.first != 0) larger[slot.key] = slot.first;
  index = std::move(larger);
}

}  // namespace

void MemoKey::add(std::int64_t word) {
  const auto w = static_cast<std::uint64_t>(word);
  a = (a ^ w) * 0x9e3779b97f4a7c15u, a ^= a >> 32;
  b = (b ^ w) * 0xd6e8feb86659fd93u, b ^= b >> 29;
}

void MemoKey::add(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto u = static_cast<std::uint64_t>(x), v = static_cast<std::uint64_t>(y), w = static_cast<std::uint64_t>(z);
  // each half combines the words by other odd factors, so that collisions of one half are not those of the other
  a = (a ^ (u + v * 0xff51afd7ed558ccdu + w * 0xc4ceb9fe1a85ec53u)) * 0x9e3779b97f4a7c15u, a ^= a >> 32;
  b = (b ^ (u * 0xbf58476d1ce4e5b9u + v + w * 0x94d049bb133111ebu)) * 0xd6e8feb86659fd93u, b ^= b >> 29;
}

std::uint32_t& MemoIndex::operator[](const MemoKey& key) {
  if (2 * taken >= slots.size()) rehash(*this);
  std::size_t i = key.a & (slots.size() - 1);
  while (slots[i].first != 0 && !(slots[i].key == key)) i = (i + 1) & (slots.size() - 1);
  if (slots[i].first == 0) slots[i].key = key, ++taken;
  return slots[i].first;
}

Recording begin_recording(Execution& execution, const Body& body) {
  assert(body.number < execution.run.memo.bodies.size());
  Run& run = execution.run;
  BodyRecord& record = run.memo.bodies[body.number];
  if (!run.options.memoise || record.never || only_names(body) || !may_repeat(execution.shape)) return {};
  const Candidates found = candidates_of(run, execution.shape, run.memo.first_of[memo_key(execution, body)]);
  if (found.known == 0) {
    if (found.closed) return {};
    ++record.misses;
    return open_recording(execution, *found.end);
  }
  if (!fits_limits(run, execution.depth, run.memo.entries[found.known - 1].subtree.made)) return {};
  ++record.hits;
  return {found.known, true, {}};
}

void note_depth(Memo& memo, int depth) {
  if (!memo.open.empty()) memo.open.back().deepest = std::max(memo.open.back().deepest, depth);
}

NodeTrace repeat(Execution& execution, const Recording& recording) {
  assert(recording.known && recording.entry > 0);
  Run& run = execution.run;
  const Subtree& subtree = run.memo.entries[recording.entry - 1].subtree;
  const SubtreeRows& made = subtree.made;
  copy_subtree(run, subtree, execution.shape);
  note_depth(run.memo, execution.depth + made.nested_rules);
  run.out.shapes += made.shapes;
  run.out.copied += made.shapes;
  run.out.steps += made.steps;
  NodeTrace trace = made.trace;
  // the shapes agree to kSame_m at each end of an extent, and a distance depends on two points of each shape
  if (!trace.vanished) trace.moved = trace.moved + Displacement{4 * kSame_m, 4 * kSame_m};
  return trace;
}

void end_recording(Run& run, const Body& body, const Recording& recording, NodeTrace trace) {
  if (recording.entry == 0) return;
  Memo& memo = run.memo;
  assert(!memo.open.empty());
  BodyRecord& record = memo.bodies[body.number];
  MemoEntry& entry = memo.entries[recording.entry - 1];
  SubtreeRows& made = entry.subtree.made = between(recording.before, ends_of(run), trace);
  const OpenNode node = memo.open.back();
  memo.open.pop_back();
  note_depth(memo, node.deepest);
  made.nested_rules = node.deepest - node.depth;
  const bool is_small = made.shapes <= kFewShapes;
  entry.ready = node.is_repeatable && made.draws.size() <= kMostDraws;
  record.small_ones += is_small;
  record.never |= is_small && body.kind == BodyKind::kStatements;
  record.never |= !entry.ready || record.small_ones >= kManyTimes || (record.misses >= kManyMisses && record.hits == 0);
  if (entry.ready) memo.seen.push_back(recording.entry - 1);
}

void remove_terminals_from(Run& run, std::size_t first) {
  assert(first <= run.out.terminals.size());
  Memo& memo = run.memo;
  std::vector<Terminal>& terminals = run.out.terminals;
  const auto last_is_in = [&] {
    return !memo.seen.empty() && memo.entries[memo.seen.back()].subtree.made.terminals.end > first;
  };
  if (last_is_in()) {
    const auto from = static_cast<std::ptrdiff_t>(first);
    memo.removed.push_back(
        {first,
         {std::make_move_iterator(terminals.begin() + from), std::make_move_iterator(terminals.end())},
         {run.origins.begin() + from, run.origins.end()}});
  }
  for (; last_is_in(); memo.seen.pop_back())
    memo.entries[memo.seen.back()].subtree.removed = static_cast<std::uint32_t>(memo.removed.size());
  terminals.resize(first);
  run.origins.resize(first);
}

}  // namespace citykiln::grammars
