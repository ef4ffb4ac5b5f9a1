// Derivation: from an L-system to the string of modules after n steps.
//
//   axiom ── step ──► string ── step ──► string …      a step rewrites all modules in parallel, then decomposes the
//                                                      result, then answers queries; two buffers alternate
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "lsystems/environment.h"
#include "lsystems/lsystem.h"
#include "lsystems/module_string.h"

namespace citykiln::lsystems {

/// Limits of a derivation: counts, not seconds, so that every machine stops at the same module.
struct Limits {
  std::uint64_t symbols = 8'000'000;    ///< In a string; four times as many values. Capped at 2^27.
  std::uint64_t written = 400'000'000;  ///< In all strings of a derivation.
  std::uint64_t steps = 100'000;
  std::uint64_t work = 4'000'000'000;  ///< Rules tested, and instructions of their conditions and values.
};

struct DeriveOptions {
  std::optional<int> steps = {};           ///< Default: the file's.
  std::optional<std::uint64_t> seed = {};  ///< Default: the file's.
  StableId plant{};                        ///< Key of the random numbers.
  Limits limits = {};
  Environment environment = {};
};

/// Something in the text or string without a defined result, and what was done instead. One for each position and text.
struct Warning {
  TextPosition place;
  std::string message;
  std::uint64_t times = 0;
};

enum class LimitKind : std::uint8_t { kSymbols, kWritten, kSteps, kWork };

/// The limit that ended a derivation; its string is then the last complete one.
struct LimitExceeded {
  LimitKind kind = LimitKind::kSymbols;
  std::uint64_t limit = 0;
  int step = 0;  ///< The incomplete step, from 1.
};

struct Derivation {
  ModuleString string;
  int steps = 0;              ///< Completed.
  std::uint64_t written = 0;  ///< Modules in all strings.
  std::vector<Warning> warnings;
  std::optional<LimitExceeded> limit_exceeded;
};

/// Rewrites the axiom for a number of steps.
///
/// The first rule of a module that matches (contexts, then condition) is applied. If it has a probability, one of it
/// and all later matching rules with a probability is drawn, with the probabilities as weights. A module without a
/// matching rule is copied. % removes the rest of its branch in the step after it is written.
///
/// Guarantees: the same bytes for the same arguments on any machine; random numbers are functions of (seed, plant,
/// step, position in the string); brackets are balanced; every value is finite. Total: an undefined value (1/0) becomes
/// 0 and a warning; a limit ends the derivation. Cost: O(modules written), no allocation per module. Memory: two
/// strings, and 20 bytes a module if rules have contexts.
Derivation derive(const LSystem& system, const DeriveOptions& options = {});

/// Applies the interpretation rules up to their depth. Returns the string for the turtle.
///
/// @param string  Of derive() with the same system.
Derivation interpret(const LSystem& system, const ModuleString& string, const DeriveOptions& options = {});

/// "x.lsys:12:5: message (3 times)".
std::string warning_line(const LSystem& system, const Warning& warning);
/// "x.lsys: stopped at step 9: the string would have more than 8000000 symbols".
std::string limit_line(const LSystem& system, const LimitExceeded& exceeded);

}  // namespace citykiln::lsystems
