// Evaluates expressions in successors, conditions and probabilities. A slot is the place of a parameter of a rule.
#pragma once

#include "lsystems/lsystem.h"
#include "lsystems/random_source.h"

namespace citykiln::lsystems {

/// The largest stack of an expression. The reader rejects expressions that need more.
inline constexpr int kStackLimit = 64;

/// Evaluates postfix code. Uses only + - * / and the square root, so results have the same bits on every CPU. An
/// undefined value (1/0, the root of -1) is infinite or NaN. Allocates nothing. O(count).
///
/// @param code  `count` instructions, > 0, made by read_value().
/// @param slots  The values of the rule's parameters.
double run(const Instruction* code, std::uint32_t count, const double* slots, RandomSource& random);

/// Returns the value of an expression; common forms need no code.
/// @param slots  The values of the rule's parameters.
inline double evaluate(const LSystem& system, const Value& value, const double* slots, RandomSource& random) {
  switch (value.form) {
    case ValueForm::kConstant:
      return value.constant;
    case ValueForm::kSlot:
      return slots[value.slot];
    case ValueForm::kSlotTimes:
      return slots[value.slot] * value.constant;
    case ValueForm::kSlotPlus:
      return slots[value.slot] + value.constant;
    default:
      return run(system.code.data() + value.first, value.count, slots, random);
  }
}

}  // namespace citykiln::lsystems
