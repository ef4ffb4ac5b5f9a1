// The state of one node of a derivation, and the functions by which operations change it. A node is one application of
// a rule, or of the body of a selector, to a shape.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "grammars/derivation/run.h"

namespace citykiln::grammars {

/// A child that may be left out (details()), and its terminals.
struct DetailChild {
  IndexRange terminals;
  double left_out_m = 0;  ///< NodeTrace::left_out_m of the child.
};

/// A node while it is derived.
struct Execution {
  Run& run;
  Shape shape;  ///< The current shape, as changed by the operations until now.
  Slots slots;
  RandomSource random;
  int depth = 0;
  std::uint32_t path = 0;
  const std::string& name;  ///< The name of the rule.
  Displacement moved = {};  ///< The displacement from the surface at the start of the node to that of `shape`.
  /// CGA's stack: shapes saved by `[`, with the displacement at that time.
  std::vector<std::pair<Shape, Displacement>> pushed = {};
  SmallVector<ChildTrace, 4> children = {};  ///< Filled only if displacements are measured.
  VisibleAppearances seen = {};              ///< The appearances of all children.
  /// If displacements are measured, the shape before the first operation that divides or moves it.
  std::optional<Shape> start = {};
  bool vanished = true;  ///< No child has a surface until now.
  /// The number of groups of children: children that were cut from one shape (ChildTrace::group).
  std::uint32_t groups = 0;
  std::uint64_t child_count = 0;          ///< The ordinal of the next child.
  std::vector<DetailChild> details = {};  ///< Filled only if displacements are measured.
  double left_out_m = 0;                  ///< NodeTrace::left_out_m until now.
  bool pending = true;                    ///< `shape` has not been passed to a rule or a terminal yet.
};

/// A part cut from the current shape, and the body to apply to it.
struct Piece {
  Shape shape;
  const Body* body = nullptr;  ///< Null: the part is discarded.
  std::uint32_t left_out = 0;  ///< The number of pieces before this one that are left out but count in its ordinal.
};

/// Applies the bodies to the pieces: makes each piece a child of the node.
/// @param pieces  Their union is the surface of the current shape, moved by at most `moved`.
void spawn_pieces(Execution& execution, std::vector<Piece> pieces, Displacement moved = {});

/// An evaluated argument of an operation.
struct Argument {
  Value value = 0.0;
  bool relative = false;             ///< Written with ' in CGA: a share of the scope's size.
  const Expression* word = nullptr;  ///< A keyword or the name of an attribute, which is not evaluated; else null.
};
using Arguments = std::span<const Argument>;

/// Returns the number of an absolute argument, limited to ±kMost_m.
double metres(const Argument& argument);
inline constexpr double kMost_m = 1e6;

/// A function that applies an operation to the current shape.
using OperationFunction = void (*)(Execution&, const Statement&, Arguments);
/// Returns the function of a row of operation_table() (language/operation_table.h). The definition is in
/// operations/operations.cpp.
OperationFunction operation_function(std::uint32_t row);

/// Returns the vertices of the faces, or the corners of the scope of an asset.
Ring3 surface_points(const Shape& shape);

}  // namespace citykiln::grammars
