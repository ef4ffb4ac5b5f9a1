// The ledger of a run as JSON, in report.json and in plans.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "compiler/contract/report.h"

namespace citykiln::verify {

/// The code of a name. Error, an exception of the JSON library: a name that this program does not have.
Code known_code(const std::string& name);

/// An object with a member for each account: in, split, out, merged, and what was dropped by code.
nlohmann::ordered_json ledger_json(const Report& report);

/// Adds what ledger_json() wrote to the accounts of a report. Error: an exception of the JSON library.
void add_ledger(const nlohmann::ordered_json& json, Report& report);

}  // namespace citykiln::verify
