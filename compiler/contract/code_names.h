// Diagnosis codes by their names.
#pragma once

#include <optional>
#include <string_view>

#include "compiler/contract/report.h"

namespace citykiln {

/// The code of a name such as "MissingNode"; nothing if no code has that name.
std::optional<Code> code_named(std::string_view name);

}  // namespace citykiln
