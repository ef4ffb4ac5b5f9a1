// The syntax tree of one rule file, and the program that a file and its imports make, with all names resolved.
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

/// The kind of object that a name refers to. Expression::index is an index into the table given here.
enum class Target : std::uint8_t {
  kNone,
  kLocal,      ///< The slots of parameters and `with`.
  kAttribute,  ///< Program::attributes.
  kFunction,   ///< Program::functions.
  kBuiltin,    ///< functions.inc.
  kShape,      ///< shape_values.inc; ~0 for a material value.
  kWord        ///< A word of an operation, such as `x` in split(x).
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
  std::uint32_t slot = 0;  ///< The place of the value among the parameters and locals of a rule or function.
};

struct Branch;
struct Statement;

enum class BodyKind : std::uint8_t { kStatements, kCase, kChance };

/// The code after --> or after the colon of a selector.
struct Body {
  std::vector<Local> locals;  ///< The names defined by `with`.
  BodyKind kind = BodyKind::kStatements;
  std::vector<Statement> statements;
  std::vector<Branch> branches;  ///< The last may be `else`.
  std::uint32_t number = 0;      ///< The body's number, less than Program::bodies; each body has another one.
  // set by analyse_bodies()
  /// A statement of the body itself (not of a nested body) has selectors, so it makes several shapes.
  bool divides = false;
  bool changes_appearance = false;  ///< The rules that follow from the body may change the appearance.
  bool depends_on_street = false;   ///< The result may depend on which edges face a street.
  /// A part of the surface may stay where it is and keep its appearance: the wall around a window, for example.
  bool keeps_surface = false;
  /// Bit i: slot i (a parameter or local) may affect the displacement of the surface.
  std::uint64_t displacement_slots = 0;
};

struct Branch {
  TextPosition position;
  bool is_else = false;
  Expression test;  ///< A condition (kCase) or a percentage (kChance).
  Body body;
};

enum class SizeKind : std::uint8_t { kAbsolute, kRelative, kFloating, kRepeat };

/// One entry of { … | … }.
struct Selector {
  TextPosition position;
  SizeKind size = SizeKind::kAbsolute;
  Expression key;                ///< A size, or the name or index of a component.
  bool together = false;         ///< `=` instead of `:`. All selected components become one shape.
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
  std::vector<Body> block;    ///< kBlock: the one body of the block; else empty.
  std::uint32_t index = ~0u;  ///< kOperation: the row of operations.inc. kSuccessor: the rule, or ~0 for a terminal.
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
  bool is_constant = false;  ///< The value is one for all shapes of a derivation (constant.h).
};

/// An attr, which the caller and set() may change, or a const.
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

/// The syntax tree of one file. Names are not resolved.
struct SyntaxTree {
  std::vector<Import> imports;
  std::vector<Attribute> attributes;
  std::vector<Function> functions;
  std::vector<Rule> rules;
  std::string start;  ///< The rule marked @StartRule, else the first rule; "" if there is none.
};

/// The linked program that derive() runs. Plain data, constant during derivations.
struct Program {
  std::vector<std::string> files;
  std::vector<Attribute> attributes;
  std::vector<Function> functions;
  std::vector<Rule> rules;
  std::map<std::string, std::uint32_t, std::less<>> attribute_of, function_of, rule_of;
  std::string start;
  std::uint32_t bodies = 0;  ///< The number of bodies.
  bool is_shipped = false;   ///< All files are as the program ships them, whose faults tests find.
};

}  // namespace citykiln::grammars
