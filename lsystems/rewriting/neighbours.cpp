#include "lsystems/rewriting/neighbours.h"

#include <algorithm>
#include <cassert>

namespace citykiln::lsystems {
namespace {

void find_left(const LSystem& system, std::span<const Kind> kinds, Neighbours& to) {
  std::vector<std::uint32_t> stack;
  std::uint32_t last = kNowhere, value = 0;
  for (std::uint32_t i = 0; i < kinds.size(); ++i) {
    const ModuleKind& kind = system.kinds[kinds[i]];
    to.left[i] = last;
    to.value[i] = value;
    value += kind.arity;
    if (kinds[i] == system.push) {
      stack.push_back(last);
    } else if (kinds[i] == system.pop) {
      last = stack.back();
      stack.pop_back();
    } else if (!kind.ignored) {
      last = i;
    }
  }
}

struct Ahead {
  std::uint32_t axis = kNowhere, branch = kNowhere, close = kNowhere;
};

void find_right(const LSystem& system, std::span<const Kind> kinds, Neighbours& to) {
  std::vector<Ahead> stack;
  Ahead ahead;
  const auto n = static_cast<std::uint32_t>(kinds.size());
  to.axis[n] = to.branch[n] = kNowhere;
  for (std::uint32_t i = n; i-- > 0;) {
    if (kinds[i] == system.pop) {
      ahead.close = i;
      stack.push_back(ahead);
      ahead = {};
    } else if (kinds[i] == system.push) {
      ahead = stack.back();
      stack.pop_back();
      to.close[i] = ahead.close;
      ahead.branch = i;
    } else if (!system.kinds[kinds[i]].ignored) {
      ahead.axis = i;
      ahead.branch = kNowhere;
    }
    // a right context ends at a ]
    to.axis[i] = kinds[i] == system.pop ? kNowhere : ahead.axis;
    to.branch[i] = kinds[i] == system.pop ? kNowhere : ahead.branch;
  }
}

struct Match {
  const LSystem& system;
  std::span<const Kind> pattern;  // of the right context
  std::span<const Kind> kinds;
  std::span<const double> values;
  const Neighbours& neighbours;

  double* bind(std::uint32_t at, double* slots) const {
    const int arity = system.kinds[kinds[at]].arity;
    return std::copy_n(values.data() + neighbours.value[at], arity, slots);
  }

  // the ] of the pattern's branch that begins at `item`
  std::size_t closing(std::size_t item) const {
    for (int depth = 0; item < pattern.size(); ++item) {
      if (pattern[item] == system.push) ++depth;
      if (pattern[item] == system.pop && --depth == 0) break;
    }
    return item;
  }

  // matches a branch of the pattern with those that begin at `from`, which moves behind the matching one
  bool branch_fits(std::size_t item, std::uint32_t& from, double*& slots) const {
    for (int scanned = 0; scanned < kBranchScan; ++scanned) {
      const std::uint32_t open = neighbours.branch[from];
      if (open == kNowhere) return false;
      double* bound = slots;
      from = neighbours.close[open] + 1;
      if (fits(item + 1, open + 1, bound)) {
        slots = bound;
        return true;
      }
    }
    return false;
  }

  // matches the pattern from `item` to the end of its branch with the string from position `from`
  bool fits(std::size_t item, std::uint32_t from, double*& slots) const {
    while (item < pattern.size() && pattern[item] != system.pop) {
      if (pattern[item] == system.push) {
        if (!branch_fits(item, from, slots)) return false;
        item = closing(item) + 1;
        continue;
      }
      const std::uint32_t next = neighbours.axis[from];
      if (next == kNowhere || kinds[next] != pattern[item]) return false;
      slots = bind(next, slots);
      from = next + 1;
      ++item;
    }
    return true;
  }
};

}  // namespace

void find_neighbours(const LSystem& system, std::span<const Kind> kinds, Neighbours& neighbours) {
  const std::size_t n = kinds.size();
  neighbours.left.resize(n);
  neighbours.value.resize(n);
  neighbours.close.resize(n);
  neighbours.axis.resize(n + 1);
  neighbours.branch.resize(n + 1);
  find_left(system, kinds, neighbours);
  find_right(system, kinds, neighbours);
}

bool contexts_fit(const LSystem& system, const Rule& rule, std::span<const Kind> kinds, std::span<const double> values,
                  const Neighbours& neighbours, std::uint32_t at, double* slots) {
  assert(at < kinds.size() && neighbours.left.size() == kinds.size());
  const auto pattern = [&](Range range) { return std::span(system.contexts).subspan(range.first, range.count); };
  const Match match{system, pattern(rule.right), kinds, values, neighbours};
  const std::span<const Kind> left = pattern(rule.left);
  double* end = slots + rule.predecessor_slot;
  std::uint32_t ancestor = neighbours.left[at];
  for (std::size_t i = left.size(); i-- > 0; ancestor = neighbours.left[ancestor]) {
    if (ancestor == kNowhere || kinds[ancestor] != left[i]) return false;
    end -= system.kinds[left[i]].arity;
    match.bind(ancestor, end);
  }
  match.bind(at, slots + rule.predecessor_slot);
  double* right = slots + rule.right_slot;
  return match.fits(0, at + 1, right);
}

}  // namespace citykiln::lsystems
