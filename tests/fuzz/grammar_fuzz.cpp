// Parses any text to a program or one error line. Any program derives within its limits, and its derivation at a
// tolerance reports the same counts.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "grammars/derivation/derive.h"
#include "grammars/language/read_rules.h"

namespace {

using namespace citykiln;
using namespace citykiln::grammars;

Derivation derived(const Program& program, double tolerance_m, bool prune_early = false) {
  DeriveOptions options;
  options.limits = {24, 400, 60'000};
  options.tolerance_m = tolerance_m;
  options.prune_early = prune_early;
  const Polygon footprint{{{0, 0}, {12, 0}, {12, 5}, {5, 5}, {5, 9}, {0, 9}}, {}};
  return derive(program, lot(footprint, 2, 0, StableId{7}, {0}), options);
}

bool is_finite(const Derivation& derivation) {
  bool all = true;
  for (const Terminal& terminal : derivation.terminals)
    for (const Face& face : terminal.faces)
      each_vertex(face, [&](Vec3 p) { all &= std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); });
  return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const Result<Program> program = read_rules_of(text, "fuzz.cga");
  if (!program) return 0;
  const Derivation full = derived(*program, 0), cut = derived(*program, 0.5);
  if (!is_finite(full) || !is_finite(cut)) std::abort();
  if (full.shapes != cut.shapes || full.steps != cut.steps || full.limits.size() != cut.limits.size()) std::abort();
  if (!(cut.error_m <= 0.5) || cut.terminals.empty() != full.terminals.empty()) std::abort();
  const Derivation ahead = derived(*program, 0.5, true);
  if (!is_finite(ahead) || !(ahead.error_m <= 0.5)) std::abort();
  return 0;
}
