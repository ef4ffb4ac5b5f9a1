// Finds diagnosis codes by name.
#pragma once

#include <optional>
#include <string_view>

#include "compiler/contract/report.h"

namespace citykiln {

/// Returns the code with a name such as "MissingNode"; empty if no code has that name.
std::optional<Code> code_named(std::string_view name);

}  // namespace citykiln
