// Copies the result of a node to another shape that differs by a rigid motion only.
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
  const char* name = "";     ///< Part of the program, which outlives the run.
  std::uint64_t ordinal = 0;
};

/// A random draw of a shape that selected one of a few branches.
struct RandomDraw {
  std::uint32_t node = 0;    ///< The shape's.
  std::uint32_t index = 0;   ///< Of Draw::unit().
  double scale = 1;          ///< The factor of the number.
  double low = 0, high = 0;  ///< low <= number · scale < high: every number in this interval selects the same branch.
};

/// What a derivation knows of a terminal besides Terminal.
struct TerminalOrigin {
  std::uint32_t node = 0;
  std::uint32_t texture = 0;     ///< Index into Tables::textures.
  std::uint32_t stands_for = 0;  ///< Index into Tables::appearance_areas: the detail replaced by a simplified terminal.
};

/// Terminals removed by a simplification that memo entries may still copy.
struct RemovedTerminals {
  std::size_t first = 0;  ///< The index that the first of them had.
  std::vector<Terminal> terminals;
  std::vector<TerminalOrigin> origins;
};

/// Indices from `first` to before `end`.
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

/// The pose of a shape of one face, and what it was given from outside.
struct ShapePose {
  Ring3 ring;  ///< Of the face.
  Vec3 origin;
  std::array<Vec3, 3> axis;
  std::uint32_t node = 0, texture = 0, projection = 0;  ///< As in Shape.
};
/// @param shape  Has one face.
ShapePose pose_of(const Shape& shape);

struct Subtree {
  ShapePose pose;
  SubtreeRows made;
  std::uint32_t removed = 0;  ///< 1 + index into Memo::removed of its terminals; 0 while they are in the derivation.
};

/// The draws that the descendants of a shape would make, computed when first compared.
struct DrawReplay {
  Run& run;
  std::uint32_t node;           ///< The shape's.
  std::vector<double> units{};  ///< In the order in which a derivation would draw.

  /// True if the draws select the same branches as those of the subtree. All subtrees compared by one replay must have
  /// the same key: they draw the same numbers as long as these select the same branches. O(depth of rules) for each
  /// draw not computed before.
  bool draws_match(const Subtree& subtree);
};

/// Adds a copy of the subtree at `shape` to the tables of the run.
///
/// Guarantees: vertices of the shape stay as they are, bit for bit; equal points stay equal; ids are those of a
/// derivation of the shape. Any other point has the same coordinates along the axes of the scope as in the subtree, to
/// 2^-40 m. O(size of the subtree).
void copy_subtree(Run& run, const Subtree& subtree, const Shape& shape);

}  // namespace citykiln::grammars
