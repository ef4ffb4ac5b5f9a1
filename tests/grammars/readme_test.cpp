// The examples and tables of cga.md agree with the code.
#include <gtest/gtest.h>

#include "grammars/language/builtin.h"
#include "grammars/language/operation_table.h"
#include "tests/grammars/on_lot.h"
#include "tests/grammars/rule_files.h"

namespace citykiln::grammars {
namespace {

std::string readme() {
  const Result<std::string> text = text_of_tree("grammars/cga.md");
  return text ? *text : "";
}

std::vector<std::string> examples() {
  std::vector<std::string> found;
  const std::string text = readme();
  for (std::size_t at = text.find("```cga\n"); at != std::string::npos; at = text.find("```cga\n", at)) {
    at += 7;
    found.push_back(text.substr(at, text.find("```", at) - at));
  }
  return found;
}

TEST(Readme, ItsTwelveExamplesAreDerivedWithoutTrouble) {
  EXPECT_EQ(examples().size(), 12u);
  for (const std::string& text : examples()) {
    const Result<Program> program = read_rules_of(text, "README");
    ASSERT_TRUE(program) << to_string(program.error()) << "\n" << text;
    const Derivation derivation = derive(*program, lot_of(12, 9), {});
    EXPECT_FALSE(derivation.terminals.empty()) << text;
    EXPECT_TRUE(derivation.limits.empty()) << text;
    for (const Warning& warning : derivation.warnings) ADD_FAILURE() << warning_line(*program, warning) << "\n" << text;
  }
}

TEST(Readme, NamesEveryOperation) {
  const std::string text = readme();
  for (const OperationRow& row : operation_table()) EXPECT_NE(text.find(row.name), std::string::npos) << row.name;
}

}  // namespace
}  // namespace citykiln::grammars
