#include "lsystems/evaluate.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "compiler/geometry/mathematics.h"

namespace citykiln::lsystems {
namespace {

// The remainder with the sign of a, as C's %.
double remainder_of(double a, double b) { return b == 0 ? a / b : std::fmod(a, b); }

// Box and Muller, "A note on the generation of random normal deviates", 1958.
double normal(double mean, double deviation, RandomSource& random) {
  const double far = std::sqrt(-2 * logarithm(1 - random.next()));
  return mean + deviation * far * cosine(360 * random.next());
}

double value_of(Op op, double a, [[maybe_unused]] double b) {
  switch (op) {
#define OPERATOR(name, priority, text, code) \
  case Op::name:                             \
    return code;
#define FUNCTION(name, arity, op, code) \
  case Op::op:                          \
    return code;
#include "lsystems/operations.inc"
    default:
      return 0;
  }
}

int arity_of(Op op) {
  switch (op) {
#define OPERATOR(name, priority, text, code) \
  case Op::name:                             \
    return 2;
#define FUNCTION(name, arity, op, code) \
  case Op::op:                          \
    return arity;
#include "lsystems/operations.inc"
    case Op::kNormalRandom:
      return 2;
    default:
      return 1;
  }
}

double applied(Op op, double a, double b, RandomSource& random) {
  switch (op) {
    case Op::kNegative:
      return -a;
    case Op::kNot:
      return a == 0 ? 1 : 0;
    case Op::kRandom:
      return a * random.next();
    case Op::kNormalRandom:
      return normal(a, b, random);
    default:
      break;
  }
  // powers and functions are undefined for NaN and infinity
  if (op >= Op::kPower && !(std::isfinite(a) && std::isfinite(b))) return std::numeric_limits<double>::quiet_NaN();
  return value_of(op, a, b);
}

}  // namespace

double run(const Instruction* code, std::uint32_t count, const double* slots, RandomSource& random) {
  assert(count > 0);
  double stack[kStackLimit];
  int top = 0;
  for (const Instruction* at = code; at != code + count; ++at) {
    if (at->op == Op::kConstant) {
      stack[top++] = at->constant;
    } else if (at->op == Op::kSlot) {
      stack[top++] = slots[at->slot];
    } else if (arity_of(at->op) == 1) {
      stack[top - 1] = applied(at->op, stack[top - 1], 0, random);
    } else {
      --top;
      stack[top - 1] = applied(at->op, stack[top - 1], stack[top], random);
    }
  }
  return stack[0];
}

}  // namespace citykiln::lsystems
