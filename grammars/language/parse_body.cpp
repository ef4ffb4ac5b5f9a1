#include "grammars/language/operation_table.h"
#include "grammars/language/parser.h"

namespace citykiln::grammars {
namespace {

bool ends_statements(const Parser& parser) {
  return parser.at_end() || parser.sees("|") || parser.sees("}") || parser.sees("]") || parser.sees_name("case") ||
         parser.sees_name("else") || begins_chance(parser) || begins_declaration(parser);
}

SizeKind parse_size_kind(Parser& parser) {
  if (parser.accept("~")) return SizeKind::kFloating;
  if (parser.accept("'")) return SizeKind::kRelative;
  return SizeKind::kAbsolute;
}

std::vector<Selector> parse_selectors(Parser& parser);

Selector parse_selector(Parser& parser) {
  Selector selector;
  selector.position = parser.peek().position;
  if (parser.sees("{")) {
    selector.size = SizeKind::kRepeat;
    selector.nested = parse_selectors(parser);
    parser.expect("*", "after a group: it is repeated");
    return selector;
  }
  selector.size = parse_size_kind(parser);
  selector.key = parse_expression(parser);
  selector.together = parser.accept("=");
  if (!selector.together) parser.expect(":", "after a selector");
  selector.body = parse_body(parser);
  return selector;
}

std::vector<Selector> parse_selectors(Parser& parser) {
  const Nesting nesting(parser);
  std::vector<Selector> selectors;
  parser.expect("{", "before the selectors");
  do selectors.push_back(parse_selector(parser));
  while (parser.accept("|"));
  parser.expect("}", "or '|' after a selector");
  return selectors;
}

// { body } without a key.
std::vector<Selector> parse_body_selector(Parser& parser) {
  const Nesting nesting(parser);
  std::vector<Selector> selectors(1);
  selectors.front().position = parser.take().position;
  selectors.front().body = parse_body(parser);
  parser.expect("}", "that ends the operations");
  return selectors;
}

bool takes_body(const std::string& name) {
  const int row = operation_of(name);
  return row >= 0 && operation_table()[static_cast<std::size_t>(row)].selectors == SelectorKind::kBody;
}

Statement parse_bracket(Parser& parser) {
  Statement statement;
  statement.position = parser.peek().position;
  statement.kind = parser.take().text == "[" ? StatementKind::kPush : StatementKind::kPop;
  return statement;
}

Statement parse_block(Parser& parser) {
  const Nesting nesting(parser);
  Statement statement;
  statement.kind = StatementKind::kBlock;
  statement.position = parser.take().position;
  statement.block.push_back(parse_body(parser));
  parser.expect("}", "that ends the block");
  return statement;
}

// An operation or a successor; resolve() decides which.
Statement parse_call(Parser& parser) {
  Statement statement;
  statement.position = parser.peek().position;
  statement.name = parser.take().text;
  // In "A (100 - x)% : B" the parenthesis begins a percentage, not arguments.
  statement.has_arguments = parser.sees("(") && !begins_chance(parser);
  if (statement.has_arguments) statement.arguments = parse_arguments(parser);
  statement.has_selectors = statement.has_arguments && parser.sees("{");
  if (statement.has_selectors)
    statement.selectors = takes_body(statement.name) ? parse_body_selector(parser) : parse_selectors(parser);
  if (statement.has_selectors) statement.repeated = parser.accept("*");
  // The dot of "Wall." marks a terminal.
  if (!statement.has_selectors) parser.accept(".");
  return statement;
}

// Brackets balance within one list of statements, so the depth of the shape stack is bounded by the text.
void parse_statement(Parser& parser, std::vector<Statement>& statements, int& open) {
  if (parser.sees("[")) {
    ++open;
    return statements.push_back(parse_bracket(parser));
  }
  if (parser.sees("{")) return statements.push_back(parse_block(parser));
  if (parser.peek().kind == TokenKind::kName) return statements.push_back(parse_call(parser));
  parser.fail_expected("an operation, a shape's name, '[' or the end of the rule");
}

std::vector<Statement> parse_statements(Parser& parser) {
  std::vector<Statement> statements;
  int open = 0;
  while (!parser.failed) {
    if (open > 0 && parser.sees("]")) {
      --open;
      statements.push_back(parse_bracket(parser));
    } else if (ends_statements(parser)) {
      break;
    } else {
      parse_statement(parser, statements, open);
    }
  }
  if (open > 0 && !parser.failed) parser.fail_expected("']' that closes '['");
  return statements;
}

Branch parse_else_branch(Parser& parser) {
  Branch branch;
  branch.position = parser.take().position;
  branch.is_else = true;
  parser.expect(":", "after 'else'");
  branch.body = parse_body(parser);
  return branch;
}

void parse_cases(Parser& parser, Body& body) {
  body.kind = BodyKind::kCase;
  while (parser.sees_name("case")) {
    Branch branch;
    branch.position = parser.take().position;
    branch.test = parse_expression(parser);
    parser.expect(":", "after the condition");
    branch.body = parse_body(parser);
    body.branches.push_back(std::move(branch));
  }
}

void parse_chances(Parser& parser, Body& body) {
  body.kind = BodyKind::kChance;
  while (begins_chance(parser)) {
    Branch branch;
    branch.position = parser.peek().position;
    branch.test = parse_percent(parser);
    branch.body = parse_body(parser);
    body.branches.push_back(std::move(branch));
  }
}

}  // namespace

Body parse_body(Parser& parser) {
  const Nesting nesting(parser);
  Body body;
  if (parser.sees_name("with")) {
    parser.take();
    body.locals = parse_locals(parser);
  }
  if (parser.sees_name("case")) {
    parse_cases(parser, body);
  } else if (begins_chance(parser)) {
    parse_chances(parser, body);
  } else {
    body.statements = parse_statements(parser);
    return body;
  }
  if (parser.sees_name("else")) {
    body.branches.push_back(parse_else_branch(parser));
  } else if (body.kind == BodyKind::kCase && !parser.failed) {
    parser.fail_expected("'else' after the last case");
  }
  return body;
}

}  // namespace citykiln::grammars
