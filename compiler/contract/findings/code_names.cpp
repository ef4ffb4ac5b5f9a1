#include "compiler/contract/findings/code_names.h"

#include <algorithm>

namespace citykiln {
namespace {

constexpr Code kAllCodes[] = {
#define CODE(name, severity, text) Code::name,
#include "compiler/contract/findings/diagnosis_codes.inc"
#undef CODE
};

}  // namespace

std::span<const Code> all_codes() { return kAllCodes; }

std::optional<Code> code_named(std::string_view name) {
  const auto* found = std::ranges::find(kAllCodes, name, [](Code code) { return name_of(code); });
  return found != std::end(kAllCodes) ? std::optional(*found) : std::nullopt;
}

}  // namespace citykiln
