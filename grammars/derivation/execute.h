// Applies rules to shapes until only terminals are left: shapes without a rule, which are the result. A node is one
// application of a rule to a shape. Its trace (NodeTrace) has the displacement between the node's surface and its
// result, and the appearances of the result.
#pragma once

#include "grammars/derivation/evaluate.h"

namespace citykiln::grammars {

/// Applies a rule to a shape, adds the terminals of the result to run.out, and returns the trace of the node.
/// @param slots        The arguments of the rule, in order. Locals of the rule are stored behind them.
/// @param depth        The number of rules in which this one is nested.
/// @param parent_path  An index into Derivation::paths: the rule names from the start to the parent of this node.
NodeTrace apply_rule(Run& run, Shape&& shape, const Rule& rule, Slots slots, int depth, std::uint32_t parent_path);

/// Adds the shape to run.out as a terminal, and returns the trace of its node. A shape without surface is left out.
/// @param path  An index into Derivation::paths: the rule names from the start to the terminal, `name` included.
NodeTrace end_as_terminal(Run& run, Shape&& shape, const std::string& name, std::uint32_t path);

}  // namespace citykiln::grammars
