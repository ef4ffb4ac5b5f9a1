#include "grammars/pattern.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "grammars/run.h"

namespace citykiln::grammars {
namespace {

constexpr double kOnBorder_m = 1e-5;  // far above what counts as the same, far below what is built

double distance_to_segment_m(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 ab = b - a;
  const double t = dot(ab, ab) > 0 ? std::clamp(dot(p - a, ab) / dot(ab, ab), 0.0, 1.0) : 0;
  return length(p - (a + ab * t));
}

bool is_on_border(Vec3 p, const Ring3& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (distance_to_segment_m(p, ring[i], ring[(i + 1) % ring.size()]) < kOnBorder_m) return true;
  return false;
}

// to 2^-40: what is level in one copy is level in all
double clean(double v) { return std::floor(v * 0x1p40 + 0.5) * 0x1p-40; }

Vec3 along_axes(const Scope& scope, Vec3 v) {
  return {clean(dot(scope.axis[0], v)), clean(dot(scope.axis[1], v)), clean(dot(scope.axis[2], v))};
}

Vec3 in_space(const Scope& scope, Vec3 v) { return scope.axis[0] * v.x + scope.axis[1] * v.y + scope.axis[2] * v.z; }

Anchored anchored(Vec3 p, const Shape& shape) {
  const Ring3& ring = shape.faces.front().outer;
  std::uint32_t nearest = 0;
  for (std::uint32_t i = 1; i < ring.size(); ++i)
    if (length(p - ring[i]) < length(p - ring[nearest])) nearest = i;
  return {nearest, along_axes(shape.scope, p - ring[nearest])};
}

/// Points, each known by its place: open addressing, twice as many slots as points.
struct PointTable {
  std::vector<Vec3> points = {};
  std::vector<std::uint32_t> slots = std::vector<std::uint32_t>(64);  ///< 1 + the point's index; 0: free.

  /// Where the point is, or its slot's place to put it.
  std::uint32_t& slot_of(Vec3 p) {
    // + 0.0: both zeros are one place
    std::uint64_t hash = 0;
    for (const double v : {p.x + 0.0, p.y + 0.0, p.z + 0.0})
      hash = (hash ^ std::bit_cast<std::uint64_t>(v)) * 0x9e3779b97f4a7c15u, hash ^= hash >> 32;
    std::size_t at = hash & (slots.size() - 1);
    while (slots[at] != 0 && !(points[slots[at] - 1] == p)) at = (at + 1) & (slots.size() - 1);
    return slots[at];
  }
  /// True if it is new; then it is the last.
  bool add(Vec3 p, std::uint32_t& index) {
    if (2 * points.size() >= slots.size()) grow();
    std::uint32_t& slot = slot_of(p);
    const bool is_new = slot == 0;
    if (is_new) points.push_back(p), slot = static_cast<std::uint32_t>(points.size());
    index = slot - 1;
    return is_new;
  }
  void grow() {
    slots.assign(2 * slots.size(), 0);
    for (std::uint32_t i = 0; i < points.size(); ++i) slot_of(points[i]) = i + 1;
  }
};

/// A pattern in the making.
struct Maker {
  const Run& run;
  const Shape& shape;
  const Made& made;
  Pattern pattern = {};
  PointTable points = {};
  std::vector<std::uint32_t> textures = {};  ///< In the run, of Pattern::textures.
  /// By birth, from the first that the node bore: where Pattern::births has it, 0 for nowhere yet.
  std::vector<std::uint32_t> birth_of = std::vector<std::uint32_t>(made.births.end - made.births.first);
};

std::uint32_t add_point(Maker& maker, Vec3 p) {
  std::uint32_t index = 0;
  if (maker.points.add(p, index)) maker.pattern.points.push_back(anchored(p, maker.shape));
  return index;
}

bool is_vertex(const Maker& maker, Vec3 p) {
  const Ring3& ring = maker.shape.faces.front().outer;
  return std::find(ring.begin(), ring.end(), p) != ring.end();
}

// 0 is the shape itself, and parents come before their children
std::uint32_t add_birth(Maker& maker, std::uint32_t birth) {
  if (birth == maker.shape.birth) return 0;
  const std::size_t place = birth - maker.made.births.first;
  if (maker.birth_of[place] != 0) return maker.birth_of[place];
  Birth descent = maker.run.births[birth];
  descent.parent = add_birth(maker, descent.parent);
  maker.pattern.births.push_back(descent);
  return maker.birth_of[place] = static_cast<std::uint32_t>(maker.pattern.births.size());
}

/// Descents seen from one shape: of the few that throw.
struct Descent {
  const Run& run;
  std::uint32_t birth;
  Throws throws = {};
  std::vector<std::uint32_t> births = {};  ///< In the run, of `throws.births`.

