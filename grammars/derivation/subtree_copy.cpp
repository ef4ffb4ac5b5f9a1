#include "grammars/derivation/subtree_copy.h"

#include <cmath>

#include "grammars/derivation/run.h"

namespace citykiln::grammars {
namespace {

// to 2^-40 within a kilometre: what is level in one copy is level in all. Doubles about 1.5 · 2^12 have no finer bits.
double clean(double v) { return (v + 0x1.8p12) - 0x1.8p12; }

/// From where the pattern's shape stands to where the copy's does.
struct Motion {
  const ShapePose& from;
  const ShapePose& to;

  Vec3 turned(Vec3 v) const {
    const auto& axis = to.axis;
    return axis[0] * clean(dot(from.axis[0], v)) + axis[1] * clean(dot(from.axis[1], v)) +
           axis[2] * clean(dot(from.axis[2], v));
  }
  Vec3 moved(Vec3 p) const {
    for (std::size_t i = 0; i < from.ring.size(); ++i)
      if (from.ring[i] == p) return to.ring[i];
    return to.origin + turned(p - from.origin);
  }
};

/// Where the copy's rows begin.
struct Rows {
  std::uint32_t birth = 0, texture = 0;
};

// the pattern's own shape's is the copy's, and those of what it made stand in the same order
std::uint32_t birth_of(std::uint32_t birth, const Subtree& pattern, const ShapePose& to, Rows rows) {
  if (birth == pattern.stand.birth) return to.birth;
  return static_cast<std::uint32_t>(rows.birth + (birth - pattern.made.nodes.first));
}

std::uint32_t texture_of(std::uint32_t texture, const Subtree& pattern, const ShapePose& to, Rows rows) {
  const std::size_t first = pattern.made.textures.first;
  if (texture >= first) return static_cast<std::uint32_t>(rows.texture + (texture - first));
  return texture == pattern.stand.texture ? to.texture : to.projection;
}

void copy_births(Run& run, const Subtree& pattern, const ShapePose& to, Rows rows) {
  for (std::size_t i = pattern.made.nodes.first; i < pattern.made.nodes.end; ++i) {
    DerivationNode birth = run.nodes[i];
    birth.parent = birth_of(birth.parent, pattern, to, rows);
    run.nodes.push_back(birth);
  }
}

void copy_textures(Run& run, const Subtree& pattern, const Motion& motion) {
  for (std::size_t i = pattern.made.textures.first; i < pattern.made.textures.end; ++i) {
    const TextureProjection from = run.tables.textures[i];
    run.tables.add(
        TextureProjection{motion.moved(from.origin), motion.turned(from.u_per_m), motion.turned(from.v_per_m)});
  }
}

void move_terminal(Terminal& terminal, const Motion& motion) {
  for (Face& face : terminal.faces) each_vertex(face, [&](Vec3& p) { p = motion.moved(p); });
  terminal.scope.origin = motion.moved(terminal.scope.origin);
  for (Vec3& axis : terminal.scope.axis) axis = motion.turned(axis);
}

void copy_terminals(Run& run, const Subtree& pattern, const Motion& motion, Rows rows) {
  const RemovedTerminals* away = pattern.cut_away == 0 ? nullptr : &run.memo.cut_away[pattern.cut_away - 1];
  const IndexRange range = pattern.made.terminals;
  for (std::size_t i = range.first; i < range.end; ++i) {
    TerminalNote note = away == nullptr ? run.notes[i] : away->notes[i - away->first];
    run.out.terminals.push_back(away == nullptr ? run.out.terminals[i] : away->terminals[i - away->first]);
    Terminal& terminal = run.out.terminals.back();
    move_terminal(terminal, motion);
    note.birth = birth_of(note.birth, pattern, motion.to, rows);
    note.texture = texture_of(note.texture, pattern, motion.to, rows);
    terminal.texture = run.tables.texture_at(note.texture);
    run.notes.push_back(note);
  }
}

void copy_reports(Run& run, const Subtree& pattern, const ShapePose& to, Rows rows) {
  for (std::size_t i = pattern.made.reports.first; i < pattern.made.reports.end; ++i) {
    Reported report = run.out.reports[i];
    run.out.reports.push_back(std::move(report));
    run.report_births.push_back(birth_of(run.report_births[i], pattern, to, rows));
  }
}

void copy_throws(Run& run, const Subtree& pattern, const ShapePose& to, Rows rows) {
  for (std::size_t i = pattern.made.throws.first; i < pattern.made.throws.end; ++i) {
    RandomDraw thrown = run.throws[i];
    thrown.birth = birth_of(thrown.birth, pattern, to, rows);
    run.record_draw(thrown);
  }
}

// of the shape that `birth`, a descendant of the pattern's shape, is like
StableId id_in_copy(Run& run, std::uint32_t birth, std::uint32_t of_pattern, StableId of_copy) {
  if (birth == of_pattern) return of_copy;
  const DerivationNode& born = run.nodes[birth];
  return stable_id(id_in_copy(run, born.parent, of_pattern, of_copy), born.name, born.ordinal);
}

}  // namespace

ShapePose pose_of(const Shape& shape) {
  return {shape.faces.front().outer, shape.scope.origin, shape.scope.axis, shape.birth, shape.texture,
          shape.projection};
}

bool DrawReplay::draws_match(const Subtree& pattern) {
  const IndexRange throws = pattern.made.throws;
  for (std::size_t i = 0; i < throws.size(); ++i) {
    const RandomDraw& thrown = run.throws[throws.first + i];
    if (i == units.size()) {
      const StableId id = id_in_copy(run, thrown.birth, pattern.stand.birth, run.id_of(birth));
      units.push_back(Draw(run.options.seed, id, "rule").unit(thrown.index));
    }
    const double value = units[i] * thrown.scale;
    if (!(thrown.low <= value && value < thrown.high)) return false;
  }
  return true;
}

void copy_subtree(Run& run, const Subtree& pattern, const Shape& shape) {
  const ShapePose to = pose_of(shape);
  const Motion motion{pattern.stand, to};
  const Rows rows{static_cast<std::uint32_t>(run.nodes.size()), static_cast<std::uint32_t>(run.tables.textures.size())};
  copy_births(run, pattern, to, rows);
  copy_textures(run, pattern, motion);
  copy_terminals(run, pattern, motion, rows);
  copy_reports(run, pattern, to, rows);
  copy_throws(run, pattern, to, rows);
}

}  // namespace citykiln::grammars
