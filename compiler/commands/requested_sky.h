// The sky that a command was asked for.
#pragma once

#include <optional>

#include "compiler/commands/load_tiles.h"

namespace citykiln::commands {

/// The scene's sky with the time and the air of the request, where they are given; without a manifest a new sky at 45°
/// north. Its air is the scene's unless the request says otherwise. Error: a time that does not parse.
Result<sky::Sky> sky_of(const LoadRequest& request, const std::optional<scene::Header>& header);

}  // namespace citykiln::commands