  std::uint32_t add(std::uint32_t other) {
    if (other == birth) return 0;
    const auto found = std::find(births.begin(), births.end(), other);
    if (found != births.end()) return static_cast<std::uint32_t>(found - births.begin()) + 1;
    Birth descent = run.births[other];
    descent.parent = add(descent.parent);
    throws.births.push_back(descent);
    births.push_back(other);
    return static_cast<std::uint32_t>(births.size());
  }
};

std::uint32_t add_texture(Maker& maker, std::uint32_t texture) {
  const auto found = std::find(maker.textures.begin(), maker.textures.end(), texture);
  const auto next = static_cast<std::uint32_t>(found - maker.textures.begin());
  if (found != maker.textures.end()) return next;
  maker.textures.push_back(texture);
  const TextureFrame& frame = maker.run.tables.textures[texture];
  const Scope& scope = maker.shape.scope;
  maker.pattern.textures.push_back(
      {add_point(maker, frame.origin), along_axes(scope, frame.u_per_m), along_axes(scope, frame.v_per_m)});
  return next;
}

void place_texture(Maker& maker, PatternTerminal& copy) {
  const std::uint32_t texture = copy.note.texture;
  if (texture >= maker.made.textures.first) {
    copy.source = TextureSource::kOwn;
    copy.texture = add_texture(maker, texture);
  } else {
    copy.source = texture == maker.shape.texture ? TextureSource::kTexture : TextureSource::kProjection;
  }
}

// true if it divides the shape's surface at the border
bool divides_border(const Maker& maker, std::size_t index) {
  if (maker.run.notes[index].moved_at > maker.shape.birth) return false;
  const Ring3& border = maker.shape.faces.front().outer;
  bool divides = false;
  for (const Face& face : maker.run.out.terminals[index].faces)
    each_vertex(face, [&](Vec3 p) { divides |= !is_vertex(maker, p) && is_on_border(p, border); });
  return divides;
}

void add_terminal(Maker& maker, std::size_t index) {
  const TerminalNote note = maker.run.notes[index];
  PatternTerminal copy{maker.run.out.terminals[index], note, note.moved_at > maker.shape.birth};
  for (const Face& face : copy.terminal.faces)
    each_vertex(face, [&](Vec3 p) { copy.points.push_back(add_point(maker, p)); });
  copy.note.birth = add_birth(maker, note.birth);
  Scope& scope = copy.terminal.scope;
  copy.origin = add_point(maker, scope.origin);
  for (Vec3& axis : scope.axis) axis = along_axes(maker.shape.scope, axis);
  place_texture(maker, copy);
  maker.pattern.terminals.push_back(std::move(copy));
}

/// A copy in the making.
struct Copy {
  const Shape& shape;
  std::vector<Vec3> points = {};
  std::size_t first_birth = 0, first_texture = 0;

