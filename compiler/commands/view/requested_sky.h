// The sky that a command renders.
#pragma once

#include <optional>

#include "compiler/commands/view/load_tiles.h"

namespace citykiln::commands {

/// Returns the scene's sky; time, air and clouds of the request replace those of the scene. Without a manifest it is a
/// new sky at 45° north with fair clouds.
sky::Sky sky_of(const LoadRequest& request, const std::optional<scene::Header>& header);

}  // namespace citykiln::commands
