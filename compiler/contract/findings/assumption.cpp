#include "compiler/contract/findings/assumption.h"

#include <array>

namespace citykiln {
namespace {

struct AssumptionTexts {
  std::string_view name, text;
};

constexpr std::array kAssumptionTexts = {
#define ASSUMPTION(enumerator, name, text) AssumptionTexts{name, text},
#include "compiler/contract/findings/assumptions.inc"
#undef ASSUMPTION
};
static_assert(kAssumptionTexts.size() == static_cast<std::size_t>(Assumption::kCount));
static_assert(kAssumptionTexts.size() <= 16);

}  // namespace

std::string_view name_of(Assumption assumption) { return kAssumptionTexts[static_cast<std::size_t>(assumption)].name; }

std::string_view text_of(Assumption assumption) { return kAssumptionTexts[static_cast<std::size_t>(assumption)].text; }

std::optional<Assumption> assumption_named(std::string_view name) {
  for (std::size_t i = 0; i < kAssumptionTexts.size(); ++i)
    if (kAssumptionTexts[i].name == name) return static_cast<Assumption>(i);
  return std::nullopt;
}

}  // namespace citykiln
