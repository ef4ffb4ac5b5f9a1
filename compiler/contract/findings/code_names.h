// Lists diagnosis codes, and finds them by name.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "compiler/contract/findings/report.h"

namespace citykiln {

/// Returns all codes, in the order of their rows.
std::span<const Code> all_codes();

/// Returns the code with a name such as "MissingNode"; empty if no code has that name.
std::optional<Code> code_named(std::string_view name);

}  // namespace citykiln
