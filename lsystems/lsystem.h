// A compiled L-system: modules are numbers, productions and expressions are rows of flat arrays. A slot is the place of
// a parameter of a rule.
//
//   A(l,w) : l > 0.1 -> !(w)F(l)[&(45)A(l*0.6,w)]A(l*0.9,w)       one Rule: predecessor, condition, successor
//   └pred┘   └cond─┘    └kinds: ! F [ & A ] A ; values: w l 45 l*0.6 w l*0.9 w
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/geometry/vec.h"

namespace citykiln::lsystems {

/// A position in a file.
struct TextPosition {
  std::uint32_t line = 0;    ///< From 1.
  std::uint32_t column = 0;  ///< From 1, in bytes.
};

/// Index into LSystem::kinds. Modules of one name with different numbers of parameters are different kinds.
using Kind = std::uint16_t;

/// The turtle's operation for a module.
enum class TurtleOp : std::uint8_t {
#define SYMBOL(name, op, text) op,
#include "lsystems/turtle_symbols.inc"
  kNone,
  kInstance,       ///< ~X
  kQueryPosition,  ///< ?P(x,y,z)
  kQueryHeight,    ///< ?H(h)
  kQueryShade,     ///< ?S(s)
};

/// A kind of modules: a name with a number of parameters.
struct ModuleKind {
  std::string name;  ///< "F", "+", "~L", "?H", "internode".
  std::uint8_t arity = 0;
  TurtleOp op = TurtleOp::kNone;
  bool ignored = false;  ///< Contexts skip the module.
};

enum class Op : std::uint8_t {
  kConstant,
  kSlot,
#define OPERATOR(name, priority, text, code) name,
#define FUNCTION(name, arity, op, code) op,
#include "lsystems/operations.inc"
  kNegative,
  kNot,
  kRandom,        ///< ran(x)
  kNormalRandom,  ///< nran(mean, deviation)
};

/// An instruction of an expression in postfix order.
struct Instruction {
  Op op = Op::kConstant;
  std::uint16_t slot = 0;  ///< kSlot: the number of the slot.
  double constant = 0;     ///< kConstant: its value.
};

/// The form of a value. Common forms are evaluated without code.
enum class ValueForm : std::uint8_t { kConstant, kSlot, kSlotTimes, kSlotPlus, kCode };

/// An expression: a parameter of a successor's module, a condition or a probability.
struct Value {
  ValueForm form = ValueForm::kConstant;
  std::uint16_t slot = 0;
  double constant = 0;
  std::uint32_t first = 0, count = 0;  ///< kCode: the range in LSystem::code.
  TextPosition place;
};

/// A range of one of LSystem's arrays.
struct Range {
  std::uint32_t first = 0, count = 0;
};

/// Modules with their parameters: the axiom, or a rule's successor.
struct Successor {
  Range kinds;             ///< Into LSystem::successor_kinds.
  Range values;            ///< Into LSystem::values, in the order of the modules.
  std::uint32_t code = 0;  ///< The number of instructions of its values.
};

/// A production: predecessor, contexts, condition or probability, and successor.
struct Rule {
  TextPosition place;
  Kind predecessor = 0;
  Range left, right;  ///< Into LSystem::contexts, in the file's order. `right` may contain brackets.
  bool has_condition = false, has_probability = false;
  Value condition, probability;
  Successor successor;
  /// Slots hold the parameters of the left context, of the predecessor, and of the right context, in this order.
  std::uint16_t predecessor_slot = 0, right_slot = 0, slots = 0;
};

/// Rules that rewrite a string in parallel.
struct RuleSet {
  std::vector<Rule> rules;     ///< Sorted by predecessor, then in the file's order.
  std::vector<Range> of_kind;  ///< Into `rules`, for each kind.
  bool has_contexts = false;
  int most_depth = 1;  ///< The number of passes over its own output, for decomposition and interpretation.
};

/// The result of read_lsystem(). Plain data, constant during derivations.
struct LSystem {
  std::string file;
  std::vector<ModuleKind> kinds;
  std::vector<Kind> successor_kinds;
  std::vector<Kind> contexts;
  std::vector<Value> values;
  std::vector<Instruction> code;
  Successor axiom;
  TextPosition axiom_place;
  RuleSet productions, decomposition, interpretation;
  Kind push = 0, pop = 0, cut = 0;  ///< The kinds of [ ] %, which are always present.
  bool has_queries = false;         ///< The axiom or a rule contains a query.

  // directives
  int steps = 0;
  std::uint64_t seed = 0;
  double angle_deg = 90;  ///< The default angle of + - & ^ \ /.
  double step = 1;        ///< The default length of F f G.
  double width = 0.1;     ///< The initial width.
  double width_unit = 1;  ///< The length of a width of 1.
  Vec3 tropism;           ///< The direction to which segments turn, of any length; {0, 0, -1} is gravity.
  double elasticity = 0;  ///< The turtle turns by elasticity · |heading × tropism| radians after each segment.
  double height = 0;      ///< The height to which the plant is scaled; 0: no scaling.
  std::string bark;       ///< The name of a bark material for the renderer, or empty.
};

}  // namespace citykiln::lsystems
