// Reads expressions by precedence climbing, as postfix code at the end of LSystem::code. Constants are folded, so that
// common values end as one of ValueForm's short forms.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "lsystems/evaluate.h"
#include "lsystems/reading/read_lsystem.h"
#include "lsystems/reading/reader.h"

namespace citykiln::lsystems {
namespace {

struct OperatorRow {
  std::string_view text;
  int priority;
  Op op;
};
struct FunctionRow {
  std::string_view name;
  int arity;
  Op op;
};

constexpr OperatorRow kOperators[] = {
#define OPERATOR(name, priority, text, code) {text, priority, Op::name},
#include "lsystems/operations.inc"
};

constexpr FunctionRow kFunctions[] = {
#define FUNCTION(name, arity, op, code) {name, arity, Op::op},
#include "lsystems/operations.inc"
    {"ran", 1, Op::kRandom},
    {"nran", 2, Op::kNormalRandom},
};

void read_binary(Reader& reader, int priority);

void emit(Reader& reader, Instruction instruction) { reader.system.code.push_back(instruction); }

// Appends an operation; folds it if its `arity` operands are constants.
void emit_applied(Reader& reader, Op op, int arity) {
  auto& code = reader.system.code;
  emit(reader, {op, 0, 0});
  if (op == Op::kRandom || op == Op::kNormalRandom || static_cast<int>(code.size()) < arity + 1) return;
  const auto first = code.end() - arity - 1;
  if (!std::all_of(first, code.end() - 1, [](const Instruction& i) { return i.op == Op::kConstant; })) return;
  RandomSource unused;
  const double value = run(&*first, static_cast<std::uint32_t>(arity + 1), nullptr, unused);
  code.erase(first, code.end());
  emit(reader, {Op::kConstant, 0, value});
}

void read_number(Reader& reader) {
  double number = 0;
  const char* from = reader.text.data() + reader.at;
  const auto [to, error] = std::from_chars(from, reader.text.data() + reader.end, number);
  if (error != std::errc() || !std::isfinite(number))
    return reader.fail(reader.place(), "expected a number that a double can hold");
  reader.at += static_cast<std::size_t>(to - from);
  emit(reader, {Op::kConstant, 0, number});
}

void read_arguments(Reader& reader, const FunctionRow& function) {
  for (int i = 0; i < function.arity; ++i) {
    if (i > 0) reader.expect(",", fmt::format("and another argument of '{}'", function.name));
    read_binary(reader, 0);
  }
  reader.expect(")",
                fmt::format("after the {} of '{}'", function.arity == 1 ? "argument" : "arguments", function.name));
}

void read_call(Reader& reader, const std::string& name, TextPosition place) {
  const auto* function = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                      [&](const FunctionRow& row) { return row.name == name; });
  if (function == std::end(kFunctions)) return reader.fail(place, fmt::format("there is no function '{}'", name));
  const bool is_random = function->op == Op::kRandom || function->op == Op::kNormalRandom;
  if (is_random && !reader.may_draw) return reader.fail(place, "expected a constant, found a random draw");
  reader.draws += is_random ? function->arity : 0;
  read_arguments(reader, *function);
  emit_applied(reader, function->op, function->arity);
}

void read_named(Reader& reader) {
  const TextPosition place = reader.place();
  const std::string name = take_name(reader);
  if (reader.accept("(")) return read_call(reader, name, place);
  const auto slot = std::find(reader.slots.begin(), reader.slots.end(), name);
  if (slot != reader.slots.end())
    return emit(reader, {Op::kSlot, static_cast<std::uint16_t>(slot - reader.slots.begin()), 0});
  const auto constant = reader.constants.find(name);
  if (constant == reader.constants.end()) return reader.fail(place, fmt::format("'{}' is not defined", name));
  emit(reader, {Op::kConstant, 0, constant->second});
}

void read_primary(Reader& reader) {
  reader.skip_space();
  if (is_digit(reader.peek()) || (reader.peek() == '.' && is_digit(reader.peek(1)))) return read_number(reader);
  if (is_letter(reader.peek()) || reader.peek() == '_') return read_named(reader);
  if (!reader.accept("(")) return reader.fail_expected("a value");
  read_binary(reader, 0);
  reader.expect(")", "that closes the parenthesis");
}

// Powers bind more than signs: -2^2 is -4.
void read_signed(Reader& reader) {
  reader.skip_space();
  if (!at_arrow(reader) && reader.accept("-")) {
    read_binary(reader, 7);
    emit_applied(reader, Op::kNegative, 1);
  } else if (!reader.starts_with("!=") && reader.accept("!")) {
    read_binary(reader, 7);
    emit_applied(reader, Op::kNot, 1);
  } else {
    read_primary(reader);
  }
}

// The operator with the longest spelling that is next, or null.
const OperatorRow* operator_here(const Reader& reader, std::string_view& spelled) {
  const OperatorRow* best = nullptr;
  for (const OperatorRow& row : kOperators) {
    for (std::string_view rest = row.text; !rest.empty();) {
      const std::string_view word = rest.substr(0, rest.find(' '));
      rest.remove_prefix(std::min(rest.size(), word.size() + 1));
      if (!reader.starts_with(word) || (best != nullptr && spelled.size() >= word.size())) continue;
      best = &row;
      spelled = word;
    }
  }
  return best;
}

void read_binary(Reader& reader, int priority) {
  if (++reader.depth > kNestingLimit) reader.fail(reader.place(), fmt::format("nested deeper than {}", kNestingLimit));
  read_signed(reader);
  while (!reader.failed) {
    reader.skip_space();
    std::string_view spelled;
    const OperatorRow* row = operator_here(reader, spelled);
    if (row == nullptr || row->priority < priority || at_arrow(reader)) break;
    reader.at += spelled.size();
    // powers associate to the right, other operators to the left
    read_binary(reader, row->op == Op::kPower ? row->priority : row->priority + 1);
    emit_applied(reader, row->op, 2);
  }
  --reader.depth;
}

// The stack size that the code needs.
int most_held(const Instruction* code, std::uint32_t count) {
  int held = 0, most = 0;
  for (const Instruction* at = code; at != code + count; ++at) {
    const bool pushes = at->op == Op::kConstant || at->op == Op::kSlot;
    const auto* function = std::find_if(std::begin(kFunctions), std::end(kFunctions),
                                        [&](const FunctionRow& row) { return row.op == at->op; });
    const bool one =
        at->op == Op::kNegative || at->op == Op::kNot || (function != std::end(kFunctions) && function->arity == 1);
    held += pushes ? 1 : (one ? 0 : -1);
    most = std::max(most, held);
  }
  return most;
}

// x * c, c * x, x + c, c + x, x - c
bool take_short_form(Value& value, const Instruction* code) {
  const bool slot_first = code[0].op == Op::kSlot && code[1].op == Op::kConstant;
  const bool slot_second = code[0].op == Op::kConstant && code[1].op == Op::kSlot;
  const Op op = code[2].op;
  const bool turns = op == Op::kMultiply || op == Op::kAdd;
  if (!(slot_first && (turns || op == Op::kSubtract)) && !(slot_second && turns)) return false;
  value.form = op == Op::kMultiply ? ValueForm::kSlotTimes : ValueForm::kSlotPlus;
  value.slot = code[slot_first ? 0 : 1].slot;
  value.constant = code[slot_first ? 1 : 0].constant;
  if (op == Op::kSubtract) value.constant = -value.constant;
  return true;
}

// Replaces the code by a short form if there is one.
Value with_form(Reader& reader, Value value) {
  auto& code = reader.system.code;
  const Instruction* first = code.data() + value.first;
  bool is_short = value.count == 3 && take_short_form(value, first);
  if (value.count == 1) {
    is_short = true;
    value.form = first->op == Op::kSlot ? ValueForm::kSlot : ValueForm::kConstant;
    value.slot = first->slot;
    value.constant = first->constant;
  }
  if (!is_short) return value;
  code.resize(value.first);
  value.count = 0;
  return value;
}

}  // namespace

Value read_value(Reader& reader) {
  reader.skip_space();
  Value value;
  value.place = reader.place();
  value.form = ValueForm::kCode;
  value.first = static_cast<std::uint32_t>(reader.system.code.size());
  read_binary(reader, 0);
  if (reader.failed) return {};
  value.count = static_cast<std::uint32_t>(reader.system.code.size()) - value.first;
  if (most_held(reader.system.code.data() + value.first, value.count) > kStackLimit)
    reader.fail(value.place, fmt::format("needs more than {} numbers at once", kStackLimit));
  value = with_form(reader, value);
  if (value.form == ValueForm::kConstant && !std::isfinite(value.constant))
    reader.fail(value.place, "expected a number; this constant has no value");
  return value;
}

double read_constant(Reader& reader, std::string_view what) {
  const bool could_draw = std::exchange(reader.may_draw, false);
  reader.skip_space();
  const TextPosition place = reader.place();
  const Value value = read_value(reader);
  reader.may_draw = could_draw;
  if (!reader.failed && value.form != ValueForm::kConstant)
    reader.fail(place, fmt::format("expected {}, a constant number", what));
  return value.constant;
}

}  // namespace citykiln::lsystems
