#include "grammars/pattern.h"

#include <algorithm>
#include <cmath>
#include <map>

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

/// A pattern in the making.
struct Maker {
  const Run& run;
  const Shape& shape;
  const Made& made;
  Pattern pattern = {};
  std::map<Vec3, std::uint32_t> point_of = {};
  std::map<std::uint32_t, std::uint32_t> texture_of = {};
  std::map<std::uint32_t, std::uint32_t> birth_of = {};
};

std::uint32_t add_point(Maker& maker, Vec3 p) {
  const auto next = static_cast<std::uint32_t>(maker.pattern.points.size());
  const auto [found, is_new] = maker.point_of.emplace(p, next);
  if (is_new) maker.pattern.points.push_back(anchored(p, maker.shape));
  return found->second;
}

bool is_vertex(const Maker& maker, Vec3 p) {
  const Ring3& ring = maker.shape.faces.front().outer;
  return std::find(ring.begin(), ring.end(), p) != ring.end();
}

// 0 is the shape itself, and parents come before their children
std::uint32_t add_birth(Maker& maker, std::uint32_t birth) {
  if (birth == maker.shape.birth) return 0;
  const auto found = maker.birth_of.find(birth);
  if (found != maker.birth_of.end()) return found->second;
  Birth descent = maker.run.births[birth];
  descent.parent = add_birth(maker, descent.parent);
  maker.pattern.births.push_back(descent);
  return maker.birth_of[birth] = static_cast<std::uint32_t>(maker.pattern.births.size());
}

/// Descents seen from one shape.
struct Descent {
  const Run& run;
  std::uint32_t birth;
  Throws throws = {};
  std::map<std::uint32_t, std::uint32_t> place_of = {};

  std::uint32_t add(std::uint32_t other) {
    if (other == birth) return 0;
    const auto found = place_of.find(other);
    if (found != place_of.end()) return found->second;
    Birth descent = run.births[other];
    descent.parent = add(descent.parent);
    throws.births.push_back(descent);
    return place_of[other] = static_cast<std::uint32_t>(throws.births.size());
  }
};

std::uint32_t add_texture(Maker& maker, std::uint32_t texture) {
  const auto next = static_cast<std::uint32_t>(maker.pattern.textures.size());
  const auto [found, is_new] = maker.texture_of.emplace(texture, next);
  if (!is_new) return found->second;
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
  std::vector<StableId> ids = {};
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
  copy.ids.reserve(pattern.births.size() + 1);
  copy.ids.push_back(copy.shape.id);
  copy.first_birth = run.births.size();
  for (const Birth& birth : pattern.births) {
    copy.ids.push_back(stable_id(copy.ids[birth.parent], birth.name, birth.ordinal));
    run.births.push_back({copy.birth(birth.parent), birth.name, birth.ordinal});
  }
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
  terminal.id = copy.ids[from.note.birth];
  terminal.scope.origin = copy.points[from.origin];
  for (Vec3& axis : terminal.scope.axis) axis = in_space(copy.shape.scope, axis);
  note.birth = copy.birth(from.note.birth);
  note.texture = texture_of(from, copy);
  note.moved_at = from.moved ? static_cast<std::uint32_t>(run.births.size()) : copy.shape.moved_at;
  terminal.texture = run.tables.texture_at(note.texture);
}

}  // namespace

Throws throws_of(const Run& run, std::uint32_t birth, IndexRange throws) {
  Descent descent{run, birth};
  for (std::size_t i = throws.first; i < throws.end; ++i) {
    Throw thrown = run.throws[i];
    thrown.birth = descent.add(thrown.birth);
    descent.throws.thrown.push_back(thrown);
  }
  return std::move(descent.throws);
}

bool would_throw(const Run& run, StableId shape, const Throws& throws) {
  if (throws.thrown.empty()) return true;
  std::vector<StableId> ids = {shape};
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
    run.out.reports.push_back({report.reported.name, report.reported.value, copy.ids[report.birth]});
    run.report_births.push_back(copy.birth(report.birth));
  }
  for (Throw thrown : pattern.throws) {
    thrown.birth = copy.birth(thrown.birth);
    run.threw(thrown);
  }
}

}  // namespace citykiln::grammars
