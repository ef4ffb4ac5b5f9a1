// Derives an L-system: rewrites its axiom for n steps to a string of modules.
//
//   axiom ── step ──► string ── step ──► string …      a step rewrites all modules in parallel, then decomposes the
//                                                      result, then answers queries; two buffers alternate
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "lsystems/lsystem.h"
#include "lsystems/rewriting/environment.h"
#include "lsystems/rewriting/module_string.h"

namespace citykiln::lsystems {

/// Limits of a derivation. They are counts rather than seconds, so every machine stops at the same module.
struct Limits {
  std::uint64_t symbols = 8'000'000;  ///< Modules in a string, with at most four times as many values. Capped at 2^27.
  std::uint64_t written = 400'000'000;  ///< Modules in all strings of a derivation together.
  std::uint64_t steps = 100'000;
  /// Tested rules, and executed instructions of their conditions and values. Productions, decompositions and each
  /// interpretation are counted separately.
  std::uint64_t work = 4'000'000'000;
};

/// The inputs of a derivation beside the L-system.
struct DeriveOptions {
  std::optional<int> steps = {};           ///< The number of steps; empty: the number in the file.
  std::optional<std::uint64_t> seed = {};  ///< The seed of random numbers; empty: the seed in the file.
  StableId plant{};                        ///< The key of the plant's random numbers.
  Limits limits = {};
  Environment environment = {};
};

/// An expression or module without a defined result, with the action taken instead. There is one for each position and
/// text.
struct Warning {
  TextPosition place;
  std::string message;
  std::uint64_t times = 0;
};

/// The member of Limits that ended a derivation.
enum class LimitKind : std::uint8_t { kSymbols, kWritten, kSteps, kWork };

/// The limit that ended a derivation. The derivation then has the string of the last completed pass: that of the step
/// before if a production exceeded the limit; that of this step, not fully decomposed or with queries that are not
/// answered, if a decomposition or the interpretation for a query exceeded it.
struct LimitExceeded {
  LimitKind kind = LimitKind::kSymbols;
  std::uint64_t limit = 0;
  int step = 0;  ///< The step that was not completed, from 1.
};

/// The result of derive() or interpret().
struct Derivation {
  ModuleString string;
  int steps = 0;              ///< Completed steps.
  std::uint64_t written = 0;  ///< Modules in all strings.
  std::vector<Warning> warnings;
  std::optional<LimitExceeded> limit_exceeded;
};

/// Rewrites the axiom for a number of steps.
///
/// Applies the first rule of a module that matches (contexts, then condition). If that rule has a probability, one rule
/// is drawn from it and all later matching rules with a probability, with the probabilities as weights. A module
/// without a matching rule is copied. The module % removes the rest of its branch in the step after the one that wrote
/// it.
///
/// Guarantees: deterministic on any machine; random numbers are functions of (seed, plant, step, position in the
/// string); brackets are balanced; every value is finite. An undefined value (1/0) becomes 0, with a warning; a limit
/// ends the derivation. Cost: O(modules written), no allocation per module. Memory: two strings, and 20 bytes a module
/// if rules have contexts.
Derivation derive(const LSystem& system, const DeriveOptions& options = {});

/// Applies the interpretation rules up to their depth (`maximum depth` of the file). Returns the string for the turtle.
///
/// @param string  The result of derive() with this system.
Derivation interpret(const LSystem& system, const ModuleString& string, const DeriveOptions& options = {});

/// Returns a warning as a line: "x.lsys:12:5: message (3 times)".
std::string warning_line(const LSystem& system, const Warning& warning);
/// Returns an exceeded limit as text: "the string would have more than 8000000 symbols".
std::string limit_text(const LimitExceeded& exceeded);
/// Returns an exceeded limit as a line: "x.lsys: stopped at step 9: the string would have more than 8000000 symbols".
std::string limit_line(const LSystem& system, const LimitExceeded& exceeded);

}  // namespace citykiln::lsystems
