#include "lsystems/rewriting/rewrite.h"

#include <algorithm>
#include <cmath>

#include "lsystems/evaluate.h"
#include "lsystems/reading/read_lsystem.h"

namespace citykiln::lsystems {
namespace {

// A position in the string that is rewritten.
struct Spot {
  std::size_t at = 0, value = 0;
};

struct Step {
  Rewriter& rewriter;
  const ModuleBuffer& in;
  const RandomSequence& chance;
  ModuleBuffer& out;
  RandomSource random;
  const double* slots = nullptr;  // of the rule that was tested last

  void spend(std::uint64_t work) { rewriter.work_left -= std::min(work, rewriter.work_left); }

  // tests contexts and condition; afterwards `slots` and `random` are the rule's
  bool fits(const Rule& rule, Spot spot) {
    spend(1 + rule.left.count + rule.right.count + rule.condition.count + rule.probability.count);
    slots = in.room.values.data() + spot.value;
    // draw 0 chooses between rules
    random = {&chance, static_cast<std::uint32_t>(spot.at), 1};
    if (rule.left.count + rule.right.count > 0) {
      if (!contexts_fit(rewriter.system, rule, in.kinds(), in.values(), rewriter.neighbours,
                        static_cast<std::uint32_t>(spot.at), rewriter.slots.data()))
        return false;
      slots = rewriter.slots.data();
    }
    if (!rule.has_condition) return true;
    const double truth = evaluate(rewriter.system, rule.condition, slots, random);
    return truth != 0 && !std::isnan(truth);
  }

  double weight(const Rule& rule) {
    const double share = evaluate(rewriter.system, rule.probability, slots, random);
    return share > 0 && std::isfinite(share) ? share : 0;
  }

  // draws one of the matching rules with a probability, from `first` on
  const Rule* drawn(const Rule* first, const Rule* end, Spot spot) {
    double sum = 0;
    for (const Rule* rule = first; rule != end; ++rule)
      if (rule->has_probability && fits(*rule, spot)) sum += weight(*rule);
    double left = sum * chance.unit(static_cast<std::uint32_t>(spot.at) * kDrawsPerModule);
    const Rule* last = nullptr;
    for (const Rule* rule = first; rule != end && sum > 0; ++rule) {
      if (!rule->has_probability || !fits(*rule, spot)) continue;
      const double share = weight(*rule);
      if (share == 0) continue;
      last = rule;
      if (left < share) return rule;
      left -= share;
    }
    // rounding may leave a rest after the last rule; testing it again restores its slots
    if (last != nullptr) fits(*last, spot), weight(*last);
    return last;
  }

  const Rule* chosen(Range rules, Spot spot) {
    const Rule* end = rewriter.set.rules.data() + rules.first + rules.count;
    for (const Rule* rule = end - rules.count; rule != end; ++rule) {
      if (!fits(*rule, spot)) continue;
      return rule->has_probability ? drawn(rule, end, spot) : rule;
    }
    return nullptr;
  }

  // the ] of the branch, or the end of the string
  Spot branch_end(Spot spot) const {
    const LSystem& system = rewriter.system;
    const auto kinds = in.kinds();
    for (int depth = 0; spot.at < kinds.size(); ++spot.at) {
      if (kinds[spot.at] == system.push) ++depth;
      if (kinds[spot.at] == system.pop && depth-- == 0) break;
      spot.value += system.kinds[kinds[spot.at]].arity;
    }
    return spot;
  }

  bool copy(Spot from, Spot to) {
    if (!out.make_room(to.at - from.at, to.value - from.value)) return false;
    out.append(in.kinds().subspan(from.at, to.at - from.at), in.values().subspan(from.value, to.value - from.value));
    return true;
  }

  Rewritten run();
};

Rewritten Step::run() {
  const LSystem& system = rewriter.system;
  const std::uint8_t* plain = rewriter.plain.data();
  const Kind* kinds = in.room.kinds.data();
  bool changed = false;
  // modules without a rule are copied in runs, from `kept` to the next application
  Spot kept, spot;
  while (spot.at < in.size) {
    const Kind kind = kinds[spot.at];
    if (plain[kind] != kActive) {
      spot.value += plain[kind];
      ++spot.at;
      continue;
    }
    const bool cuts = kind == system.cut;
    const Rule* rule = cuts ? nullptr : chosen(rewriter.set.of_kind[kind], spot);
    const Spot next = cuts ? branch_end(spot) : Spot{spot.at + 1, spot.value + system.kinds[kind].arity};
    if (rewriter.work_left == 0) return Rewritten::kTooMuchWork;
    if (cuts || rule != nullptr) {
      if (!copy(kept, spot)) return Rewritten::kTooLong;
      if (rule != nullptr) spend(rule->successor.code);
      if (!cuts && !write_successor(rewriter, rule->successor, slots, random, out)) return Rewritten::kTooLong;
      kept = next;
      changed = true;
    }
    spot = next;
  }
  if (!copy(kept, spot)) return Rewritten::kTooLong;
  return changed ? Rewritten::kChanged : Rewritten::kSame;
}

}  // namespace

void add_warning(std::vector<Warning>& warnings, TextPosition place, const char* message) {
  const auto known = std::find_if(warnings.begin(), warnings.end(), [&](const Warning& warning) {
    return warning.place.line == place.line && warning.place.column == place.column && warning.message == message;
  });
  if (known != warnings.end()) {
    ++known->times;
  } else if (warnings.size() < kMostWarnings) {
    warnings.push_back({place, message, 1});
  } else if (warnings.size() == kMostWarnings) {
    warnings.push_back({{}, "more warnings", 1});
  } else {
    ++warnings.back().times;
  }
}

Rewriter rewriter_of(const LSystem& system, const RuleSet& set, std::vector<Warning>& warnings, const Limits& limits) {
  Rewriter rewriter{system, set, warnings, {}, {}, {}, limits.work};
  rewriter.slots.resize((2 * kArityLimit + 1) * kArityLimit);
  for (const ModuleKind& kind : system.kinds) rewriter.plain.push_back(kind.arity);
  for (const Rule& rule : set.rules) rewriter.plain[rule.predecessor] = kActive;
  // decomposition and interpretation keep %, for the next step and the turtle
  if (&set == &system.productions) rewriter.plain[system.cut] = kActive;
  return rewriter;
}

bool write_successor(Rewriter& rewriter, const Successor& successor, const double* slots, RandomSource& random,
                     ModuleBuffer& out) {
  const LSystem& system = rewriter.system;
  if (!out.make_room(successor.kinds.count, successor.values.count)) return false;
  out.append(std::span(system.successor_kinds).subspan(successor.kinds.first, successor.kinds.count), {});
  const Value* value = system.values.data() + successor.values.first;
  double* to = out.room.values.data() + out.value_count;
  for (std::uint32_t i = 0; i < successor.values.count; ++i) {
    to[i] = evaluate(system, value[i], slots, random);
    if (std::isfinite(to[i])) continue;
    to[i] = 0;
    add_warning(rewriter.warnings, value[i].place, "no number comes of this: 0 stands for it");
  }
  out.value_count += successor.values.count;
  return true;
}

Rewritten rewrite(Rewriter& rewriter, const ModuleBuffer& in, const RandomSequence& chance, ModuleBuffer& out) {
  out.size = out.value_count = 0;
  if (rewriter.set.has_contexts) find_neighbours(rewriter.system, in.kinds(), rewriter.neighbours);
  Step step{rewriter, in, chance, out, {}};
  return step.run();
}

}  // namespace citykiln::lsystems
