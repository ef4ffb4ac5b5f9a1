// Random rules on random footprints: a short run of what fuzz_derivation does for hours.
#include "tests/grammars/made_rules.h"

#include <gtest/gtest.h>

#include <random>

#include "grammars/derivation/form_roofs.h"
#include "grammars/language/read_rules.h"
#include "tests/grammars/derivation_claims.h"
#include "tests/grammars/plain_roof.h"

namespace citykiln::grammars {
namespace {

struct MadeRules : testing::Test {
  std::mt19937 chance{3};
  std::vector<std::uint8_t> bytes() {
    std::vector<std::uint8_t> bytes(150 + chance() % 500);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(chance());
    return bytes;
  }
};

TEST_F(MadeRules, ParseWhateverTheChoices) {
  for (int round = 0; round < 2000; ++round) {
    const auto given = bytes();
    Choices choices(given);
    const std::string text = made_rules(choices);
    const auto program = read_rules_of(text);
    ASSERT_TRUE(program) << to_string(program.error()) << "\n" << text;
  }
}

// Seeds that have found errors, and another.
struct MadeRulesOf : MadeRules, testing::WithParamInterface<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Seeds, MadeRulesOf, testing::Values(2, 3, 9, 44, 58));

TEST_P(MadeRulesOf, KeepEveryClaimOnAnyFootprint) {
  chance.seed(GetParam());
  constexpr double kTolerances_m[] = {0.05, 0.2, 0.6, 2, 8};
  for (int round = 0; round < 400; ++round) {
    const auto given = bytes();
    Choices choices(given);
    const Polygon footprint = made_footprint(choices);
    const Shape shape = made_shape(choices, footprint);
    const std::string text = made_rules(choices);
    const auto program = read_rules_of(text);
    ASSERT_TRUE(program);
    DeriveOptions options;
    options.limits = {24, 400, 60'000};
    options.tolerance_m = kTolerances_m[round % 5];
    options.keep_appearances = round % 2 == 0, options.prune_early = round % 3 == 0, options.memoise = round % 4 != 0;
    options.roofs = round % 8 < 4 ? form_roofs(0.02) : RoofBuilder(plain_roof);
    ASSERT_EQ(broken_claim(*program, shape, options, is_sound(footprint), [&] { return chance(); }), "")
        << "round " << round << " at " << options.tolerance_m << " m\n"
        << text;
  }
}

}  // namespace
}  // namespace citykiln::grammars
