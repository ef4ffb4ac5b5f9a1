// Numbers of successors, conditions and probabilities.
#pragma once

#include "lsystems/lsystem.h"
#include "lsystems/random_source.h"

namespace citykiln::lsystems {

/// How many numbers an expression may hold at once; the reader refuses those that need more.
inline constexpr int kStackLimit = 64;

/// Runs code that the reader made. Only + - * / and the square root, so the same bits on every CPU. What has no value
/// (1/0, the root of -1) is infinite or no number: the caller decides. Allocates nothing. O(count).
double run(const Instruction* code, std::uint32_t count, const double* slots, RandomSource& dice);

inline double evaluate(const LSystem& system, const Value& value, const double* slots, RandomSource& dice) {
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
      return run(system.code.data() + value.first, value.count, slots, dice);
  }
}

}  // namespace citykiln::lsystems
