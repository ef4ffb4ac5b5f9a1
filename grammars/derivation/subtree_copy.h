// Patterns: what a node made, ready to be made again of a shape that is the same but for a motion.
//
//   A ── split ──┬── B ── …   births, terminals, textures and throws of a node stand in a row in the tables of the run,
//                └── C ── …   so a pattern is where its rows begin and end, and a copy is those rows, moved.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "grammars/derivation/derive.h"
#include "grammars/derivation/displacement.h"

namespace citykiln::grammars {

struct Run;

/// How a shape came about: the `ordinal`-th child, called `name`, of the shape `parent`.
struct DerivationNode {
  std::uint32_t parent = 0;  ///< Into Run::births.
  const char* name = "";     ///< Lives in the program.
  std::uint64_t ordinal = 0;
};

/// A throw of a shape's dice that decided between a few ways to go on.
struct RandomDraw {
  std::uint32_t birth = 0;   ///< The shape's; into Run::births.
  std::uint32_t index = 0;   ///< Of Draw::unit().
  double scale = 1;          ///< What the number was multiplied by.
  double low = 0, high = 0;  ///< low <= number · scale < high: whatever lies there leads the same way.
};

/// What is known of a terminal beyond what the caller hears.
struct TerminalNote {
  std::uint32_t birth = 0;       ///< Into Run::births.
  std::uint32_t texture = 0;     ///< Into Tables::textures.
  std::uint32_t stands_for = 0;  ///< Into Tables::appearance_areas: of one that was cut, what its detail looks like.
};

/// Terminals that were cut away, but may be made again elsewhere: all from `first` on, as they were numbered.
struct RemovedTerminals {
  std::size_t first = 0;
  std::vector<Terminal> terminals;
  std::vector<TerminalNote> notes;
};

/// Indices from `first` to before `end`.
struct IndexRange {
  std::size_t first = 0, end = 0;
  std::size_t size() const { return end - first; }
};

/// What a node made, in the tables of the run.
struct SubtreeRows {
  IndexRange terminals, nodes, reports, textures, throws;
  std::uint64_t shapes = 0, steps = 0;
  int rules_in_each_other = 0;  ///< Below the node's own.
  NodeTrace trace;
};

/// Where a shape of one face stands: what a motion takes to another.
struct ShapePose {
  Ring3 ring;  ///< Of the face.
  Vec3 origin;
  std::array<Vec3, 3> axis;
  std::uint32_t birth = 0, texture = 0, projection = 0;  ///< As Shape's.
};
ShapePose pose_of(const Shape& shape);

struct Subtree {
  ShapePose stand;
  SubtreeRows made;
  std::uint32_t cut_away = 0;  ///< 1 + where Memo::cut_away has its terminals; 0 while they are Derivation's.
};

/// The throws of the descendants of one shape, each made when it is asked for.
struct DrawReplay {
  Run& run;
  std::uint32_t birth;          ///< The shape's.
  std::vector<double> units{};  ///< Of Draw, in the order in which a derivation would ask.

  /// True if they fall as those of the pattern's shape did. Of patterns of one kind only: they ask for the same dice
  /// as long as those fall alike. O(depth of rules) for a throw that no pattern before has asked for.
  bool draws_match(const Subtree& pattern);
};

/// Makes the pattern again of `shape`, into the tables of the run.
///
/// Guarantees: vertices of the shape stay as they are, bit for bit; points that were one are one; ids are those of
/// descent. Any other point lies as far from the scope's origin, along its axes, as in the pattern, to 2^-40 m. O(what
/// it makes).
void copy_subtree(Run& run, const Subtree& pattern, const Shape& shape);

}  // namespace citykiln::grammars
