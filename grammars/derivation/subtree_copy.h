// Copies the result of a node to another shape that differs only by a rigid motion.
//
//   A ── split ──┬── B ── …   The nodes, terminals, textures and draws that a node made are consecutive rows in the
//                └── C ── …   tables of the run. So a subtree is stored as ranges of rows, and a copy is these rows,
//                moved.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "grammars/derivation/derive.h"
#include "grammars/derivation/displacement.h"

namespace citykiln::grammars {

struct Run;

/// A node of the derivation tree: the `ordinal`-th child of `parent`. Its id follows from these.
struct DerivationNode {
  std::uint32_t parent = 0;  ///< Index into Run::nodes.
  const char* name = "";     ///< Points into the program, which outlives the run.
  std::uint64_t ordinal = 0;
};

/// A random draw of a shape that selected one of a few branches.
struct RandomDraw {
  std::uint32_t node = 0;    ///< The node of the shape that draws.
  std::uint32_t index = 0;   ///< The index passed to Draw::unit().
  double scale = 1;          ///< The factor by which the rule multiplies the number.
  double low = 0, high = 0;  ///< low <= number · scale < high. Every number in this interval selects the same branch.
};

/// The internal data of a terminal, beside its Terminal.
struct TerminalOrigin {
  std::uint32_t node = 0;
  std::uint32_t texture = 0;  ///< Index into Tables::textures.
  /// Index into Tables::appearance_areas: the detail that a simplified terminal replaces.
  std::uint32_t stands_for = 0;
};

/// Terminals that a simplification removed but memo entries may still copy.
struct RemovedTerminals {
  std::size_t first = 0;  ///< The former index of the first one.
  std::vector<Terminal> terminals;
  std::vector<TerminalOrigin> origins;
};

/// The indices from `first` up to but not including `end`.
struct IndexRange {
  std::size_t first = 0, end = 0;
  std::size_t size() const { return end - first; }
};

/// The rows that a node made in the tables of the run.
struct SubtreeRows {
  IndexRange terminals, nodes, reports, textures, draws;
  std::uint64_t shapes = 0, steps = 0;
  int nested_rules = 0;  ///< The greatest number of nested rules below the node.
  NodeTrace trace;
};

/// The position and orientation of a shape with one face, and the indices that it inherited.
struct ShapePose {
  Ring3 ring;  ///< The face's outer ring.
  Vec3 origin;
  std::array<Vec3, 3> axis;
  std::uint32_t node = 0, texture = 0, projection = 0;  ///< The members of Shape with these names.
};
/// Returns the pose of a shape that has one face.
ShapePose pose_of(const Shape& shape);

struct Subtree {
  ShapePose pose;
  SubtreeRows made;
  std::uint32_t removed = 0;  ///< 1 + index into Memo::removed of its terminals; 0 while they are in the derivation.
};

/// The random draws that the descendants of a shape would make, computed at the first comparison.
struct DrawReplay {
  Run& run;
  std::uint32_t node;           ///< The node of the shape that draws.
  std::vector<double> units{};  ///< The numbers, in the order in which a derivation would draw them.

  /// True if the draws select the same branches as those of the subtree. All subtrees compared by one replay must have
  /// the same key: then they draw the same numbers while these select the same branches. O(depth of rules) for each
  /// draw that is not computed yet.
  bool draws_match(const Subtree& subtree);
};

/// Adds a copy of the subtree at `shape` to the tables of the run.
///
/// Guarantees: vertices of the shape are unchanged, bit for bit; equal points stay equal; ids are those of a derivation
/// of the shape. Other points keep their coordinates along the axes of the scope to 2^-40 m. O(size of the subtree).
void copy_subtree(Run& run, const Subtree& subtree, const Shape& shape);

}  // namespace citykiln::grammars
