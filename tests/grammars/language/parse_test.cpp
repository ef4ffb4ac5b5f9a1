#include "grammars/language/parse.h"

#include <gtest/gtest.h>

#include <string>

#include "grammars/language/read_rules.h"
#include "tests/grammars/on_lot.h"

namespace citykiln::grammars {
namespace {

std::string error_of(const std::string& text) {
  const Result<Program> program = read_rules_of(text, "x.cga");
  return program ? "" : to_string(program.error());
}

struct Mistake {
  const char* text;
  const char* error;
};

class Mistakes : public testing::TestWithParam<Mistake> {};

// The error without the rule in which it is.
TEST_P(Mistakes, AreNamedWithPlaceAndWhatWasExpected) {
  const std::string error = error_of(GetParam().text);
  EXPECT_EQ(error.substr(0, error.find(" (in rule ")), GetParam().error);
}

TEST(Parse, ErrorsNameTheRuleInWhichTheyAre) {
  EXPECT_EQ(error_of("A --> B\nFacade --> split(x { ~1 : Wall }"),
            "x.cga:2:20: expected ')' or ',' after an argument, found '{' (in rule Facade)");
  EXPECT_EQ(error_of("A --> B\nFacade --> extrude(hoehe)"),
            "x.cga:2:20: nothing defines the value 'hoehe' (in rule Facade)");
  EXPECT_EQ(error_of("attr a = b\nA --> B"), "x.cga:1:10: nothing defines the value 'b'");
}

const Mistake kMistakes[] = {
    // words
    {"A --> B $\n  `", "x.cga:2:3: no token begins with '`'"},
    {"attr a = \"open\nA --> B", "x.cga:1:10: expected \" that ends the string, found the end of the line"},
    {"A --> B /* open", "x.cga:1:9: expected */ that ends the comment, found the end of the file"},
    {"attr a = 1e999", "x.cga:1:10: expected a number that a double can hold"},
    // declarations
    {"3", "x.cga:1:1: expected a rule, function, attr, const or import, found '3'"},
    {"A -> B", "x.cga:1:3: expected '-->' of a rule or '=' of a function, found '-'"},
    {"version 2023", "x.cga:1:9: expected the version in quotes, as \"2023.0\", found '2023'"},
    {"import w \"w.cga\"", "x.cga:1:10: expected ':' after the import's prefix, found \"w.cga\""},
    {"import w : window", "x.cga:1:12: expected the name of a rule file in quotes, found 'window'"},
    {"attr = 3", "x.cga:1:6: expected the attribute's name, found '='"},
    {"attr a 3", "x.cga:1:8: expected '=' after the attribute's name, found '3'"},
    {"const c = ", "x.cga:1:11: expected a value, found the end of the file"},
    {"style Modern",
     "x.cga:1:1: styles are not part of our language; give attributes when deriving, or import with a "
     "prefix"},
    {"A --> B\nA --> C", "x.cga:2:1: the rule 'A' is defined twice"},
    {"attr a = 1\na = 2\nA --> B", "x.cga:2:1: the function 'a' is defined twice"},
    {"A(3) --> B", "x.cga:1:3: expected a parameter's name, found '3'"},
    {"A(x --> B", "x.cga:1:5: expected ')' or ',' after a parameter, found '-->'"},
    // expressions
    {"f(x) = case x > 1 : 2\nA --> B", "x.cga:2:1: expected 'else' after the last case, found 'A'"},
    {"f(x) = case x > 1 2 else : 3", "x.cga:1:19: expected ':' after the condition, found '2'"},
    {"f = 30% : 1 20% : 2", "x.cga:1:20: expected 'else' after the last share, found the end of the file"},
    {"f = (1 + 2", "x.cga:1:11: expected ')' that closes the parenthesis, found the end of the file"},
    {"f = 1 +", "x.cga:1:8: expected a value, found the end of the file"},
    // bodies
    {"A --> split(x) { 1 : B", "x.cga:1:23: expected '}' or '|' after a selector, found the end of the file"},
    {"A --> split(x) { 1 B }", "x.cga:1:20: expected ':' after a selector, found 'B'"},
    {"A --> split(x) { { 1 : B } }", "x.cga:1:28: expected '*' after a group: it is repeated, found '}'"},
    {"A --> [ B", "x.cga:1:10: expected ']' that closes '[', found the end of the file"},
    {"A --> B ]", "x.cga:1:9: expected a rule, function, attr, const or import, found ']'"},
    {"A --> case scope.sx > 1 : B", "x.cga:1:28: expected 'else' after the last case, found the end of the file"},
    {"A --> { B", "x.cga:1:10: expected '}' that ends the block, found the end of the file"},
    {"A --> B, C", "x.cga:1:8: expected an operation, a shape's name, '[' or the end of the rule, found ','"},
    // names
    {"A --> extrude(hight)", "x.cga:1:15: nothing defines the value 'hight'"},
    {"A --> extrude(hight(3))", "x.cga:1:15: nothing defines the function 'hight'"},
    {"A --> extrde(3)", "x.cga:1:7: there is no operation or rule 'extrde'"},
    {"A --> extrude()",
     "x.cga:1:7: expected extrude(number) or extrude(word, number); words: face.normal world.up "
     "world.up.flatTop "},
    {"A --> split(w) { 1 : B }", "x.cga:1:7: expected split(word) or split(word, word); words: x y z adjust noAdjust "},
    {"A --> split(x) B", "x.cga:1:7: expected '{' with selectors behind 'split'"},
    {"A --> t(1, 2, 3) { 1 : B }", "x.cga:1:7: 't' takes no selectors"},
    {"A --> comp(f) { { front : B }* }", "x.cga:1:17: expected a component, found a repeated group"},
    {"A --> B(3)\nB --> C", "x.cga:1:7: expected 0 arguments of the rule 'B', found 1"},
    {"f(a, b) = a\nA --> extrude(f(1))", "x.cga:2:15: expected 2 arguments of 'f', found 1"},
    {"A --> extrude(sin(1, 2))", "x.cga:1:15: expected 1 argument of 'sin', found 2"},
    {"A --> extrude(rand(1, 2, 3))", "x.cga:1:15: expected 0 to 2 arguments of 'rand', found 3"},
    {"A --> extrude('0.5)",
     "x.cga:1:7: expected extrude(number) or extrude(word, number); words: face.normal world.up "
     "world.up.flatTop "},
    {"A --> t(1 + '0.5, 0, 0)", "x.cga:1:13: a share ' of the scope's size cannot stand here"},
    {"const c = 1\nA --> set(c, 2)", "x.cga:2:11: 'c' is a constant; only attributes can be set"},
    {"A --> set(material.colour, 2)", "x.cga:1:11: expected an attribute or material value, found 'material.colour'"},
    {"A --> set(rand, 2)", "x.cga:1:11: expected an attribute or material value, found 'rand'"},
    {"import w : \"w.cga\"", "x.cga:1:1: the import \"w.cga\": there is no such rule file"},
};

INSTANTIATE_TEST_SUITE_P(Table, Mistakes, testing::ValuesIn(kMistakes));

TEST(Parse, RefusesWhatIsNestedTooDeep) {
  const std::string deep = "f = " + std::string(1000, '(') + "1" + std::string(1000, ')');
  EXPECT_NE(error_of(deep).find("nested deeper than 64"), std::string::npos);
  std::string blocks = "A --> ";
  for (int i = 0; i < 1000; ++i) blocks += "{ ";
  EXPECT_NE(error_of(blocks).find("nested deeper than 64"), std::string::npos);
}

TEST(Parse, ReadsWhatCgaWrites) {
  const auto tree = parse(R"(
version "2023.0"
import w : "w.cga"
/* a comment
   of two lines */
@Group("Size", 1) @Range(min=3, max=40)
attr height = rand(10, 20)   // to the line's end
const red = "#ff0000"        # and this
area(a, b) = a * b
pick = 30% : "x" 20% : "y" else : "z"
size(x) = with( half := x / 2  twice = x * 2 ) case half > 2 : twice case half > 1 : half else : -x
@StartRule
Lot --> extrude(height) comp(f) { front : Front(1, true) | side = Side | 3 : Other. | all : NIL }
Front(n, flag) -->
  case n > 2 && !flag : split(x) { 'n : A | ~2 : B | { ~1 : C | 0.5 : D }* | 1 : E }
  else : [ t('0.5, 0, -1) r(scopeCenter, 0, 90, 0) w.Window ] Side
Side --> 30% : split(y) { 2 : A }* C (100 - 40)% : B else : { C D }
)",
                          "x.cga");
  ASSERT_TRUE(tree) << to_string(tree.error());
  EXPECT_EQ(tree->rules.size(), 3u);
  EXPECT_EQ(tree->functions.size(), 3u);
  EXPECT_EQ(tree->attributes.size(), 2u);
  EXPECT_EQ(tree->imports.size(), 1u);
  EXPECT_EQ(tree->start, "Lot");
  EXPECT_EQ(tree->rules[1].body.branches.size(), 2u);
  EXPECT_EQ(tree->rules[2].body.branches.size(), 3u);
  EXPECT_TRUE(tree->rules[2].body.branches[0].body.statements[0].repeated);
}

TEST(Parse, TheFirstRuleStartsWhereNoneIsMarked) {
  EXPECT_EQ(program_of("A --> B\nB --> C").start, "A");
  EXPECT_EQ(program_of("A --> B\n@StartRule\nB --> C").start, "B");
}

Result<Program> linked(std::map<std::string, std::string> files) {
  return read_rules("main.cga", [files](const std::string& file) -> Result<std::string> {
    const auto found = files.find(file);
    if (found == files.end()) return Error{file, "there is no such rule file"};
    return found->second;
  });
}

TEST(Import, GivesNamesWithItsPrefix) {
  const auto program = linked({{"main.cga", "import w : \"w.cga\"\nLot --> w.Window X(w.size)\nX(a) --> extrude(a)"},
                               {"w.cga", "attr size = 3\nWindow --> Frame\nFrame --> extrude(size) Pane"}});
  ASSERT_TRUE(program) << to_string(program.error());
  const Derivation derivation = derive(*program, lot_of(1, 1), {});
  ASSERT_EQ(derivation.terminals.size(), 2u);
  EXPECT_EQ(path_name(derivation, derivation.terminals[0].path), "Lot/w.Window/w.Frame/Pane");
  EXPECT_EQ(path_name(derivation, derivation.terminals[1].path), "Lot/X");
}

TEST(Import, WithoutAPrefixJoinsAndTheImporterWins) {
  const auto program =
      linked({{"main.cga", "import \"w.cga\"\nLot --> A B\nA --> Mine"}, {"w.cga", "A --> Theirs\nB --> Joined"}});
  ASSERT_TRUE(program) << to_string(program.error());
  const Derivation derivation = derive(*program, lot_of(1, 1), {});
  EXPECT_EQ(count_named(derivation, "Mine"), 1u);
  EXPECT_EQ(count_named(derivation, "Joined"), 1u);
}

TEST(Import, RefusesCircles) {
  const auto program = linked({{"main.cga", "import \"w.cga\"\nLot --> A"}, {"w.cga", "\nimport m : \"main.cga\""}});
  ASSERT_FALSE(program);
  EXPECT_EQ(to_string(program.error()), "w.cga:2:1: the files 'w.cga' and 'main.cga' import each other");
}

TEST(Import, ErrorsNameTheImportedFile) {
  const auto program = linked({{"main.cga", "import w : \"w.cga\"\nLot --> A"}, {"w.cga", "A --> extrude(h)"}});
  ASSERT_FALSE(program);
  EXPECT_EQ(to_string(program.error()), "w.cga:1:15: nothing defines the value 'h' (in rule w.A)");
}

}  // namespace
}  // namespace citykiln::grammars
