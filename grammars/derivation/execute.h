// Rules and bodies applied to shapes, down to the terminals.
#pragma once

#include "grammars/derivation/evaluate.h"
#include "grammars/derivation/run.h"

namespace citykiln::grammars {

/// Applies a rule to a shape whose id is set. `frame` begins with the rule's arguments.
Outcome apply_rule(Run& run, Shape&& shape, const Rule& rule, Frame frame, int depth, std::uint32_t parent_path);

/// Runs a body's statements on the node's current shape. `last`: nothing comes after them, so that the last successor
/// may have the shape itself.
void run_body(Execution& execution, const Body& body, bool last);

/// The shape as a terminal of this name.
Outcome end_as_terminal(Run& run, Shape&& shape, const std::string& name, std::uint32_t path);

inline Context context_of(Execution& execution) {
  return {execution.run, execution.shape, execution.frame, execution.dice};
}

}  // namespace citykiln::grammars
