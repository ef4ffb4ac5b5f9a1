// The state of one derivation, and of one node of it. Inside of this room only.
#pragma once

#include <map>
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

/// Chance for one purpose: of one shape, where the index counts what the shape itself has drawn, or of an attribute,
/// which is the building's.
struct RandomSource {
  const char* purpose = "rule";
  std::uint32_t next = 0;
  bool of_shape = true;
  std::uint32_t birth = 0;  ///< Of the shape.
};

/// By slot.
using Frame = SmallVector<Value, 4>;

/// A path, by the name that led there: of equal names that stand in several places of the program each is known.
struct KnownPath {
  const std::string* name = nullptr;
  std::uint32_t path = 0;
  std::uint32_t next = 0;  ///< Of the same parent: 1 + where Run::known_paths has it; 0 for the last.
};

/// What a function of attributes alone is worth, and the steps to find that out.
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
  std::vector<TerminalNote> notes = {};               ///< By terminal.
  std::vector<DerivationNode> nodes = {};             ///< By shape; the start's first.
  std::vector<StableId> ids = {};                     ///< By birth; 0 where nobody has asked for it yet.
  std::vector<std::uint32_t> looks_in_out = {};       ///< By look: 1 + where Derivation::looks has it; 0 for nowhere.
  std::vector<std::uint32_t> report_births = {};      ///< By report: whose it is.
  std::vector<std::optional<Value>> attributes = {};  ///< Values at the start, each made when first asked for.
  std::vector<bool> attribute_under_way = {};
  std::vector<std::optional<ConstantValue>> constants = {};  ///< By function; each made when first asked for.
  std::uint64_t attribute_steps = 0;  ///< Spent on them: whoever asks first pays, so they are nobody's.
  std::map<std::pair<std::string, std::string>, Warning> warnings = {};  ///< By place and text.
  std::uint64_t troubles_told = 0;
  std::vector<KnownPath> known_paths = {};
  std::vector<std::uint32_t> first_below = {};  ///< By path: 1 + the newest of `known_paths` below it; 0 for none.
  Memo memo = {};
  std::vector<RandomDraw> throws = {};  ///< Of shapes' dice, where a node under way may become a pattern.
  BoundTable reaches = {};

  /// Most shapes are never asked for theirs, so ids are made when they are.
  StableId id_of(std::uint32_t birth);
  /// What a node under way asked for was given to the shape born as `since`, from which it inherits: nodes whose shapes
  /// were born then or later are no patterns. 0 for what no two shapes share: chance, the place, neighbours.
  void depends_on(std::uint32_t since);
  /// What comes of the shape's dice depends on this throw, and on no more of it than that.
  void record_draw(const RandomDraw& thrown);
  /// Without a tolerance nobody asks how far surfaces move.
  bool measures() const { return options.tolerance_m > 0; }
  void warning(TextPosition place, const std::string& message);
  /// Counts steps; false once there are too many.
  bool spend(std::uint64_t steps);
  void hit(LimitKind kind, const std::string& rule, TextPosition place);
  /// @param rule  Has to live in the program.
  std::uint32_t path(std::uint32_t parent, const std::string& rule);
  void add_path(std::uint32_t parent, const std::string& rule);
  /// Where Derivation::looks has this look of the tables.
  std::uint32_t appearance_index(std::uint32_t look);
};

/// What a node tells its parent.
struct Outcome {
  NodeTrace trace;
};

/// One node under way: a rule, or the statements behind a selector, applied to a shape.
struct Execution {
  Run& run;
  Shape shape;  ///< As the operations so far have left it.
  Frame frame;
  RandomSource dice;
  int depth = 0;
  std::uint32_t path = 0;
  const std::string& name;  ///< Of the shape: the rule's.
  Displacement moved = {};  ///< From the node's surface to shape's.
  std::vector<std::pair<Shape, Displacement>> pushed = {};
  SmallVector<ChildTrace, 4> children = {};  ///< Where surfaces are measured.
  VisibleAppearances seen = {};              ///< Of all children.
  std::optional<Shape> start = {};  ///< As it was before anything divided or moved it, where surfaces are measured.
  bool vanished = true;             ///< All children have.
  std::uint32_t groups = 0;
  std::uint64_t born = 0;  ///< Ordinal of the next child.
  bool pending = true;     ///< No successor has been made of the shape as it is now.
};

/// A shape taken out of the current one, with what becomes of it. `body` null: nothing.
struct Piece {
  Shape shape;
  const Body* body = nullptr;
  std::uint32_t left_out = 0;  ///< How many before it are not made: it is numbered as if they were.
};

/// Hands the pieces to their bodies. Together they have to cover the current shape's surface, but for `moved`.
void spawn_pieces(Execution& execution, std::vector<Piece> pieces, Displacement moved = {});

/// The evaluated argument of an operation.
struct Argument {
  Value value = 0.0;
  bool relative = false;             ///< Written with ': a share of the scope's size.
  const Expression* word = nullptr;  ///< A word or settable name, not evaluated.
};

/// Numbers of operations, kept within what a city can hold.
double metres(const Argument& argument);
inline constexpr double kMost_m = 1e6;

}  // namespace citykiln::grammars
