// The add-on for Blender that the program carries.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/contract/result.h"

namespace citykiln::exporters {

/// Returns the bytes of the add-on as a zip archive, which Blender installs. Equal bytes on every machine. Error: more
/// than 4 GB (stored_zip()), which these few files never have.
Result<std::vector<std::byte>> blender_addon_zip();

}  // namespace citykiln::exporters