  std::uint32_t birth(std::uint32_t in_pattern) const {
    return in_pattern == 0 ? shape.birth : static_cast<std::uint32_t>(first_birth + in_pattern - 1);
  }
};

void place_points(const Pattern& pattern, Copy& copy) {
  const Ring3& ring = copy.shape.faces.front().outer;
  copy.points.reserve(pattern.points.size());
  for (const Anchored& point : pattern.points)
    copy.points.push_back(ring[point.vertex] + in_space(copy.shape.scope, point.offset_m));
}

void bear_all(Run& run, const Pattern& pattern, Copy& copy) {
  copy.first_birth = run.births.size();
  for (const Birth& birth : pattern.births) run.births.push_back({copy.birth(birth.parent), birth.name, birth.ordinal});
}

void lay_textures(Run& run, const Pattern& pattern, Copy& copy) {
  copy.first_texture = run.tables.textures.size();
  for (const Pattern::Texture& texture : pattern.textures)
    run.tables.add(TextureFrame{copy.points[texture.origin], in_space(copy.shape.scope, texture.u_per_m),
                                in_space(copy.shape.scope, texture.v_per_m)});
}

std::uint32_t texture_of(const PatternTerminal& terminal, const Copy& copy) {
  if (terminal.source == TextureSource::kTexture) return copy.shape.texture;
  if (terminal.source == TextureSource::kProjection) return copy.shape.projection;
  return static_cast<std::uint32_t>(copy.first_texture + terminal.texture);
}

void copy_terminal(Run& run, const PatternTerminal& from, const Copy& copy) {
  Terminal& terminal = run.out.terminals.emplace_back(from.terminal);
  TerminalNote& note = run.notes.emplace_back(from.note);
  const std::uint32_t* point = from.points.data();
  for (Face& face : terminal.faces) each_vertex(face, [&](Vec3& p) { p = copy.points[*point++]; });
  terminal.scope.origin = copy.points[from.origin];
  for (Vec3& axis : terminal.scope.axis) axis = in_space(copy.shape.scope, axis);
  note.birth = copy.birth(from.note.birth);
  note.texture = texture_of(from, copy);
  note.moved_at = from.moved ? static_cast<std::uint32_t>(run.births.size()) : copy.shape.moved_at;
  terminal.texture = run.tables.texture_at(note.texture);
}

}  // namespace

Throws throws_of(const Run& run, std::uint32_t birth, IndexRange throws) {
  if (throws.first == throws.end) return {};
  Descent descent{run, birth};
  for (std::size_t i = throws.first; i < throws.end; ++i) {
    Throw thrown = run.throws[i];
    thrown.birth = descent.add(thrown.birth);
    descent.throws.thrown.push_back(thrown);
  }
  return std::move(descent.throws);
}

bool would_throw(Run& run, std::uint32_t birth, const Throws& throws) {
  if (throws.thrown.empty()) return true;
  std::vector<StableId> ids = {run.id_of(birth)};
  ids.reserve(throws.births.size() + 1);
  for (const Birth& birth : throws.births) ids.push_back(stable_id(ids[birth.parent], birth.name, birth.ordinal));
  return std::all_of(throws.thrown.begin(), throws.thrown.end(), [&](const Throw& thrown) {
    const double value = Draw(run.options.seed, ids[thrown.birth], "rule").unit(thrown.index) * thrown.scale;
    return thrown.low <= value && value < thrown.high;
  });
}

std::optional<Pattern> pattern_of(const Run& run, const Shape& shape, const Made& made) {
  Maker maker{run, shape, made};
  for (std::size_t i = made.terminals.first; i < made.terminals.end; ++i)
    if (divides_border(maker, i)) return std::nullopt;
  for (std::size_t i = made.terminals.first; i < made.terminals.end; ++i) add_terminal(maker, i);
  for (std::size_t i = made.reports.first; i < made.reports.end; ++i)
    maker.pattern.reports.push_back({run.out.reports[i], add_birth(maker, run.report_births[i])});
  for (std::size_t i = made.throws.first; i < made.throws.end; ++i) {
    Throw& thrown = maker.pattern.throws.emplace_back(run.throws[i]);
    thrown.birth = add_birth(maker, thrown.birth);
  }
  return std::move(maker.pattern);
}

void copy_pattern(Run& run, const Pattern& pattern, const Shape& shape) {
  Copy copy{shape};
  place_points(pattern, copy);
  bear_all(run, pattern, copy);
  lay_textures(run, pattern, copy);
  for (const PatternTerminal& terminal : pattern.terminals) copy_terminal(run, terminal, copy);
  for (const PatternReport& report : pattern.reports) {
    run.out.reports.push_back({report.reported.name, report.reported.value, {}});
    run.report_births.push_back(copy.birth(report.birth));
  }
  for (Throw thrown : pattern.throws) {
    thrown.birth = copy.birth(thrown.birth);
    run.threw(thrown);
  }
}

}  // namespace citykiln::grammars
