// The syntax tree of a rule file, and the program that rule files are linked to, with every name resolved.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "grammars/language/token.h"
#include "grammars/language/value.h"

namespace citykiln::grammars {

enum class ExpressionKind : std::uint8_t {
  kLiteral,    ///< value.
  kName,       ///< text.
  kCall,       ///< text(operands).
  kUnary,      ///< op and one operand.
  kBinary,     ///< op and two operands.
  kCase,       ///< operands: condition, value, condition, value, …, value of else.
  kChance,     ///< operands: per cent, value, per cent, value, …, value of else.
  kWithLocals  ///< operands: values of the locals, in slots from `index` on; then the value.
};

/// The operators of kUnary and kBinary.
enum class Operator : std::uint8_t {
  kNone,
  kNot,
  kNegate,
  kPlus,
  kShare,  ///< ' : a share of the scope's size.
  kOr,
  kAnd,
  kEqual,
  kNotEqual,
  kLess,
  kGreater,
  kLessOrEqual,
  kGreaterOrEqual,
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kRemainder
};

/// What a name refers to, and what Expression::index is an index into.
enum class Target : std::uint8_t {
  kNone,
  kLocal,      ///< The slots of parameters and `with`.
  kAttribute,  ///< Program::attributes.
  kFunction,   ///< Program::functions.
  kBuiltin,    ///< functions.inc.
  kShape,      ///< shape_values.inc; ~0 for a material value.
  kWord        ///< A word of an operation, as `x` in split(x).
};

struct Expression {
  ExpressionKind kind = ExpressionKind::kLiteral;
  Operator op = Operator::kNone;
  Target target = Target::kNone;
  std::uint32_t index = 0;
  TextPosition position;
  Value value = 0.0;
  std::string text;
  std::vector<Expression> operands;
};

/// A name defined by `with` or by a parameter list.
struct Local {
  std::string name;
  Expression value;
  std::uint32_t slot = 0;
};

struct Branch;
struct Statement;

enum class BodyKind : std::uint8_t { kStatements, kCase, kChance };

/// The code after --> or after the colon of a selector.
struct Body {
  std::vector<Local> locals;  ///< Of `with`.
  BodyKind kind = BodyKind::kStatements;
  std::vector<Statement> statements;
  std::vector<Branch> branches;  ///< The last may be `else`.
  std::uint32_t number = 0;      ///< Less than Program::bodies.
  // set by analyse_bodies()
  bool divides = false;                  ///< One of its own statements has selectors.
  bool changes_appearance = false;       ///< A descendant may change its appearance.
  bool depends_on_street = false;        ///< The result may depend on which edges face a street.
  std::uint64_t displacement_slots = 0;  ///< Bit i: slot i may affect how far the body moves a surface.
};

struct Branch {
  TextPosition position;
  bool is_else = false;
  Expression test;  ///< A condition, or per cent.
  Body body;
};

enum class SizeKind : std::uint8_t { kAbsolute, kRelative, kFloating, kRepeat };

/// One entry of { … | … }.
struct Selector {
  TextPosition position;
  SizeKind size = SizeKind::kAbsolute;
  Expression key;                ///< A size, or the name or index of a component.
  bool together = false;         ///< `=`: all selected components become one shape.
  std::vector<Selector> nested;  ///< The entries of a repeated group { … }*.
  Body body;
};

enum class StatementKind : std::uint8_t { kOperation, kSuccessor, kPush, kPop, kBlock };

struct Statement {
  StatementKind kind = StatementKind::kOperation;
  TextPosition position;
  std::string name;
  bool has_arguments = false;
  std::vector<Expression> arguments;
  bool has_selectors = false;
  bool repeated = false;  ///< A * after the selectors.
  std::vector<Selector> selectors;
  std::vector<Body> block;  ///< Of kBlock: one.
  std::uint32_t index =
      ~0u;  ///< Of an operation: the row of operations.inc; of a successor: the rule, ~0 for a terminal.
};

struct Rule {
  TextPosition position;
  std::string name;  ///< With its import's prefix: "window.Frame".
  std::vector<Local> parameters;
  Body body;
};

struct Function {
  TextPosition position;
  std::string name;
  std::vector<Local> parameters;
  Expression value;
  bool is_constant = false;  ///< Has the same value for every shape of a derivation (constant.h).
};

/// attr (the caller and set() may change it) or const.
struct Attribute {
  TextPosition position;
  std::string name;
  bool is_const = false;
  bool is_set = false;  ///< A rule changes it by set().
  Expression value;
};

struct Import {
  TextPosition position;
  std::string prefix;  ///< "" for none.
  std::string file;
};

/// One file, names not resolved yet.
struct SyntaxTree {
  std::vector<Import> imports;
  std::vector<Attribute> attributes;
  std::vector<Function> functions;
  std::vector<Rule> rules;
  std::string start;  ///< The rule marked @StartRule, else the first rule; "" if there is none.
};

/// All that a derivation needs of the rule files. Plain data, constant during derivations.
struct Program {
  std::vector<std::string> files;
  std::vector<Attribute> attributes;
  std::vector<Function> functions;
  std::vector<Rule> rules;
  std::map<std::string, std::uint32_t, std::less<>> attribute_of, function_of, rule_of;
  std::string start;
  std::uint32_t bodies = 0;  ///< The number of bodies.
};

}  // namespace citykiln::grammars
