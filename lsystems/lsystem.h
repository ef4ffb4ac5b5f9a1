// An L-system as it is run: modules are numbers, productions and expressions are rows of flat arrays.
//
//   A(l,w) : l > 0.1 -> !(w)F(l)[&(45)A(l*0.6,w)]A(l*0.9,w)       one Rule: predecessor, condition, successor
//   └pred┘   └cond─┘    └kinds: ! F [ & A ] A ; values: w l 45 l*0.6 w l*0.9 w
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/geometry/vec.h"

namespace citykiln::lsystems {

/// A character of a file.
struct TextPosition {
  std::uint32_t line = 0;    ///< From 1.
  std::uint32_t column = 0;  ///< From 1, in bytes.
};

/// Into LSystem::kinds. Modules of one name with different numbers of parameters are different kinds, as in the book.
using Kind = std::uint16_t;

/// What the turtle does at a module.
enum class TurtleOp : std::uint8_t {
#define SYMBOL(name, op, text) op,
#include "lsystems/turtle_symbols.inc"
#undef SYMBOL
  kNone,
  kInstance,       ///< ~X
  kQueryPosition,  ///< ?P(x,y,z)
  kQueryHeight,    ///< ?H(h)
  kQueryShade,     ///< ?S(s)
};

struct ModuleKind {
  std::string name;  ///< "F", "+", "~L", "?H", "internode".
  std::uint8_t arity = 0;
  TurtleOp op = TurtleOp::kNone;
  bool ignored = false;  ///< Contexts look past it.
};

enum class Op : std::uint8_t {
  kConstant,
  kSlot,
#define OPERATOR(name, priority, text, code) name,
#define FUNCTION(name, arity, op, code) op,
#include "lsystems/operations.inc"
#undef FUNCTION
#undef OPERATOR
  kNegative,
  kNot,
  kRandom,        ///< ran(x)
  kNormalRandom,  ///< nran(mean, deviation)
};

/// One step of an expression in postfix order.
struct Instruction {
  Op op = Op::kConstant;
  std::uint16_t slot = 0;  ///< Of kSlot.
  double constant = 0;     ///< Of kConstant.
};

/// The commonest shapes of a value are spelled out, so that most modules run no code.
enum class ValueForm : std::uint8_t { kConstant, kSlot, kSlotTimes, kSlotPlus, kCode };

/// A number of a successor, a condition or a probability.
struct Value {
  ValueForm form = ValueForm::kConstant;
  std::uint16_t slot = 0;
  double constant = 0;
  std::uint32_t first = 0, count = 0;  ///< Of kCode: into LSystem::code.
  TextPosition place;
};

/// A run of rows in one of LSystem's arrays.
struct Range {
  std::uint32_t first = 0, count = 0;
};

/// Modules with their numbers: the axiom, or what a rule makes.
struct Successor {
  Range kinds;             ///< Into LSystem::successor_kinds.
  Range values;            ///< Into LSystem::values: those of all modules in turn.
  std::uint32_t code = 0;  ///< Instructions that its values run.
};

struct Rule {
  TextPosition place;
  Kind predecessor = 0;
  Range left, right;  ///< Into LSystem::contexts, in the order written. `right` may hold brackets.
  bool has_condition = false, has_probability = false;
  Value condition, probability;
  Successor successor;
  /// Slots are given to the left context's parameters, then the predecessor's, then the right context's.
  std::uint16_t predecessor_slot = 0, right_slot = 0, slots = 0;
};

/// Rules that are tried together: in parallel on a whole string.
struct RuleSet {
  std::vector<Rule> rules;     ///< By predecessor; those of one predecessor in the file's order.
  std::vector<Range> of_kind;  ///< Into `rules`, one row a kind.
  bool has_contexts = false;
  int most_depth = 1;  ///< How often the set is applied to what it made: decomposition and interpretation.
};

/// A system, read. Plain data; never changes while one derives.
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
  Kind push = 0, pop = 0, cut = 0;  ///< [ ] %, always there.
  bool has_cuts = false;            ///< Some rule writes %.
  bool has_queries = false;

  // what directives say
  int steps = 0;
  std::uint64_t seed = 0;
  double angle_deg = 90;  ///< Of + - & ^ \ / without a number.
  double step = 1;        ///< Of F f G without a number.
  double width = 0.1;     ///< Where the turtle begins.
  double width_unit = 1;  ///< What a width of 1 is in lengths.
  Vec3 tropism;           ///< {0, 0, -1} is gravity.
  double elasticity = 0;  ///< Radians a segment turns that stands square to the tropism.
  double height = 0;      ///< The grown plant is scaled to be as high; 0: it stays as it is.
  std::string bark;       ///< What stems are covered by: a name for whoever draws them; or none.
};

}  // namespace citykiln::lsystems
