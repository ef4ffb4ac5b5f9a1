// The add-on for Blender that the program carries.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// Returns the add-on as a zip archive that Blender installs. Equal bytes on every machine.
Result<std::vector<std::byte>> blender_addon_zip();

}  // namespace citykiln::exporters
