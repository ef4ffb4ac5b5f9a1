// The state of one derivation, and of one of its nodes. Used by this folder and by operations/.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/draw.h"
#include "grammars/derivation/derive.h"
#include "grammars/derivation/displacement.h"
#include "grammars/derivation/displacement_bound.h"
#include "grammars/derivation/memo.h"
#include "grammars/shapes/small_vector.h"
#include "grammars/shapes/tables.h"

namespace citykiln::grammars {

/// A source of random numbers for one purpose: of one shape, where the index counts the numbers drawn by that shape, or
/// of an attribute, which belongs to the building.
struct RandomSource {
  const char* purpose = "rule";
  std::uint32_t next = 0;
  bool of_shape = true;
  std::uint32_t node = 0;  ///< The shape's.
};

/// The values of parameters and locals.
using Slots = SmallVector<Value, 4>;

/// A path by the address of the rule's name, which differs between occurrences of the name in the program.
struct KnownPath {
  const std::string* name = nullptr;
  std::uint32_t path = 0;
  std::uint32_t next = 0;  ///< 1 + index into Run::known_paths of the next with the same parent; 0 for the last.
};

/// The value of a constant function, and the steps to evaluate it.
struct ConstantValue {
  Value value;
  std::uint64_t steps = 0;
};

struct Run {
  const Program& program;
  const DeriveOptions& options;
  const Shape& initial;
  Derivation out = {};
  Tables tables = {};
  std::vector<TerminalOrigin> origins = {};  ///< By terminal.
  std::vector<DerivationNode> nodes = {};    ///< One for each shape; the first is that of the start.
  std::vector<StableId> ids = {};            ///< By node; 0 until it is needed.
  std::vector<std::uint32_t> appearances_in_out =
      {};                                        ///< By Tables::appearances: 1 + index into Derivation::appearances.
  std::vector<std::uint32_t> report_nodes = {};  ///< By report.
  std::vector<std::optional<Value>> attributes = {};         ///< Values at the start, evaluated on first use.
  std::vector<bool> attribute_under_way = {};                ///< To detect an attribute that depends on itself.
  std::vector<std::optional<ConstantValue>> constants = {};  ///< By function; evaluated on first use.
  /// Steps spent on attributes. They are charged to no node, since they belong to whichever node asked first.
  std::uint64_t attribute_steps = 0;
  std::map<std::pair<std::string, std::string>, Warning> warnings = {};  ///< By position and text.
  std::uint64_t warnings_raised = 0;
  std::vector<KnownPath> known_paths = {};
  std::vector<std::uint32_t> first_below =
      {};  ///< By path: 1 + index of its newest child in `known_paths`; 0 for none.
  Memo memo = {};
  std::vector<RandomDraw> draws = {};  ///< Draws of shapes, recorded while a node may become a memo entry.
  BoundTable bounds = {};

  /// The id of a node, computed on first use, since most nodes never need theirs.
  StableId id_of(std::uint32_t node);
  /// Notes that the nodes under way depend on something assigned at node `since_node` and inherited from there. Nodes
  /// that begin at `since_node` or later do not become memo entries. 0 for what no two shapes share: random numbers,
  /// the position, neighbours, messages.
  void depends_on(std::uint32_t since_node);
  /// Notes that the nodes under way depend on this draw, and only through the interval it lies in.
  void record_draw(const RandomDraw& draw);
  /// True if displacements are measured. Without a tolerance nothing uses them.
  bool measures() const { return options.tolerance_m > 0; }
  void warn(TextPosition position, const std::string& message);
  /// Counts steps; false once the limit is passed.
  bool spend(std::uint64_t steps);
  void hit(LimitKind kind, const std::string& rule, TextPosition position);
  /// @param rule  Part of the program, which outlives the run.
  std::uint32_t path(std::uint32_t parent, const std::string& rule);
  void add_path(std::uint32_t parent, const std::string& rule);
  /// The index of an appearance of the tables in Derivation::appearances, where it is added if it is new.
  std::uint32_t appearance_index(std::uint32_t appearance);
};

/// A node under way: a rule, or the body of a selector, applied to a shape.
struct Execution {
  Run& run;
  Shape shape;  ///< As the operations so far have left it.
  Slots slots;
  RandomSource random;
  int depth = 0;
  std::uint32_t path = 0;
  const std::string& name;  ///< The name of the rule.
  Displacement moved = {};  ///< From the surface at the start of the node to that of `shape`.
  std::vector<std::pair<Shape, Displacement>> pushed = {};
  SmallVector<ChildTrace, 4> children = {};  ///< If displacements are measured.
  VisibleAppearances seen = {};              ///< Of all children.
  std::optional<Shape> start = {};  ///< The shape before the first operation that divides or moves it, if measured.
  bool vanished = true;             ///< No child has a surface.
  std::uint32_t groups = 0;         ///< The number of groups of children (ChildTrace::group).
  std::uint64_t child_count = 0;    ///< The ordinal of the next child.
  bool pending = true;              ///< `shape` has no successor yet.
};

/// A part taken out of the current shape, and the body applied to it; null for none, which discards the part.
struct Piece {
  Shape shape;
  const Body* body = nullptr;
  std::uint32_t left_out = 0;  ///< Pieces before it that are not made; its ordinal counts them.
};

/// Applies the bodies to the pieces. The union of the pieces has to be the surface of the current shape, moved by at
/// most `moved`.
void spawn_pieces(Execution& execution, std::vector<Piece> pieces, Displacement moved = {});

/// An evaluated argument of an operation.
struct Argument {
  Value value = 0.0;
  bool relative = false;             ///< Written with ': a share of the scope's size.
  const Expression* word = nullptr;  ///< A word or the name of an attribute, which is not evaluated.
};
using Arguments = std::span<const Argument>;

/// The argument as a number, limited to ±kMost_m.
double metres(const Argument& argument);
inline constexpr double kMost_m = 1e6;

/// What carries out an operation on the current shape.
using OperationFunction = void (*)(Execution&, const Statement&, Arguments);
/// The function of a row of operation_table(). Defined in operations/operations.cpp: this folder declares what it
/// calls, and operations/ includes this folder, so that includes run one way.
OperationFunction operation_function(std::uint32_t row);

/// The vertices of the faces, or the corners of the scope of an asset.
Ring3 surface_points(const Shape& shape);

}  // namespace citykiln::grammars
