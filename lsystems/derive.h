// From a system to the string of modules that it grows into.
//
//   axiom ── step ──► string ── step ──► string …      a step rewrites every module at once, then decomposes what came
//                                                      of it, then answers the ?-modules; two strings take turns
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

/// Counts, not seconds, so that every machine stops at the same module.
struct Limits {
  std::uint64_t symbols = 8'000'000;    ///< Of a string; four times as many numbers. At most 2^27.
  std::uint64_t written = 400'000'000;  ///< Of all strings of a derivation together.
  std::uint64_t steps = 100'000;
  std::uint64_t work = 4'000'000'000;  ///< Rules tried, and instructions of their conditions and values.
};

struct DeriveOptions {
  std::optional<int> steps = {};           ///< Else as many as the file says.
  std::optional<std::uint64_t> seed = {};  ///< Else the file's.
  StableId plant{};                        ///< Whose dice are thrown.
  Limits limits = {};
  Environment environment = {};
};

/// Something a rule asked for that cannot be, and what was done instead. Once a place and text.
struct Warning {
  TextPosition place;
  std::string message;
  std::uint64_t times = 0;
};

enum class LimitKind : std::uint8_t { kSymbols, kWritten, kSteps, kWork };

/// A derivation that ended early: its string is the last one that was whole.
struct LimitExceeded {
  LimitKind kind = LimitKind::kSymbols;
  std::uint64_t limit = 0;
  int step = 0;  ///< That was not finished, from 1.
};

struct Derivation {
  ModuleString string;
  int steps = 0;              ///< Finished.
  std::uint64_t written = 0;  ///< Symbols, in all strings together.
  std::vector<Warning> warnings;
  std::optional<LimitExceeded> cut;
};

/// Rewrites the axiom as often as asked.
///
/// Of a module's rules the first that fits (contexts, then condition) is applied; if it has a probability, it and all
/// that fit behind it and have one throw dice, by their shares of the sum. A module that no rule fits stays. % takes
/// the rest of its branch with it one step after it is written.
///
/// Guarantees: the same bytes for the same arguments on any machine; dice are drawn by (seed, plant, step, place in the
/// string); brackets are balanced; every number is finite. Total: a number without a value (1/0) is 0 and a trouble;
/// limits cut. Cost: O(symbols written), no allocation a module. Memory: two strings; with contexts, 20 bytes a symbol
/// more.
Derivation derive(const LSystem& system, const DeriveOptions& options = {});

/// The derivation's string as the turtle reads it: interpretation rules applied, up to their depth.
Derivation interpret(const LSystem& system, const ModuleString& string, const DeriveOptions& options = {});

/// "x.lsys:12:5: message (3 times)".
std::string warning_line(const LSystem& system, const Warning& warning);
/// "x.lsys: cut at step 9: its string would have more than 8000000 symbols".
std::string limit_line(const LSystem& system, const LimitExceeded& cut);

}  // namespace citykiln::lsystems
