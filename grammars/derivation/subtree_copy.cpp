#include "grammars/derivation/subtree_copy.h"

#include <cassert>

#include "grammars/derivation/run.h"

namespace citykiln::grammars {
namespace {

// Rounds to a multiple of 2^-40, so that what is horizontal in one copy is so in all: doubles near 1.5 · 2^12 have no
// finer bits. For |v| < 2^11.
double rounded(double v) { return (v + 0x1.8p12) - 0x1.8p12; }

/// The rigid motion from one pose to another.
struct Motion {
  const ShapePose& from;
  const ShapePose& to;

  Vec3 turned(Vec3 v) const {
    const auto& axis = to.axis;
    return axis[0] * rounded(dot(from.axis[0], v)) + axis[1] * rounded(dot(from.axis[1], v)) +
           axis[2] * rounded(dot(from.axis[2], v));
  }
  Vec3 moved(Vec3 p) const {
    for (std::size_t i = 0; i < from.ring.size(); ++i)
      if (from.ring[i] == p) return to.ring[i];
    return to.origin + turned(p - from.origin);
  }
};

/// The first rows of the copy.
struct Rows {
  std::uint32_t node = 0, texture = 0;
};

// Nodes of the copy are in the same order as those of the subtree.
std::uint32_t node_of(std::uint32_t node, const Subtree& subtree, const ShapePose& to, Rows rows) {
  if (node == subtree.pose.node) return to.node;
  return static_cast<std::uint32_t>(rows.node + (node - subtree.made.nodes.first));
}

std::uint32_t texture_of(std::uint32_t texture, const Subtree& subtree, const ShapePose& to, Rows rows) {
  const std::size_t first = subtree.made.textures.first;
  if (texture >= first) return static_cast<std::uint32_t>(rows.texture + (texture - first));
  return texture == subtree.pose.texture ? to.texture : to.projection;
}

void copy_nodes(Run& run, const Subtree& subtree, const ShapePose& to, Rows rows) {
  for (std::size_t i = subtree.made.nodes.first; i < subtree.made.nodes.end; ++i) {
    DerivationNode node = run.nodes[i];
    node.parent = node_of(node.parent, subtree, to, rows);
    run.nodes.push_back(node);
  }
}

void copy_textures(Run& run, const Subtree& subtree, const Motion& motion) {
  for (std::size_t i = subtree.made.textures.first; i < subtree.made.textures.end; ++i) {
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

void copy_terminals(Run& run, const Subtree& subtree, const Motion& motion, Rows rows) {
  const RemovedTerminals* removed = subtree.removed == 0 ? nullptr : &run.memo.removed[subtree.removed - 1];
  const IndexRange range = subtree.made.terminals;
  for (std::size_t i = range.first; i < range.end; ++i) {
    TerminalOrigin origin = removed == nullptr ? run.origins[i] : removed->origins[i - removed->first];
    run.out.terminals.push_back(removed == nullptr ? run.out.terminals[i] : removed->terminals[i - removed->first]);
    Terminal& terminal = run.out.terminals.back();
    move_terminal(terminal, motion);
    origin.node = node_of(origin.node, subtree, motion.to, rows);
    origin.texture = texture_of(origin.texture, subtree, motion.to, rows);
    terminal.texture = run.tables.texture_at(origin.texture);
    run.origins.push_back(origin);
  }
}

void copy_reports(Run& run, const Subtree& subtree, const ShapePose& to, Rows rows) {
  for (std::size_t i = subtree.made.reports.first; i < subtree.made.reports.end; ++i) {
    Reported report = run.out.reports[i];
    run.out.reports.push_back(std::move(report));
    run.report_nodes.push_back(node_of(run.report_nodes[i], subtree, to, rows));
  }
}

void copy_draws(Run& run, const Subtree& subtree, const ShapePose& to, Rows rows) {
  for (std::size_t i = subtree.made.draws.first; i < subtree.made.draws.end; ++i) {
    RandomDraw draw = run.draws[i];
    draw.node = node_of(draw.node, subtree, to, rows);
    run.record_draw(draw);
  }
}

// The id that the descendant `node` of `root` has in a copy, whose root has the id `root_of_copy`.
StableId id_in_copy(Run& run, std::uint32_t node, std::uint32_t root, StableId root_of_copy) {
  if (node == root) return root_of_copy;
  const DerivationNode& child = run.nodes[node];
  return stable_id(id_in_copy(run, child.parent, root, root_of_copy), child.name, child.ordinal);
}

}  // namespace

ShapePose pose_of(const Shape& shape) {
  assert(shape.faces.size() == 1);
  return {.ring = shape.faces.front().outer,
          .origin = shape.scope.origin,
          .axis = shape.scope.axis,
          .node = shape.node,
          .texture = shape.texture,
          .projection = shape.projection};
}

bool DrawReplay::draws_match(const Subtree& subtree) {
  const IndexRange draws = subtree.made.draws;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const RandomDraw& draw = run.draws[draws.first + i];
    if (i == units.size()) {
      const StableId id = id_in_copy(run, draw.node, subtree.pose.node, run.id_of(node));
      units.push_back(RandomSequence(run.options.seed, id, "rule").unit(draw.index));
    }
    const double value = units[i] * draw.scale;
    if (!(draw.low <= value && value < draw.high)) return false;
  }
  return true;
}

void copy_subtree(Run& run, const Subtree& subtree, const Shape& shape) {
  assert(shape.faces.size() == 1 && shape.faces.front().outer.size() == subtree.pose.ring.size());
  const ShapePose to = pose_of(shape);
  const Motion motion{subtree.pose, to};
  const Rows rows{static_cast<std::uint32_t>(run.nodes.size()), static_cast<std::uint32_t>(run.tables.textures.size())};
  copy_nodes(run, subtree, to, rows);
  copy_textures(run, subtree, motion);
  copy_terminals(run, subtree, motion, rows);
  copy_reports(run, subtree, to, rows);
  copy_draws(run, subtree, to, rows);
}

}  // namespace citykiln::grammars
