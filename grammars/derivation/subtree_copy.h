// Copies the result of a derived node to another shape, which differs from the node's shape only by a rigid motion:
// copy_subtree(). A node is one application of a rule to a shape. The tables of the run (Run) hold the nodes,
// terminals, textures and random draws of all nodes, one in each row.
//
//   A ── split ──┬── B ── …   The rows of a node and its descendants are consecutive. So a derived subtree is stored as
//                └── C ── …   ranges of rows, and a copy appends these rows, moved by the rigid motion.
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

/// A random number drawn for a shape to select one of a few branches of a rule.
struct RandomDraw {
  std::uint32_t node = 0;    ///< The node of the shape for which the number is drawn.
  std::uint32_t index = 0;   ///< The index passed to RandomSequence::unit().
  double scale = 1;          ///< The factor by which the rule multiplies the number.
  double low = 0, high = 0;  ///< low <= number · scale < high. Every number in this interval selects the same branch.
};

/// The data of a terminal that only the derivation needs.
struct TerminalOrigin {
  std::uint32_t node = 0;
  std::uint32_t texture = 0;  ///< Index into Tables::textures.
  /// Index into Tables::appearance_areas: the area of each appearance in the detail that a simplified terminal
  /// replaces; 0 for a terminal that is not simplified.
  std::uint32_t replaced_areas = 0;
};

/// Terminals that were removed from the derivation when their node was simplified, but that stored subtrees still need
/// for copies.
struct RemovedTerminals {
  std::size_t first = 0;  ///< The index in Derivation::terminals that the first of these terminals had.
  std::vector<Terminal> terminals;
  std::vector<TerminalOrigin> origins;
};

/// The indices from `first` up to but not including `end`.
struct IndexRange {
  std::size_t first = 0, end = 0;
  std::size_t size() const { return end - first; }
};

/// The rows that a node and its descendants added to the tables of the run, with their sums.
struct SubtreeRows {
  IndexRange terminals, nodes, reports, textures, draws;
  std::uint64_t shapes = 0, steps = 0;  ///< The numbers of shapes and steps that count towards Limits.
  int nested_rules = 0;                 ///< The greatest number of nested rules below the node.
  NodeTrace trace;  ///< The displacement between the node's surface and its result, and the result's appearances.
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

/// A derived node that can be copied.
struct Subtree {
  ShapePose pose;    ///< The pose of the node's shape before its rule was applied.
  SubtreeRows made;  ///< The rows to copy.
  /// 0 if the terminals are still in the derivation; else 1 + the index of their copy in Memo::removed.
  std::uint32_t removed = 0;
};

/// The random numbers that would be drawn if a shape were derived instead of copied. They decide whether a derived
/// subtree has the right branches. A number is computed at its first comparison.
struct DrawReplay {
  Run& run;
  std::uint32_t node;           ///< The node of the shape that may be derived or copied.
  std::vector<double> units{};  ///< The numbers in [0, 1), in the order in which a derivation would draw them.

  /// True if the numbers select the branches that the subtree has. O(depth of rules) for each number that is not
  /// computed yet.
  /// @param subtree  All subtrees of one replay must have equal memo keys (memo.h): up to the first number that selects
  /// another branch, their derivations draw for the same nodes.
  bool draws_match(const Subtree& subtree);
};

/// Adds a copy of the subtree, moved to the pose of `shape`, to the tables of the run.
/// @param shape  Has one face, which differs from the subtree's first face only by a rigid motion.
///
/// Guarantees: vertices of the shape are unchanged, bit for bit; equal points stay equal; ids are equal to the ids that
/// a derivation of the shape would give. Other points keep their coordinates along the axes of the scope to 2^-40 m.
/// O(size of the subtree).
void copy_subtree(Run& run, const Subtree& subtree, const Shape& shape);

}  // namespace citykiln::grammars
