#include <algorithm>
#include <array>
#include <span>

#include "grammars/language/parser.h"

namespace citykiln::grammars {
namespace {

struct OperatorRow {
  const char* sign;
  Operator op;
  int precedence;  ///< From 1, the weakest.
};

constexpr std::array kUnary = {OperatorRow{"-", Operator::kNegate, 7}, OperatorRow{"!", Operator::kNot, 7},
                               OperatorRow{"'", Operator::kShare, 7}, OperatorRow{"+", Operator::kPlus, 7}};

constexpr std::array kBinary = {
    OperatorRow{"||", Operator::kOr, 1},          OperatorRow{"&&", Operator::kAnd, 2},
    OperatorRow{"==", Operator::kEqual, 3},       OperatorRow{"!=", Operator::kNotEqual, 3},
    OperatorRow{"<", Operator::kLess, 4},         OperatorRow{">", Operator::kGreater, 4},
    OperatorRow{"<=", Operator::kLessOrEqual, 4}, OperatorRow{">=", Operator::kGreaterOrEqual, 4},
    OperatorRow{"+", Operator::kAdd, 5},          OperatorRow{"-", Operator::kSubtract, 5},
    OperatorRow{"*", Operator::kMultiply, 6},     OperatorRow{"/", Operator::kDivide, 6},
    OperatorRow{"%", Operator::kRemainder, 6}};

// The row of the next sign; null if it is no operator of the table.
const OperatorRow* next_operator(const Parser& parser, std::span<const OperatorRow> rows) {
  // "30% :" is a percentage, not a remainder.
  if (parser.sees("%") && is_sign(parser.peek(1), ":")) return nullptr;
  const auto row = std::ranges::find_if(rows, [&](const OperatorRow& each) { return parser.sees(each.sign); });
  return row == rows.end() ? nullptr : &*row;
}

Expression take_operator(Parser& parser, ExpressionKind kind, Operator op) {
  Expression made;
  made.kind = kind;
  made.op = op;
  made.position = parser.take().position;
  return made;
}

Expression literal(TextPosition position, Value value) {
  Expression made;
  made.position = position;
  made.value = std::move(value);
  return made;
}

Expression parse_name(Parser& parser) {
  const Token name = parser.take();
  if (name.text == "true" || name.text == "false") return literal(name.position, name.text == "true");
  Expression made;
  made.position = name.position;
  made.text = name.text;
  made.kind = parser.sees("(") ? ExpressionKind::kCall : ExpressionKind::kName;
  if (made.kind == ExpressionKind::kCall) made.operands = parse_arguments(parser);
  return made;
}

Expression parse_primary(Parser& parser) {
  const Token& next = parser.peek();
  if (next.kind == TokenKind::kNumber) return literal(next.position, parser.take().number);
  if (next.kind == TokenKind::kString) return literal(next.position, parser.take().text);
  if (next.kind == TokenKind::kName) return parse_name(parser);
  if (!parser.accept("(")) {
    parser.fail_expected("a value");
    return {};
  }
  Expression inner = parse_value(parser);
  parser.expect(")", "that closes the parenthesis");
  return inner;
}

Expression parse_unary(Parser& parser) {
  const Nesting nesting(parser);
  const OperatorRow* row = next_operator(parser, kUnary);
  if (row == nullptr) return parse_primary(parser);
  Expression made = take_operator(parser, ExpressionKind::kUnary, row->op);
  made.operands.push_back(parse_unary(parser));
  return made;
}

// Precedence climbing: operators of at least this precedence, left-associative.
Expression parse_binary(Parser& parser, int least_precedence) {
  Expression left = parse_unary(parser);
  for (const OperatorRow* row = next_operator(parser, kBinary); row != nullptr && row->precedence >= least_precedence;
       row = next_operator(parser, kBinary)) {
    Expression made = take_operator(parser, ExpressionKind::kBinary, row->op);
    made.operands.push_back(std::move(left));
    made.operands.push_back(parse_binary(parser, row->precedence + 1));
    left = std::move(made);
  }
  return left;
}

Expression parse_else(Parser& parser, const char* after) {
  if (!parser.sees_name("else")) {
    parser.fail_expected(std::string("'else' after ") + after);
    return {};
  }
  parser.take();
  parser.expect(":", "after 'else'");
  return parse_value(parser);
}

bool begins_branch(const Parser& parser, ExpressionKind kind) {
  return kind == ExpressionKind::kCase ? parser.sees_name("case") : begins_chance(parser);
}

// "case condition :" or "per cent % :"
Expression parse_test(Parser& parser, ExpressionKind kind) {
  if (kind == ExpressionKind::kChance) return parse_percent(parser);
  parser.take();
  Expression condition = parse_expression(parser);
  parser.expect(":", "after the condition");
  return condition;
}

// case … else, or p% … else
Expression parse_choice(Parser& parser, ExpressionKind kind) {
  Expression made;
  made.kind = kind;
  made.position = parser.peek().position;
  while (begins_branch(parser, kind)) {
    made.operands.push_back(parse_test(parser, kind));
    made.operands.push_back(parse_value(parser));
  }
  made.operands.push_back(parse_else(parser, kind == ExpressionKind::kCase ? "the last case" : "the last share"));
  return made;
}

Expression parse_with_value(Parser& parser) {
  Expression made;
  made.kind = ExpressionKind::kWithLocals;
  made.position = parser.take().position;
  for (Local& local : parse_locals(parser)) {
    made.text += local.name + ";";
    made.operands.push_back(std::move(local.value));
  }
  made.operands.push_back(parse_value(parser));
  return made;
}

}  // namespace

Expression parse_expression(Parser& parser) { return parse_binary(parser, 1); }

Expression parse_value(Parser& parser) {
  const Nesting nesting(parser);
  if (parser.sees_name("with")) return parse_with_value(parser);
  if (parser.sees_name("case")) return parse_choice(parser, ExpressionKind::kCase);
  if (begins_chance(parser)) return parse_choice(parser, ExpressionKind::kChance);
  return parse_expression(parser);
}

std::vector<Expression> parse_arguments(Parser& parser) {
  std::vector<Expression> arguments;
  parser.expect("(", "before the arguments");
  if (parser.accept(")")) return arguments;
  do arguments.push_back(parse_expression(parser));
  while (parser.accept(","));
  parser.expect(")", "or ',' after an argument");
  return arguments;
}

std::vector<Local> parse_locals(Parser& parser) {
  std::vector<Local> locals;
  parser.expect("(", "after 'with'");
  while (!parser.sees(")") && !parser.failed) {
    Local local;
    local.name = parser.expect_name("the name of a local");
    if (!parser.accept(":=")) parser.expect("=", "after the local's name");
    local.value = parse_value(parser);
    locals.push_back(std::move(local));
    if (!parser.accept(",")) parser.accept(";");
  }
  parser.expect(")", "that ends 'with'");
  return locals;
}

std::size_t after_parenthesis(const Parser& parser, std::size_t from) {
  int open = 0;
  for (std::size_t i = from; i < parser.tokens.size(); ++i) {
    if (is_sign(parser.tokens[i], "(")) ++open;
    if (is_sign(parser.tokens[i], ")") && --open == 0) return i + 1;
  }
  return parser.tokens.size() - 1;
}

bool begins_chance(const Parser& parser) {
  const TokenKind kind = parser.peek().kind;
  std::size_t behind = parser.at + 1;
  if (parser.sees("(")) {
    behind = after_parenthesis(parser, parser.at);
  } else if (kind == TokenKind::kName && is_sign(parser.peek(1), "(")) {
    behind = after_parenthesis(parser, parser.at + 1);
  } else if (kind != TokenKind::kNumber && kind != TokenKind::kName) {
    return false;
  }
  return behind + 1 < parser.tokens.size() && is_sign(parser.tokens[behind], "%") &&
         is_sign(parser.tokens[behind + 1], ":");
}

Expression parse_percent(Parser& parser) {
  Expression percent = parse_unary(parser);
  parser.expect("%", "after a share");
  parser.expect(":", "after '%'");
  return percent;
}

}  // namespace citykiln::grammars
