// Derives valid rules on any footprint and checks the guarantees of derive.h (derivation_claims.h).
#include <cstdio>
#include <cstdlib>

#include "grammars/derivation/form_roofs.h"
#include "grammars/language/read_rules.h"
#include "tests/grammars/derivation_claims.h"
#include "tests/grammars/made_rules.h"
#include "tests/grammars/plain_roof.h"

namespace {

using namespace citykiln;
using namespace citykiln::grammars;

DeriveOptions options_of(Choices& choices) {
  constexpr double kTolerances_m[] = {0.05, 0.2, 0.6, 2, 8};
  DeriveOptions options;
  options.limits = {24, 400, 60'000};
  options.tolerance_m = choices.of(kTolerances_m);
  options.keep_appearances = choices.one_in(2);
  options.keep_start = choices.one_in(4);
  options.prune_early = choices.one_in(2);
  options.memoise = !choices.one_in(4);
  options.roofs = choices.one_in(2) ? form_roofs(0.02) : RoofBuilder(plain_roof);
  if (choices.one_in(4))
    options.answer_context_query = answer_from_neighbours({{{{{9, -4}, {30, -4}, {30, 20}, {9, 20}}, {}}, 0, 7}});
  return options;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Choices choices({data, size});
  const DeriveOptions options = options_of(choices);
  const Polygon footprint = made_footprint(choices);
  const Shape shape = made_shape(choices, footprint);
  const std::string text = made_rules(choices);
  const Result<Program> program = read_rules_of(text, "fuzz.cga");
  std::string broken = program ? "" : to_string(program.error());
  std::uint32_t state = 1;
  const auto chance = [&] { return state = state * 1664525u + 1013904223u; };
  if (program) broken = broken_claim(*program, shape, options, is_sound(footprint), chance);
  if (broken.empty()) return 0;
  std::fprintf(stderr, "%s\nat %g m\n%s", broken.c_str(), options.tolerance_m, text.c_str());
  std::abort();
}
