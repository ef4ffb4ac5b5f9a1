#include "lsystems/rewriting/derive.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "lsystems/rewriting/rewrite.h"
#include "lsystems/rewriting/turtle.h"

namespace citykiln::lsystems {
namespace {

constexpr std::uint64_t kMostSymbols = 1u << 27;  // positions times kDrawsPerModule fit 32 bits

// The two string buffers, and the derivation so far.
struct DerivationState {
  const LSystem& system;
  const DeriveOptions& options;
  Derivation result;
  ModuleBuffer now, next;

  RandomSequence chance_of(const char* purpose, int step, int pass) const {
    const StableId of_step = stable_id(options.plant, purpose, static_cast<std::uint64_t>(step));
    return {options.seed.value_or(system.seed), of_step, pass == 0 ? "pass" : fmt::format("pass {}", pass).c_str()};
  }

  // sets next.most to the tighter of two limits, and returns which
  LimitKind tighter_limit() {
    const std::uint64_t symbols = std::min(options.limits.symbols, kMostSymbols);
    const std::uint64_t left = options.limits.written - std::min(options.limits.written, result.written);
    next.most = std::min(symbols, left);
    return symbols <= left ? LimitKind::kSymbols : LimitKind::kWritten;
  }

  void stop(LimitKind kind, int step) {
    const Limits& limits = options.limits;
    const std::uint64_t limit = kind == LimitKind::kSymbols   ? std::min(limits.symbols, kMostSymbols)
                                : kind == LimitKind::kWritten ? limits.written
                                : kind == LimitKind::kWork    ? limits.work
                                                              : limits.steps;
    result.limit_exceeded = LimitExceeded{kind, limit, step};
  }

  // one pass; returns whether the string changed and no limit was exceeded
  bool apply(Rewriter& rewriter, const char* purpose, int step, int pass) {
    const LimitKind limit = tighter_limit();
    const Rewritten became = rewrite(rewriter, now, chance_of(purpose, step, pass), next);
    if (became == Rewritten::kTooLong || became == Rewritten::kTooMuchWork) {
      stop(became == Rewritten::kTooLong ? limit : LimitKind::kWork, step);
      return false;
    }
    result.written += next.size;
    std::swap(now, next);
    return became == Rewritten::kChanged;
  }

  void decompose(Rewriter& rewriter, int step) {
    if (system.decomposition.rules.empty()) return;
    for (int pass = 0; pass < system.decomposition.most_depth && !result.limit_exceeded; ++pass)
      if (!apply(rewriter, "decomposition", step, pass)) return;
  }

  void begin(Rewriter& rewriter) {
    next.most = std::min(options.limits.symbols, kMostSymbols);
    const RandomSequence chance = chance_of("axiom", 0, 0);
    RandomSource random{&chance, 0, 0};
    if (!write_successor(rewriter, system.axiom, nullptr, random, next)) stop(LimitKind::kSymbols, 0);
    result.written += next.size;
    std::swap(now, next);
  }

  bool has_queries() const {
    return std::ranges::any_of(now.kinds(), [&](Kind kind) { return system.kinds[kind].name[0] == '?'; });
  }

  // sets the parameters of queries
  void answer(int step) {
    if (!system.has_queries || result.limit_exceeded || !has_queries()) return;
    const ModuleString string{{now.kinds().begin(), now.kinds().end()}, {now.values().begin(), now.values().end()}};
    // interpretations may move the turtle; they keep the queries and their order
    DeriveOptions rest = options;
    rest.limits.written -= std::min(rest.limits.written, result.written);
    const Derivation seen = interpret(system, string, rest);
    result.written += now.size + seen.written;
    if (seen.limit_exceeded) stop(seen.limit_exceeded->kind, step);
    const std::vector<double> answers = answers_to(system, seen.string, options.environment);
    std::size_t value = 0, answer = 0;
    for (const Kind kind : now.kinds()) {
      const int arity = system.kinds[kind].arity;
      if (system.kinds[kind].name[0] == '?')
        for (int i = 0; i < arity && answer < answers.size(); ++i) now.room.values[value + i] = answers[answer++];
      value += arity;
    }
  }

  Derivation finish() {
    now.room.kinds.resize(now.size);
    now.room.values.resize(now.value_count);
    result.string = std::move(now.room);
    return std::move(result);
  }
};

}  // namespace

Derivation derive(const LSystem& system, const DeriveOptions& options) {
  assert(system.productions.of_kind.size() == system.kinds.size());
  DerivationState state{system, options, {}, {}, {}};
  Rewriter productions = rewriter_of(system, system.productions, state.result.warnings, options.limits);
  Rewriter decomposition = rewriter_of(system, system.decomposition, state.result.warnings, options.limits);
  state.begin(productions);
  state.decompose(decomposition, 0);
  state.answer(0);
  const int steps = options.steps.value_or(system.steps);
  for (int step = 1; step <= steps && !state.result.limit_exceeded; ++step) {
    if (static_cast<std::uint64_t>(step) > options.limits.steps) {
      state.stop(LimitKind::kSteps, step);
      break;
    }
    state.apply(productions, "production", step, 0);
    if (state.result.limit_exceeded) break;
    state.decompose(decomposition, step);
    state.answer(step);
    if (!state.result.limit_exceeded) state.result.steps = step;
  }
  return state.finish();
}

Derivation interpret(const LSystem& system, const ModuleString& string, const DeriveOptions& options) {
  assert(std::ranges::all_of(string.kinds, [&](Kind kind) { return kind < system.kinds.size(); }));
  DerivationState state{system, options, {}, {}, {}};
  state.now.room = string;
  state.now.size = string.kinds.size();
  state.now.value_count = string.values.size();
  Rewriter rules = rewriter_of(system, system.interpretation, state.result.warnings, options.limits);
  if (!system.interpretation.rules.empty())
    for (int pass = 0; pass < system.interpretation.most_depth && !state.result.limit_exceeded; ++pass)
      if (!state.apply(rules, "interpretation", 0, pass)) break;
  return state.finish();
}

std::string warning_line(const LSystem& system, const Warning& warning) {
  const std::string times = warning.times == 1 ? "" : fmt::format(" ({} times)", warning.times);
  if (warning.place.line == 0) return fmt::format("{}: {}{}", system.file, warning.message, times);
  return fmt::format("{}:{}:{}: {}{}", system.file, warning.place.line, warning.place.column, warning.message, times);
}

std::string limit_text(const LimitExceeded& exceeded) {
  if (exceeded.kind == LimitKind::kSteps) return fmt::format("a derivation has at most {} steps", exceeded.limit);
  if (exceeded.kind == LimitKind::kWork)
    return fmt::format("the derivation would need more than {} rule tests and operations", exceeded.limit);
  if (exceeded.kind == LimitKind::kWritten)
    return fmt::format("the derivation would write more than {} symbols in total", exceeded.limit);
  return fmt::format("the string would have more than {} symbols", exceeded.limit);
}

std::string limit_line(const LSystem& system, const LimitExceeded& exceeded) {
  return fmt::format("{}: stopped at step {}: {}", system.file, exceeded.step, limit_text(exceeded));
}

}  // namespace citykiln::lsystems
