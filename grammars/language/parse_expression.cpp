#include <array>

#include "grammars/language/parser.h"

namespace citykiln::grammars {
namespace {

struct Operator {
  const char* sign;
  int binds;  ///< The higher, the tighter.
};

constexpr std::array kOperators = {Operator{"||", 1}, Operator{"&&", 2}, Operator{"==", 3}, Operator{"!=", 3},
                                   Operator{"<", 4},  Operator{">", 4},  Operator{"<=", 4}, Operator{">=", 4},
                                   Operator{"+", 5},  Operator{"-", 5},  Operator{"*", 6},  Operator{"/", 6},
                                   Operator{"%", 6}};

int binding_of(const Parser& parser) {
  // "30% :" is a share, not a remainder
  if (parser.sees("%") && is_sign(parser.peek(1), ":")) return 0;
  for (const Operator& row : kOperators)
    if (parser.sees(row.sign)) return row.binds;
  return 0;
}

Expression literal(TextPosition place, Value value) {
  Expression made;
  made.place = place;
  made.value = std::move(value);
  return made;
}

Expression parse_name(Parser& parser) {
  const Token name = parser.take();
  if (name.text == "true" || name.text == "false") return literal(name.place, name.text == "true");
  Expression made;
  made.place = name.place;
  made.text = name.text;
  made.kind = parser.sees("(") ? ExpressionKind::kCall : ExpressionKind::kName;
  if (made.kind == ExpressionKind::kCall) made.operands = parse_arguments(parser);
  return made;
}

Expression parse_primary(Parser& parser) {
  const Token& next = parser.peek();
  if (next.kind == TokenKind::kNumber) return literal(next.place, parser.take().number);
  if (next.kind == TokenKind::kString) return literal(next.place, parser.take().text);
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
  for (const char* sign : {"-", "!", "'", "+"}) {
    if (!parser.sees(sign)) continue;
    Expression made;
    made.kind = ExpressionKind::kUnary;
    made.place = parser.peek().place;
    made.text = parser.take().text;
    made.operands.push_back(parse_unary(parser));
    return made;
  }
  return parse_primary(parser);
}

Expression parse_binary(Parser& parser, int binds_at_least) {
  Expression left = parse_unary(parser);
  for (int binds = binding_of(parser); binds >= binds_at_least && binds > 0; binds = binding_of(parser)) {
    Expression made;
    made.kind = ExpressionKind::kBinary;
    made.place = parser.peek().place;
    made.text = parser.take().text;
    made.operands.push_back(std::move(left));
    made.operands.push_back(parse_binary(parser, binds + 1));
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
  made.place = parser.peek().place;
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
  made.place = parser.take().place;
  for (Local& local : parse_locals(parser)) {
    made.text += local.name + ";";
    made.operands.push_back(std::move(local.value));
  }
  made.operands.push_back(parse_value(parser));
  return made;
}

/// The word behind the parenthesis that opens at `from`.
std::size_t behind_parenthesis(const Parser& parser, std::size_t from) {
  int open = 0;
  for (std::size_t i = from; i < parser.tokens.size(); ++i) {
    if (is_sign(parser.tokens[i], "(")) ++open;
    if (is_sign(parser.tokens[i], ")") && --open == 0) return i + 1;
  }
  return parser.tokens.size() - 1;
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

bool begins_chance(const Parser& parser) {
  const TokenKind kind = parser.peek().kind;
  std::size_t behind = parser.at + 1;
  if (parser.sees("(")) {
    behind = behind_parenthesis(parser, parser.at);
  } else if (kind == TokenKind::kName && is_sign(parser.peek(1), "(")) {
    behind = behind_parenthesis(parser, parser.at + 1);
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
