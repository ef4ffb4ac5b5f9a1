// The state of one derivation. Its nodes have a state of their own while they are derived (execution.h).
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "compiler/contract/random_sequence.h"
#include "grammars/derivation/derive.h"
#include "grammars/derivation/displacement.h"
#include "grammars/derivation/displacement_bound.h"
#include "grammars/derivation/memo.h"
#include "grammars/shapes/small_vector.h"
#include "grammars/shapes/tables.h"

namespace citykiln::grammars {

/// A source of random numbers for one shape, or for an attribute of the building.
struct RandomSource {
  const char* purpose = "rule";  ///< Part of the seed: sources with different purposes are independent.
  std::uint32_t next = 0;
  bool of_shape = true;    ///< True: the numbers belong to a shape. False: to an attribute of the building.
  std::uint32_t node = 0;  ///< The node of the shape.
};

/// The values of a rule's parameters, followed by its locals. A slot is the place of one of them.
using Slots = SmallVector<Value, 4>;

/// A path (an index into Derivation::paths: the rule names from the start to a node), found by the address of its last
/// rule name. Each occurrence of the name in the program has another address.
struct KnownPath {
  const std::string* name = nullptr;
  std::uint32_t path = 0;
  std::uint32_t next = 0;  ///< 1 + index into Run::known_paths of the next path with this parent; 0 for the last.
};

/// The value of a constant function, and the number of steps that its evaluation takes.
struct ConstantValue {
  Value value;
  std::uint64_t steps = 0;
};

/// The state of one derivation.
struct Run {
  const Program& program;
  const DeriveOptions& options;
  const Shape& initial;
  Derivation out = {};
  Tables tables = {};
  std::vector<TerminalOrigin> origins = {};  ///< By terminal of `out`.
  std::vector<DerivationNode> nodes = {};    ///< One for each shape; the first is the start's.
  std::vector<StableId> ids = {};            ///< By node; 0 until computed.
  std::vector<std::uint32_t> appearances_in_out =
      {};                                        ///< By Tables::appearances: 1 + index into Derivation::appearances.
  std::vector<std::uint32_t> report_nodes = {};  ///< By report: the node that made it.
  std::vector<std::optional<Value>> attributes = {};  ///< Values at the start, evaluated on first use.
  /// True while an attribute is evaluated, to detect one that depends on itself.
  std::vector<bool> attribute_under_way = {};
  std::vector<std::optional<ConstantValue>> constants = {};  ///< By function; evaluated on first use.
  /// Steps spent on attributes. They are charged to no node: which node evaluates an attribute first is arbitrary.
  std::uint64_t attribute_steps = 0;
  std::map<std::pair<std::string, std::string>, Warning> warnings = {};  ///< By position and text.
  std::uint64_t warnings_raised = 0;
  std::uint64_t depth_hits = 0;   ///< Shapes that the depth limit ended.
  std::uint64_t value_begin = 0;  ///< `out.steps` when the value that is being evaluated began.
  bool is_value_too_long = false;
  double merged_m = 0;  ///< The largest error of a split that merged narrow pieces.
  std::vector<KnownPath> known_paths = {};
  /// By path: 1 + index of its newest child in `known_paths`; 0 for none.
  std::vector<std::uint32_t> first_below = {};
  Memo memo = {};
  std::vector<RandomDraw> draws = {};  ///< Draws of shapes, recorded while a node may become a memo entry.
  BoundTable bounds = {};
  bool is_in_element = false;  ///< All detail is derived, whatever the tolerance.

  /// Returns the id of a node, computed on first use, since most nodes never need theirs.
  StableId id_of(std::uint32_t node);
  /// Excludes nodes from memoisation (memo.h) that depend on a value: open nodes with a number of `since_node` or more.
  /// @param since_node  The node that assigned the value, which its descendants inherited. 0 stands for values that no
  /// two shapes share: random numbers, the position, neighbours, messages.
  void depends_on(std::uint32_t since_node);
  /// Records that the nodes being derived depend on a random number, but only on the interval in which it lies.
  void record_draw(const RandomDraw& draw);
  /// True if displacements are measured, which only a tolerance requires, and no element.
  bool measures() const { return options.tolerance_m > 0 && !is_in_element; }
  /// Adds a warning, or counts it again if its position and text are known.
  void warn(TextPosition position, const std::string& message);
  /// Adds to the number of steps. Returns false once the limit of steps is passed.
  bool spend(std::uint64_t steps);
  /// Records that a limit ended a shape.
  void hit(LimitKind kind, const std::string& rule, TextPosition position);
  /// Returns the path of a rule below a parent, and adds it if it is new.
  /// @param rule  Part of the program, which outlives the run.
  std::uint32_t path(std::uint32_t parent, const std::string& rule);
  /// Adds a path, as path() does for one that is new.
  void add_path(std::uint32_t parent, const std::string& rule);
  /// Returns the index of an appearance in Derivation::appearances, and adds it if it is new.
  /// @param appearance  An index into Tables::appearances.
  std::uint32_t appearance_index(std::uint32_t appearance);
};

}  // namespace citykiln::grammars
