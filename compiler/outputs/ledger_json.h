// Writes and reads the ledger of a run as JSON, for report.json and for plans. The ledger has an account for each kind
// of object and stage, with numbers of objects: in + split = out + merged + without_body + dropped.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "compiler/contract/findings/report.h"

namespace citykiln::outputs {

/// Returns the diagnosis code with a name. Throws an exception of the JSON library if this program does not have the
/// name.
Code known_code(const std::string& name);

/// Returns a JSON object with a member per account: in, split, out, merged, without_body, and the dropped
/// objects by code.
nlohmann::ordered_json ledger_json(const Report& report);

/// Adds the output of ledger_json() to the accounts of a report; without_body may be missing, as in older reports.
/// Throws an exception of the JSON library if it is malformed.
void add_ledger(const nlohmann::ordered_json& json, Report& report);

}  // namespace citykiln::outputs
