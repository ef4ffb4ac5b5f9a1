// Applies rules and bodies to shapes, down to the terminals.
#pragma once

#include "grammars/derivation/evaluate.h"
#include "grammars/derivation/run.h"

namespace citykiln::grammars {

/// Applies a rule to a shape. `slots` begins with the arguments of the rule.
NodeTrace apply_rule(Run& run, Shape&& shape, const Rule& rule, Slots slots, int depth, std::uint32_t parent_path);

/// Ends the shape as a terminal of this name; a shape without surface is dropped.
NodeTrace end_as_terminal(Run& run, Shape&& shape, const std::string& name, std::uint32_t path);

}  // namespace citykiln::grammars
