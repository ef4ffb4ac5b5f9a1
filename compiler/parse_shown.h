// Parses the settings of what tiles show (scene/shown.h), for compile, bake and preview.
#pragma once

#include <optional>
#include <string_view>

#include "compiler/contract/result.h"
#include "compiler/scene/shown.h"

namespace citykiln {

/// Parses names of layers separated by commas, and returns the layers to leave out. "ground,roads" keeps these two
/// only, "all" keeps all. "-plants" removes a layer from the named ones, or from all if none is named; the order does
/// not matter. Errors: another name; no layer is left.
Result<scene::SceneLayers> parse_layers(std::string_view text);

/// Parses a factor from 0 to scene::kDensestWoods, rounded to scene::kWoodDensityStep.
Result<double> parse_wood_density(std::string_view text);

/// Parses "auto", "on" or "true", "off" or "false". Error: another text.
Result<scene::LampLight> parse_lamps(std::string_view text);

/// Parses a share from 0 to 1, rounded to scene::kLitWindowsStep; "none" is 0, "usual" is empty.
Result<std::optional<double>> parse_lit_windows(std::string_view text);

}  // namespace citykiln
