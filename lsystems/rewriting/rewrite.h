// Parallel rewriting of a string by a rule set.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "lsystems/random_source.h"
#include "lsystems/rewriting/derive.h"
#include "lsystems/rewriting/module_string.h"
#include "lsystems/rewriting/neighbours.h"

namespace citykiln::lsystems {

/// A string that modules are appended to.
struct ModuleBuffer {
  ModuleString room;  ///< The allocated arrays, whose first `size` and `value_count` entries are the string.
  std::size_t size = 0, value_count = 0;
  std::size_t most = 0;  ///< The limit of symbols. The limit of values is four times as large.

  std::span<const Kind> kinds() const { return {room.kinds.data(), size}; }
  std::span<const double> values() const { return {room.values.data(), value_count}; }

  /// Allocates memory for more symbols and values. Returns false if their number would exceed the limit.
  bool make_room(std::size_t symbols, std::size_t values) {
    if (size + symbols <= room.kinds.size() && value_count + values <= room.values.size())
      return size + symbols <= most;
    return grow(symbols, values);
  }

  bool grow(std::size_t symbols, std::size_t values) {
    if (size + symbols > most || value_count + values > 4 * most) return false;
    const auto larger = [](std::size_t had, std::size_t needed, std::size_t limit) {
      return needed <= had ? had : std::min(limit, std::max(2 * needed, std::size_t{256}));
    };
    room.kinds.resize(larger(room.kinds.size(), size + symbols, std::max(most, size + symbols)));
    room.values.resize(larger(room.values.size(), value_count + values, std::max(4 * most, value_count + values)));
    return true;
  }

  /// Appends modules. make_room() must have succeeded for their number.
  void append(std::span<const Kind> kinds, std::span<const double> values) {
    if (!kinds.empty()) std::memcpy(room.kinds.data() + size, kinds.data(), kinds.size_bytes());
    if (!values.empty()) std::memcpy(room.values.data() + value_count, values.data(), values.size_bytes());
    size += kinds.size();
    value_count += values.size();
  }
};

/// The state that is kept between passes. A pass rewrites the whole string once.
struct Rewriter {
  const LSystem& system;
  const RuleSet& set;
  std::vector<Warning>& warnings;
  Neighbours neighbours;
  std::vector<double> slots;  ///< The parameters of a rule with contexts.
  /// By kind: its arity if modules of the kind are only copied; kActive if rules or % may change them.
  std::vector<std::uint8_t> plain;
  std::uint64_t work_left = 0;  ///< The remaining part of Limits::work.
};

inline constexpr std::uint8_t kActive = 0xff;

/// Returns the state before the first pass of a rule set.
Rewriter rewriter_of(const LSystem& system, const RuleSet& set, std::vector<Warning>& warnings, const Limits& limits);

/// The outcome of a pass.
enum class Rewritten : std::uint8_t { kSame, kChanged, kTooLong, kTooMuchWork };

/// Rewrites `in` into `out`. Returns kTooLong if the result exceeds out.most symbols, and kTooMuchWork if work_left
/// reaches 0; `out` is then incomplete.
/// @param chance  The random numbers of this pass.
Rewritten rewrite(Rewriter& rewriter, const ModuleBuffer& in, const RandomSequence& chance, ModuleBuffer& out);

/// Appends a successor to `out`. Returns false if the successor exceeds out.most symbols.
bool write_successor(Rewriter& rewriter, const Successor& successor, const double* slots, RandomSource& random,
                     ModuleBuffer& out);

/// Adds a warning, or counts it again. Keeps at most kMostWarnings different warnings; all others are counted as one
/// warning without position.
void add_warning(std::vector<Warning>& warnings, TextPosition place, const char* message);
inline constexpr std::size_t kMostWarnings = 100;

}  // namespace citykiln::lsystems
