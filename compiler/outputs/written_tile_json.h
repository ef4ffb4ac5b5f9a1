// Converts the record of a written tile to JSON and back. Two files hold such records: report.json, and the journal, a
// list of finished files that is written during a run (exporters/output_folder.h).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "compiler/outputs/run_report.h"

namespace citykiln::outputs {

/// Returns the record as a JSON object.
nlohmann::ordered_json json_of(const WrittenTile& tile);
/// Returns the record in a JSON object that json_of() wrote. Throws an exception of the JSON library if a member is
/// missing or has another type.
WrittenTile parse_written_tile(const nlohmann::ordered_json& json);

}  // namespace citykiln::outputs
