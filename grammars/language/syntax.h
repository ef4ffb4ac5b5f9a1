// A rule file as a tree, and a program: rule files put together, with every name resolved.
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
  kUnary,      ///< text is - ! or ' (a share of the scope's size).
  kBinary,     ///< text is an operator.
  kCase,       ///< operands: condition, value, condition, value, …, value of else.
  kChance,     ///< operands: per cent, value, per cent, value, …, value of else.
  kWithLocals  ///< operands: values of the locals, in slots from `index` on; then the value.
};

/// What a name stands for; `index` is into what the comment names.
enum class Target : std::uint8_t {
  kNone,
  kLocal,      ///< The frame: parameters and `with`.
  kAttribute,  ///< Program::attributes.
  kFunction,   ///< Program::functions.
  kBuiltin,    ///< functions.inc.
  kShape,      ///< shape_values.inc.
  kWord        ///< A word of an operation, as `x` in split(x).
};

struct Expression {
  ExpressionKind kind = ExpressionKind::kLiteral;
  TextPosition place;
  Value value = 0.0;
  std::string text;
  std::vector<Expression> operands;
  Target target = Target::kNone;
  std::uint32_t index = 0;
};

/// A name that `with` or a parameter list gives.
struct Local {
  std::string name;
  Expression value;
  std::uint32_t slot = 0;
};

struct Branch;
struct Statement;

enum class BodyKind : std::uint8_t { kStatements, kCase, kChance };

/// What stands behind --> or a selector's colon.
struct Body {
  std::vector<Local> locals;  ///< Of `with`.
  BodyKind kind = BodyKind::kStatements;
  std::vector<Statement> statements;
  std::vector<Branch> branches;          ///< The last may be `else`.
  std::uint32_t number = 0;              ///< Of the program's bodies.
  bool divides = false;                  ///< Divides a surface itself (body_marks.h).
  bool changes_appearance = false;       ///< Something that comes of it may look otherwise.
  bool depends_on_street = false;        ///< What comes of it may depend on where the street runs.
  std::uint64_t displacement_slots = 0;  ///< By slot, a bit each: arguments that may change how far it moves a surface.
};

struct Branch {
  TextPosition place;
  bool is_else = false;
  Expression test;  ///< A condition, or per cent.
  Body body;
};

enum class SizeKind : std::uint8_t { kAbsolute, kRelative, kFloating, kRepeat };

/// One entry of { … | … }: for whom, and what becomes of it.
struct Selector {
  TextPosition place;
  SizeKind size = SizeKind::kAbsolute;
  Expression key;                ///< A size, a component's name or its index.
  bool together = false;         ///< `=`: all that it selects is one shape.
  std::vector<Selector> nested;  ///< Of a repeated group { … }*.
  Body body;
};

enum class StatementKind : std::uint8_t { kOperation, kSuccessor, kPush, kPop, kBlock };

struct Statement {
  StatementKind kind = StatementKind::kOperation;
  TextPosition place;
  std::string name;
  bool has_arguments = false;
  std::vector<Expression> arguments;
  bool has_selectors = false;
  bool repeated = false;  ///< A * behind the selectors.
  std::vector<Selector> selectors;
  std::vector<Body> block;    ///< Of kBlock: one.
  std::uint32_t index = ~0u;  ///< Of an operation: the row of operations.inc; of a successor: the rule, or ~0 for none.
};

struct Rule {
  TextPosition place;
  std::string name;  ///< With its import's prefix: "window.Frame".
  std::vector<Local> parameters;
  Body body;
};

struct Function {
  TextPosition place;
  std::string name;
  std::vector<Local> parameters;
  Expression value;
  bool is_constant = false;  ///< Worth the same for every shape of a building (constant.h).
};

/// attr (the caller and set() may change it) or const.
struct Attribute {
  TextPosition place;
  std::string name;
  bool is_const = false;
  bool is_set = false;  ///< Some rule changes it by set().
  Expression value;
};

struct Import {
  TextPosition place;
  std::string prefix;  ///< "" for none.
  std::string file;
};

/// One file, names not resolved yet.
struct SyntaxTree {
  std::vector<Import> imports;
  std::vector<Attribute> attributes;
  std::vector<Function> functions;
  std::vector<Rule> rules;
  std::string start;  ///< The rule marked @StartRule, or the first; "" if there is none.
};

/// Everything that a derivation needs to know of rules. Plain data; never changes while one derives.
struct Program {
  std::vector<std::string> files;
  std::vector<Attribute> attributes;
  std::vector<Function> functions;
  std::vector<Rule> rules;
  std::map<std::string, std::uint32_t, std::less<>> attribute_of, function_of, rule_of;
  std::string start;
  std::uint32_t bodies = 0;  ///< How many there are.
};

}  // namespace citykiln::grammars
