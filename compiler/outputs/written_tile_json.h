// Writes and reads the record of a written tile, for report.json and for the journal of a run.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "compiler/outputs/run_report.h"

namespace citykiln::outputs {

/// Returns the record as a JSON object.
nlohmann::ordered_json json_of(const WrittenTile& tile);
/// Reads the output of json_of(). Throws an exception of the JSON library if it is malformed.
WrittenTile written_tile(const nlohmann::ordered_json& json);

}  // namespace citykiln::outputs
