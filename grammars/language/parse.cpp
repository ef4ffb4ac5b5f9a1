#include "grammars/language/parse.h"

#include <set>

#include "grammars/language/lexer.h"
#include "grammars/language/parser.h"

namespace citykiln::grammars {
namespace {

void parse_version(Parser& parser) {
  parser.take();
  if (parser.peek().kind != TokenKind::kString) return parser.fail_expected("the version in quotes, as \"2023.0\"");
  parser.take();
}

// import window : "window.cga", or import "window.cga"
Import parse_import(Parser& parser) {
  Import made;
  made.position = parser.take().position;
  if (parser.peek().kind == TokenKind::kName) {
    made.prefix = parser.take().text;
    parser.expect(":", "after the import's prefix");
  }
  if (parser.peek().kind == TokenKind::kString) {
    made.file = parser.take().text;
  } else {
    parser.fail_expected("the name of a rule file in quotes");
  }
  return made;
}

Attribute parse_attribute(Parser& parser) {
  Attribute made;
  made.is_const = parser.take().text == "const";
  made.position = parser.peek().position;
  made.name = parser.expect_name(made.is_const ? "the constant's name" : "the attribute's name");
  parser.expect("=", made.is_const ? "after the constant's name" : "after the attribute's name");
  made.value = parse_value(parser);
  return made;
}

std::vector<Local> parse_parameters(Parser& parser) {
  std::vector<Local> parameters;
  if (!parser.accept("(")) return parameters;
  if (parser.accept(")")) return parameters;
  do {
    Local parameter;
    parameter.name = parser.expect_name("a parameter's name");
    parameters.push_back(std::move(parameter));
  } while (parser.accept(","));
  parser.expect(")", "or ',' after a parameter");
  return parameters;
}

// Name(a, b) --> … or name(a, b) = …
void parse_definition(Parser& parser, SyntaxTree& tree) {
  const Token name = parser.take();
  std::vector<Local> parameters = parse_parameters(parser);
  if (parser.accept("-->")) {
    parser.within = " (in rule " + name.text + ")";
    tree.rules.push_back({name.position, name.text, std::move(parameters), parse_body(parser)});
    parser.within.clear();
    return;
  }
  if (!parser.accept("=")) return parser.fail_expected("'-->' of a rule or '=' of a function");
  tree.functions.push_back({name.position, name.text, std::move(parameters), parse_value(parser)});
}

// Annotations other than the start rule describe the user interface of CityEngine.
void parse_annotation(Parser& parser, SyntaxTree& tree) {
  parser.take();
  const std::string name = parser.expect_name("an annotation's name");
  if (parser.sees("(")) parser.at = after_parenthesis(parser, parser.at);
  if ((name == "StartRule" || name == "Start") && parser.peek().kind == TokenKind::kName)
    tree.start = parser.peek().text;
}

void parse_declaration(Parser& parser, SyntaxTree& tree) {
  if (parser.sees("@")) return parse_annotation(parser, tree);
  if (parser.peek().kind != TokenKind::kName) return parser.fail_expected("a rule, function, attr, const or import");
  if (parser.sees_name("version")) return parse_version(parser);
  if (parser.sees_name("import")) return tree.imports.push_back(parse_import(parser));
  if (parser.sees_name("attr") || parser.sees_name("const")) return tree.attributes.push_back(parse_attribute(parser));
  if (parser.sees_name("style"))
    return parser.fail(parser.peek().position,
                       "styles are not part of our language; give attributes when deriving, or import with a prefix");
  parse_definition(parser, tree);
}

template <typename Named>
void refuse_twins(Parser& parser, const std::vector<Named>& named, std::set<std::string>& known, const char* what) {
  for (const Named& one : named)
    if (!known.insert(one.name).second)
      parser.fail(one.position, std::string(what) + " '" + one.name + "' is defined twice");
}

}  // namespace

bool begins_declaration(const Parser& parser) {
  if (parser.sees("@")) return true;
  if (parser.peek().kind != TokenKind::kName) return false;
  for (const char* word : {"attr", "const", "import", "version", "style"})
    if (parser.sees_name(word) && !is_sign(parser.peek(1), "(")) return true;
  const std::size_t next = is_sign(parser.peek(1), "(") ? after_parenthesis(parser, parser.at + 1) : parser.at + 1;
  return next < parser.tokens.size() && (is_sign(parser.tokens[next], "-->") || is_sign(parser.tokens[next], "="));
}

Result<SyntaxTree> parse(std::string_view text, std::string_view file, std::uint32_t file_index) {
  auto tokens = tokens_of(text, file, file_index);
  if (!tokens) return tokens.error();
  Parser parser{std::move(*tokens), std::string(file), 0, 0, {}, {}};
  SyntaxTree tree;
  while (!parser.at_end()) parse_declaration(parser, tree);
  std::set<std::string> values, rules;
  refuse_twins(parser, tree.attributes, values, "the attribute");
  refuse_twins(parser, tree.functions, values, "the function");
  refuse_twins(parser, tree.rules, rules, "the rule");
  if (parser.failed) return *parser.failed;
  if (tree.start.empty() && !tree.rules.empty()) tree.start = tree.rules.front().name;
  return tree;
}

}  // namespace citykiln::grammars
