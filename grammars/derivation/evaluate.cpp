#include "grammars/derivation/evaluate.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "compiler/geometry/mathematics.h"
#include "grammars/language/builtin.h"
#include "grammars/language/text.h"
#include "grammars/shapes/measure.h"

namespace citykiln::grammars {
namespace {

/// A random number that is only compared with bounds.
struct Drawn {
  double value = 0;  ///< unit · scale.
  double scale = 1;
  std::uint32_t index = 0;
};

/// An interval of Drawn::value.
struct DrawRange {
  double low = -HUGE_VAL, high = HUGE_VAL;
};

double unit_at(Context& context, std::uint32_t index) {
  const RandomSource& random = context.random;
  const StableId id = random.of_shape ? context.run.id_of(random.node) : context.run.initial.id;
  return RandomSequence(context.run.options.seed, id, random.purpose).unit(index);
}

Drawn draw(Context& context, double scale) {
  RandomSource& random = context.random;
  const std::uint32_t index = random.next++;
  return {unit_at(context, index) * scale, scale, index};
}

// Records that every number in the interval would have the same effect.
void record(Context& context, const Drawn& drawn, DrawRange same) {
  const RandomSource& random = context.random;
  if (!random.of_shape) return;
  context.run.record_draw(
      {.node = random.node, .index = drawn.index, .scale = drawn.scale, .low = same.low, .high = same.high});
}

double finite(double number, TextPosition position, Context& context) {
  if (std::isfinite(number)) return number;
  context.run.warn(position, "the value is not a number or too large");
  constexpr double kLargest = std::numeric_limits<double>::max();
  return std::isnan(number) ? 0.0 : std::clamp(number, -kLargest, kLargest);
}

// The number, if it is stored and needs no evaluation; else null. Avoids a copy of a Value.
const double* plain_number(const Expression& expression, const Context& context) {
  if (expression.kind == ExpressionKind::kLiteral) return std::get_if<double>(&expression.value);
  if (expression.kind != ExpressionKind::kName) return nullptr;
  if (expression.target == Target::kLocal && expression.index < context.slots.size())
    return std::get_if<double>(&context.slots[expression.index]);
  const bool is_attribute = expression.target == Target::kAttribute && context.shape.attributes == 0;
  if (!is_attribute || !context.run.attributes[expression.index]) return nullptr;
  return std::get_if<double>(&*context.run.attributes[expression.index]);
}

// Binary operators whose result is a number for all operands; kAdd may join strings.
bool is_arithmetic(const Expression& e) { return e.op >= Operator::kSubtract; }
bool is_condition(const Expression& e) { return e.op >= Operator::kOr && e.op <= Operator::kGreaterOrEqual; }
double result(const Expression& arithmetic, Context& context);
bool holds(const Expression& condition, Context& context);

// The steps of one value, which functions that call themselves twice exceed; shipped rules need a few hundred. And how
// many longer values end a derivation.
constexpr std::uint64_t kMostValueSteps = 200'000, kMostLongValues = 8;

// Calls `make` within the limits of steps and depth, else returns `otherwise`.
template <typename Result, typename Make>
Result within_limits(const Expression& expression, Context& context, Result otherwise, Make make) {
  Run& run = context.run;
  if (!run.spend(1)) return otherwise;
  if (context.depth == 0) run.value_begin = run.out.steps;
  if (run.out.steps - run.value_begin > kMostValueSteps) {
    // a few such values, and the derivation ends
    if (!std::exchange(run.is_value_too_long, true)) run.spend(run.options.limits.steps / kMostLongValues);
    run.warn(expression.position, "functions call each other without end");
    return otherwise;
  }
  run.is_value_too_long = false;
  if (context.depth >= kMostDepth) {
    run.warn(expression.position, "values refer to each other without end");
    return otherwise;
  }
  ++context.depth;
  Result made = make();
  --context.depth;
  return made;
}

double number_at(const Expression& expression, Context& context) {
  const double* plain = context.depth < kMostDepth ? plain_number(expression, context) : nullptr;
  if (plain != nullptr) return context.run.spend(1) ? *plain : 0.0;
  if (is_arithmetic(expression))
    return within_limits(expression, context, 0.0, [&] { return result(expression, context); });
  const Value value = evaluate(expression, context);
  if (!std::holds_alternative<double>(value))
    context.run.warn(expression.position, std::string("expected a float, found a ") + kind_name(value));
  return number_of(value);
}

bool truth_at(const Expression& expression, Context& context) {
  if (is_condition(expression))
    return within_limits(expression, context, false, [&] { return holds(expression, context); });
  const Value value = evaluate(expression, context);
  if (!std::holds_alternative<bool>(value))
    context.run.warn(expression.position, std::string("expected a bool, found a ") + kind_name(value));
  return truth_of(value);
}

double random_number(Context& context, const double* n, std::size_t given) {
  const double low = given == 2 ? n[0] : 0, high = given == 2 ? n[1] : given == 1 ? n[0] : 1;
  return low + (high - low) * draw_unit(context);
}

bool is_drawn(Context& context, double share) {
  const Drawn drawn = draw(context, 1);
  const bool is_below = drawn.value < share;
  record(context, drawn, is_below ? DrawRange{-HUGE_VAL, share} : DrawRange{share, HUGE_VAL});
  return is_below;
}

bool answer_query(Context& context, ContextQuery query) {
  const AnswerContextQuery& answer = context.run.options.answer_context_query;
  if (answer && context.random.of_shape) context.run.depends_on(0);
  // a query tests every point of the shape
  context.run.spend(vertex_count(context.shape.faces) * 2);
  return answer && answer(query, context.shape);
}

FrontInShape front_in(Context& context) {
  const FindFront& find = context.run.options.find_front;
  if (find && context.random.of_shape) context.run.depends_on(0);
  context.run.spend(vertex_count(context.shape.faces) * 2);
  return find ? find(context.shape).value_or(FrontInShape{}) : FrontInShape{};
}

Value call_builtin(std::size_t row, const Value* v, const double* n, const std::string* s, std::size_t given,
                   Context& context) {
  std::size_t at = 0;
#define FUNCTION(name, arguments, kind, computes, text) \
  if (row == at++) return Value(computes);
#include "grammars/language/functions.inc"
#undef FUNCTION
  return 0.0;
}

// Evaluates the arguments and converts them as the letters of the table say.
Value evaluate_builtin(const Expression& call, Context& context) {
  const char* letters = builtin_functions()[call.index].arguments;
  Value v[3];
  double n[3] = {0, 0, 0};
  std::string s[3];
  for (std::size_t i = 0; i < call.operands.size() && i < 3; ++i) {
    v[i] = evaluate(call.operands[i], context);
    if (*letters == '/') ++letters;
    const char letter = *letters++;
    const bool fits = letter == 'v' || letter == "nbs"[v[i].index()];
    if (!fits) context.run.warn(call.operands[i].position, "an argument of '" + call.text + "' has the wrong type");
    n[i] = number_of(v[i]);
    if (letter == 's') s[i] = text_of(v[i]);
  }
  const Value value = call_builtin(call.index, v, n, s, call.operands.size(), context);
  return std::holds_alternative<double>(value) ? finite(std::get<double>(value), call.position, context) : value;
}

// A constant function is evaluated once, unless it raises warnings; its steps count each time.
Value constant_value(std::uint32_t index, Context& context) {
  Run& run = context.run;
  std::optional<ConstantValue>& known = run.constants[index];
  if (known) return run.spend(known->steps) ? known->value : Value(0.0);
  const auto steps = [&] { return run.out.steps - run.attribute_steps; };
  const std::uint64_t before = steps(), raised_before = run.warnings_raised;
  Slots none;
  Context inner{run, context.shape, none, context.random, context.depth};
  Value value = evaluate(run.program.functions[index].value, inner);
  if (run.warnings_raised == raised_before && run.spend(0)) run.constants[index] = {value, steps() - before};
  return value;
}

[[gnu::noinline]] Value evaluate_function(const Expression& call, Context& context) {
  const Function& function = context.run.program.functions[call.index];
  if (function.is_constant) return constant_value(call.index, context);
  Slots slots;
  slots.reserve(call.operands.size());
  for (const Expression& operand : call.operands) slots.push_back(evaluate(operand, context));
  Context inner{context.run, context.shape, slots, context.random, context.depth};
  return evaluate(function.value, inner);
}

Value material_value(const std::string& name, const Appearance& appearance) {
#define MATERIAL_TEXT(key, member) \
  if (name == key) return appearance.member;
#define MATERIAL_NUMBER(key, member) \
  if (name == key) return appearance.member;
#include "grammars/language/material_values.inc"
#undef MATERIAL_TEXT
#undef MATERIAL_NUMBER
  return 0.0;
}

// The node at which the value was assigned (Run::depends_on); ~0 if it depends on the shape alone.
std::uint32_t assigned_at(const Shape& shape, std::size_t row) {
  constexpr DependsOn kDependsOn[] = {
#define SHAPE_VALUE(key, depends_on, computes, text) depends_on,
#include "grammars/language/shape_values.inc"
#undef SHAPE_VALUE
  };
  if (kDependsOn[row] == DependsOn::kPosition) return 0;
  if (kDependsOn[row] == DependsOn::kSplit) return shape.in_split.since_node;
  return kDependsOn[row] == DependsOn::kComp ? shape.in_comp.since_node : ~0u;
}

Value shape_value(const Expression& name, Context& context) {
  const Shape& shape = context.shape;
  if (name.index == ~0u) return material_value(name.text, context.run.tables.appearances[shape.appearance]);
  if (context.random.of_shape) context.run.depends_on(assigned_at(shape, name.index));
  std::size_t at = 0;
#define SHAPE_VALUE(key, depends_on, computes, text) \
  if (name.index == at++) return Value(computes);
#include "grammars/language/shape_values.inc"
#undef SHAPE_VALUE
  return 0.0;
}

Value evaluate_name(const Expression& name, Context& context) {
  switch (name.target) {
    case Target::kLocal:
      return name.index < context.slots.size() ? context.slots[name.index] : Value(0.0);
    case Target::kAttribute:
      return attribute_value(name.index, context);
    case Target::kFunction:
      return evaluate_function(name, context);
    case Target::kBuiltin:
      return evaluate_builtin(name, context);
    case Target::kShape:
      context.run.spend(context.shape.faces.size());
      return shape_value(name, context);
    default:
      return 0.0;
  }
}

Value evaluate_unary(const Expression& unary, Context& context) {
  if (unary.op == Operator::kNot) return !truth_at(unary.operands[0], context);
  const double number = number_at(unary.operands[0], context);
  return unary.op == Operator::kNegate ? -number : number;
}

// Compares as strings if one is a string, else as numbers; < 0, 0 or > 0. Values of different kinds raise a warning.
int compared(const Value& a, const Value& b, TextPosition position, Context& context) {
  if (a.index() != b.index())
    context.run.warn(position, std::string("compares a ") + kind_name(a) + " with a " + kind_name(b));
  if (std::holds_alternative<std::string>(a) || std::holds_alternative<std::string>(b)) {
    const int order = text_of(a).compare(text_of(b));
    return order < 0 ? -1 : order > 0 ? 1 : 0;
  }
  const double x = number_of(a), y = number_of(b);
  return x < y ? -1 : x > y ? 1 : 0;
}

bool holds(Operator comparison, int order) {
  const auto is = [&](Operator a, Operator b) { return comparison == a || comparison == b; };
  if (order == 0) return comparison == Operator::kEqual || is(Operator::kLessOrEqual, Operator::kGreaterOrEqual);
  if (comparison == Operator::kNotEqual) return true;
  return order < 0 ? is(Operator::kLess, Operator::kLessOrEqual) : is(Operator::kGreater, Operator::kGreaterOrEqual);
}

/// Both operands, if they are stored numbers.
struct Numbers {
  const double* a = nullptr;
  const double* b = nullptr;
  explicit operator bool() const { return a != nullptr && b != nullptr; }
};

Numbers plain_numbers(const Expression& binary, Context& context) {
  if (context.depth >= kMostDepth) return {};
  return {plain_number(binary.operands[0], context), plain_number(binary.operands[1], context)};
}

// Strings that double in every function would fill the memory before a limit applies.
constexpr std::size_t kLongestText = 4096;

Value add_text(const Expression& binary, const Value& a, const Value& b, Context& context) {
  std::string text = text_of(a) + text_of(b);
  if (text.size() > kLongestText) {
    context.run.warn(binary.position, "a text of more than 4096 bytes");
    text.resize(kLongestText);
  }
  return text;
}

double divided(double a, double b, TextPosition position, Context& context) {
  if (b != 0) return a / b;
  context.run.warn(position, "division by zero");
  return 0;
}

double remainder_of(double a, double b, TextPosition position, Context& context) {
  const double quotient = divided(a, b, position, context);
  return a - b * (quotient < 0 ? std::ceil(quotient) : std::floor(quotient));
}

double arithmetic(const Expression& binary, double a, double b, Context& context) {
  switch (binary.op) {
    case Operator::kAdd:
      return finite(a + b, binary.position, context);
    case Operator::kSubtract:
      return finite(a - b, binary.position, context);
    case Operator::kMultiply:
      return finite(a * b, binary.position, context);
    case Operator::kDivide:
      return finite(divided(a, b, binary.position, context), binary.position, context);
    default:
      return finite(remainder_of(a, b, binary.position, context), binary.position, context);
  }
}

double result(const Expression& binary, Context& context) {
  // the left operand first, since both may draw random numbers
  const double left = number_at(binary.operands[0], context);
  return arithmetic(binary, left, number_at(binary.operands[1], context), context);
}

bool holds(const Expression& binary, Context& context) {
  const Expression &left = binary.operands[0], &right = binary.operands[1];
  if (binary.op == Operator::kAnd) return truth_at(left, context) && truth_at(right, context);
  if (binary.op == Operator::kOr) return truth_at(left, context) || truth_at(right, context);
  if (const Numbers plain = plain_numbers(binary, context))
    return context.run.spend(2) && holds(binary.op, *plain.a < *plain.b ? -1 : *plain.a > *plain.b);
  const Value a = evaluate(left, context);
  return holds(binary.op, compared(a, evaluate(right, context), binary.position, context));
}

Value evaluate_sum(const Expression& sum, Context& context) {
  if (const Numbers plain = plain_numbers(sum, context))
    return context.run.spend(2) ? arithmetic(sum, *plain.a, *plain.b, context) : 0.0;
  const Value a = evaluate(sum.operands[0], context);
  const Value b = evaluate(sum.operands[1], context);
  const bool texts = std::holds_alternative<std::string>(a) || std::holds_alternative<std::string>(b);
  if (texts) return add_text(sum, a, b, context);
  return arithmetic(sum, number_of(a), number_of(b), context);
}

Value evaluate_binary(const Expression& binary, Context& context) {
  if (is_condition(binary)) return holds(binary, context);
  return is_arithmetic(binary) ? Value(result(binary, context)) : evaluate_sum(binary, context);
}

Value evaluate_case(const Expression& cases, Context& context) {
  std::size_t i = 0;
  for (; i + 1 < cases.operands.size(); i += 2)
    if (truth_at(cases.operands[i], context)) return evaluate(cases.operands[i + 1], context);
  return i < cases.operands.size() ? evaluate(cases.operands[i], context) : Value(0.0);
}

Value evaluate_chance(const Expression& chances, Context& context) {
  const Drawn drawn = draw(context, 100);
  double sum = 0, least = -HUGE_VAL;
  std::size_t i = 0;
  for (; i + 1 < chances.operands.size(); i += 2) {
    sum += number_at(chances.operands[i], context);
    if (drawn.value < sum) {
      record(context, drawn, {least, sum});
      return evaluate(chances.operands[i + 1], context);
    }
    least = std::max(least, sum);
  }
  record(context, drawn, {least, HUGE_VAL});
  return i < chances.operands.size() ? evaluate(chances.operands[i], context) : Value(0.0);
}

Value evaluate_with(const Expression& with, Context& context) {
  for (std::size_t i = 0; i + 1 < with.operands.size(); ++i) {
    Value value = evaluate(with.operands[i], context);
    context.slots.resize(std::max<std::size_t>(context.slots.size(), with.index + i + 1), Value(0.0));
    context.slots[with.index + i] = std::move(value);
  }
  return evaluate(with.operands.back(), context);
}

// The value of an attribute at the start. Its random numbers belong to the building and to the attribute's name.
Value initial_value(std::uint32_t index, Context& context) {
  Run& run = context.run;
  const Attribute& attribute = run.program.attributes[index];
  const auto given = run.options.attributes.find(attribute.name);
  const std::string purpose = "attr " + attribute.name;
  RandomSource random{.purpose = purpose.c_str(), .of_shape = false};
  Slots slots;
  Context inner{run, run.initial, slots, random, context.depth};
  if (given == run.options.attributes.end() || attribute.is_const) return evaluate(attribute.value, inner);
  return given->second;
}

}  // namespace

Value attribute_value(std::uint32_t index, Context& context) {
  assert(index < context.run.program.attributes.size());
  Run& run = context.run;
  const AttributeSet& changed = run.tables.attribute_sets[context.shape.attributes];
  if (const auto found = changed.find(index); found != changed.end()) return found->second;
  if (run.attributes[index]) return *run.attributes[index];
  if (run.attribute_under_way[index]) {
    run.warn(run.program.attributes[index].position, "the attribute's value refers to itself");
    return 0.0;
  }
  run.attribute_under_way[index] = true;
  const std::uint64_t before = run.out.steps - run.attribute_steps;
  run.attributes[index] = initial_value(index, context);
  run.attribute_steps = run.out.steps - before;
  run.attribute_under_way[index] = false;
  return *run.attributes[index];
}

double draw_unit(Context& context) {
  if (context.random.of_shape) context.run.depends_on(0);
  return unit_at(context, context.random.next++);
}

namespace {

Value evaluate_kind(const Expression& expression, Context& context) {
  switch (expression.kind) {
    case ExpressionKind::kLiteral:
      return expression.value;
    case ExpressionKind::kName:
      return evaluate_name(expression, context);
    case ExpressionKind::kCall:
      return expression.target == Target::kFunction ? evaluate_function(expression, context)
                                                    : evaluate_name(expression, context);
    case ExpressionKind::kUnary:
      return evaluate_unary(expression, context);
    case ExpressionKind::kBinary:
      return evaluate_binary(expression, context);
    case ExpressionKind::kCase:
      return evaluate_case(expression, context);
    case ExpressionKind::kChance:
      return evaluate_chance(expression, context);
    case ExpressionKind::kWithLocals:
      return evaluate_with(expression, context);
  }
  return 0.0;
}

}  // namespace

Value evaluate(const Expression& expression, Context& context) {
  return within_limits(expression, context, Value(0.0), [&] { return evaluate_kind(expression, context); });
}

namespace {

int drawn_branch(const Body& body, Context& context) {
  const Drawn drawn = draw(context, 100);
  double sum = 0;
  DrawRange same;
  int chosen = -1;
  for (std::size_t i = 0; i < body.branches.size() && chosen < 0; ++i) {
    const Branch& branch = body.branches[i];
    if (!branch.is_else) sum += number_at(branch.test, context);
    const bool is_this = branch.is_else || drawn.value < sum;
    if (is_this) chosen = static_cast<int>(i);
    if (is_this && !branch.is_else) same.high = sum;
    if (!is_this) same.low = std::max(same.low, sum);
  }
  record(context, drawn, same);
  return chosen;
}

}  // namespace

int chosen_branch(const Body& body, Context& context) {
  assert(body.kind != BodyKind::kStatements);
  if (body.kind == BodyKind::kChance) return drawn_branch(body, context);
  for (std::size_t i = 0; i < body.branches.size(); ++i) {
    const Branch& branch = body.branches[i];
    if (branch.is_else || truth_at(branch.test, context)) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace citykiln::grammars
