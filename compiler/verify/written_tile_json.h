// The entry of a tile in report.json and in the journal of a run.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "compiler/verify/run_report.h"

namespace citykiln::verify {

nlohmann::ordered_json json_of(const WrittenTile& tile);
/// Inverse of json_of(). Error: an exception of the JSON library.
WrittenTile written_tile(const nlohmann::ordered_json& json);

}  // namespace citykiln::verify
