// Abstract interpretation over intervals: P. Cousot and R. Cousot 1977. Each part below mirrors one of the derivation:
// values evaluate.h, operations operations.inc, bodies execute.h, the combination of children displacement.h.
#include "grammars/derivation/displacement_bound.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

#include "grammars/derivation/evaluate.h"
#include "grammars/language/body_properties.h"
#include "grammars/language/builtin.h"
#include "grammars/language/operation_table.h"

namespace citykiln::grammars {
namespace {

constexpr std::uint32_t kMaxEvaluations = 10'000;  // of bodies and values: about twenty times the largest shipped rules
constexpr int kDeepest = 40;                       // nested bodies and values
constexpr double kSetbackGrid_m = 2e-4;            // twice what the grid of a setback's overlay moves points

struct BoundContext {
  Execution& execution;
  int depth = 0;
  bool has_set = false;  ///< set() may have changed attributes of the node's shape.
};

// Bounds beyond the tolerance are not used, so the evaluation stops there.
bool exceeds_tolerance(const BoundContext& context, double to_earlier_m) {
  return to_earlier_m > context.execution.run.options.tolerance_m;
}

// ---- values: intervals instead of numbers

NumberRange range_of(BoundContext context, const Expression& expression, const NumberRanges& slots);

NumberRange range_around(std::initializer_list<double> values) {
  const NumberRange range{std::min(values), std::max(values)};
  return std::abs(range.low) + std::abs(range.high) < kMost_m ? range : NumberRange{};
}

NumberRange union_of(NumberRange a, NumberRange b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

// A condition is a number that is 0 or 1.
constexpr NumberRange kFalse = {0, 0}, kTrue = {1, 1}, kEither = {0, 1};

bool is_true(NumberRange a) { return a.low > 0 || a.high < 0; }
bool is_false(NumberRange a) { return a == kFalse; }

NumberRange decided(bool yes, bool no) { return yes ? kTrue : no ? kFalse : kEither; }
NumberRange negated(NumberRange a) { return decided(is_false(a), is_true(a)); }

// Strings are unbounded numbers here, so no comparison of strings is decided.
NumberRange range_of_equality(NumberRange a, NumberRange b) {
  return decided(a == b && a.low == a.high, a.high < b.low || a.low > b.high);
}

NumberRange range_of_binary(Operator op, NumberRange a, NumberRange b) {
  switch (op) {
    case Operator::kAdd:
      return range_around({a.low + b.low, a.high + b.high});
    case Operator::kSubtract:
      return range_around({a.low - b.high, a.high - b.low});
    case Operator::kMultiply:
      return range_around({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    case Operator::kAnd:
      return decided(is_true(a) && is_true(b), is_false(a) || is_false(b));
    case Operator::kOr:
      return decided(is_true(a) || is_true(b), is_false(a) && is_false(b));
    case Operator::kLess:
      return decided(a.high < b.low, a.low >= b.high);
    case Operator::kGreaterOrEqual:
      return decided(a.low >= b.high, a.high < b.low);
    case Operator::kGreater:
    case Operator::kLessOrEqual:
      return range_of_binary(op == Operator::kGreater ? Operator::kLess : Operator::kGreaterOrEqual, b, a);
    case Operator::kEqual:
      return range_of_equality(a, b);
    case Operator::kNotEqual:
      return negated(range_of_equality(a, b));
    default:
      return {};
  }
}

NumberRange range_of_unary(Operator op, NumberRange a) {
  if (op == Operator::kNot) return negated(a);
  if (op == Operator::kNegate) return range_of_binary(Operator::kSubtract, {0, 0}, a);
  return op == Operator::kPlus ? range_of_binary(Operator::kAdd, {0, 0}, a) : NumberRange{};
}

NumberRange range_of_value(const Value& value) {
  return std::holds_alternative<std::string>(value) ? NumberRange{} : range_around({number_of(value)});
}

NumberRanges ranges_of(BoundContext context, const std::vector<Expression>& expressions, const NumberRanges& slots) {
  NumberRanges ranges;
  ranges.reserve(expressions.size());
  for (const Expression& expression : expressions) ranges.push_back(range_of(context, expression, slots));
  return ranges;
}

NumberRange range_of_builtin(BoundContext context, const Expression& call, const NumberRanges& slots) {
  if (builtin_functions()[call.index].kind != FunctionKind::kUniformDraw) return {};
  if (call.operands.empty()) return {0, 1};
  const NumberRanges bounds = ranges_of(context, call.operands, slots);
  return union_of(bounds[0], bounds.size() > 1 ? bounds[1] : NumberRange{0, 0});
}

NumberRange range_of_name(BoundContext context, const Expression& name, const NumberRanges& slots) {
  Execution& execution = context.execution;
  switch (name.target) {
    case Target::kLocal:
      return name.index < slots.size() ? slots[name.index] : NumberRange{};
    case Target::kAttribute: {
      if (context.has_set && execution.run.program.attributes[name.index].is_set) return {};
      Context evaluation = context_of(execution);
      return range_of_value(attribute_value(name.index, evaluation));
    }
    case Target::kFunction:
      return range_of(context, execution.run.program.functions[name.index].value,
                      ranges_of(context, name.operands, slots));
    case Target::kBuiltin:
      return range_of_builtin(context, name, slots);
    default:
      return {};
  }
}

// The union of all values of a list of percentages, or of the values of a case whose conditions may hold.
NumberRange range_of_choice(BoundContext context, const Expression& choice, const NumberRanges& slots) {
  if (choice.operands.size() % 2 == 0) return {};
  std::optional<NumberRange> all;
  const auto add = [&](const Expression& value) {
    const NumberRange range = range_of(context, value, slots);
    all = all ? union_of(*all, range) : range;
  };
  const bool is_case = choice.kind == ExpressionKind::kCase;
  for (std::size_t i = 0; i + 1 < choice.operands.size(); i += 2) {
    const NumberRange test = is_case ? range_of(context, choice.operands[i], slots) : kEither;
    if (!is_false(test)) add(choice.operands[i + 1]);
    if (is_true(test)) return *all;
  }
  add(choice.operands.back());
  return *all;
}

NumberRange range_of(BoundContext context, const Expression& expression, const NumberRanges& slots) {
  if (++context.depth > kDeepest || ++context.execution.run.bounds.evaluations > kMaxEvaluations) return {};
  const auto& operands = expression.operands;
  switch (expression.kind) {
    case ExpressionKind::kLiteral:
      return range_of_value(expression.value);
    case ExpressionKind::kName:
    case ExpressionKind::kCall:
      return range_of_name(context, expression, slots);
    case ExpressionKind::kUnary:
      return is_share(expression) ? NumberRange{}
                                  : range_of_unary(expression.op, range_of(context, operands[0], slots));
    case ExpressionKind::kBinary: {
      const NumberRange left = range_of(context, operands[0], slots);
      return range_of_binary(expression.op, left, range_of(context, operands[1], slots));
    }
    case ExpressionKind::kCase:
    case ExpressionKind::kChance:
      return range_of_choice(context, expression, slots);
    default:
      return {};
  }
}

double largest_m(NumberRange range) { return std::max(std::abs(range.low), std::abs(range.high)); }

// ---- bodies

DisplacementBound bound_of_body(BoundContext context, const Body& body, const NumberRanges& slots);

/// The known properties of the current shape: it is a face along the scope's z, or a prism over one, and has moved this
/// far.
struct KnownShape {
  bool is_prism = false;
  double height_m = 0;  ///< The height of a prism.
  Displacement moved = {};
};

/// The state between two statements of a body.
struct BoundState {
  BoundContext context;
  const NumberRanges& slots;
  KnownShape shape = {};
  bool pending = true;                                   ///< The shape has no successor yet.
  bool unbounded = false;                                ///< A statement has no bound.
  std::vector<std::pair<KnownShape, bool>> pushed = {};  ///< With BoundContext::has_set.
  double to_earlier_m = 0;                               ///< The largest of all children.
  double to_later_m = kUnbounded_m;                      ///< The smallest of the groups of children.
  bool survives = false;                                 ///< At least one group does.
};

// @param cover_m  No point of the current surface is farther than this from the children that represent it.
void add_group(BoundState& state, const DisplacementBound& bound, double cover_m) {
  state.to_earlier_m = std::max(state.to_earlier_m, state.shape.moved.to_earlier_m + bound.moved.to_earlier_m);
  state.pending = false;
  if (!bound.survives) return;
  state.survives = true;
  state.to_later_m = std::min(state.to_later_m, state.shape.moved.to_later_m + cover_m + bound.moved.to_later_m);
}

// The bound of a group of children: the largest distances; it survives only if all children do.
DisplacementBound worst_of(DisplacementBound a, DisplacementBound b) {
  return {{std::max(a.moved.to_earlier_m, b.moved.to_earlier_m), std::max(a.moved.to_later_m, b.moved.to_later_m)},
          a.survives && b.survives};
}

constexpr DisplacementBound kNothing = {{0, kUnbounded_m}, false};
constexpr DisplacementBound kUnmoved = {{0, 0}, true};

DisplacementBound worst_of(BoundState& state, const std::vector<Selector>& selectors) {
  DisplacementBound worst = kUnmoved;
  for (const Selector& selector : selectors) {
    const bool nests = selector.size == SizeKind::kRepeat;
    worst = worst_of(
        worst, nests ? worst_of(state, selector.nested) : bound_of_body(state.context, selector.body, state.slots));
    if (exceeds_tolerance(state.context, worst.moved.to_earlier_m)) break;
  }
  return worst;
}

bool fills(const std::vector<Selector>& selectors);

// A group nested in a repeated group is divided as a list of its own.
bool nested_groups_fill(const std::vector<Selector>& repeated) {
  return std::ranges::all_of(
      repeated, [](const Selector& selector) { return selector.size != SizeKind::kRepeat || fills(selector.nested); });
}

// True if the pieces surely cover the whole length: an entry floats, or there is exactly one repeated group (sizes.h).
bool fills(const std::vector<Selector>& selectors) {
  const auto is = [](SizeKind kind) { return [kind](const Selector& selector) { return selector.size == kind; }; };
  return (std::ranges::any_of(selectors, is(SizeKind::kFloating)) ||
          std::ranges::count_if(selectors, is(SizeKind::kRepeat)) == 1) &&
         std::ranges::all_of(selectors, [](const Selector& s) { return nested_groups_fill(s.nested); });
}

bool has_selector(const Statement& statement, const char* word) {
  return std::ranges::any_of(statement.selectors, [&](const Selector& selector) {
    return selector.key.target == Target::kWord && selector.key.text == word;
  });
}

void bound_split(BoundState& state, const Statement& statement) {
  if (state.shape.is_prism) return void(state.unbounded = true);
  DisplacementBound pieces = worst_of(state, statement.selectors);
  pieces.survives &= statement.repeated ? nested_groups_fill(statement.selectors) : fills(statement.selectors);
  add_group(state, pieces, 0);
}

void bound_setback(BoundState& state, const Statement& statement) {
  if (state.shape.is_prism) return void(state.unbounded = true);
  DisplacementBound parts = worst_of(state, statement.selectors);
  parts.survives &= has_selector(statement, "all") && has_selector(statement, "remainder");
  state.shape.moved = state.shape.moved + Displacement{kSetbackGrid_m, kSetbackGrid_m};
  add_group(state, parts, 0);
}

/// Whether a selector takes the faces that the scope calls `side`.
enum class Takes : std::uint8_t { kYes, kNo, kUnknown };

Takes takes(const Selector& selector, const std::string& side) {
  if (selector.key.target != Target::kWord) return Takes::kUnknown;
  const std::string& word = selector.key.text;
  if (word == "all" || word == side) return Takes::kYes;
  if (word == "side") return side == "front" || side == "back" ? Takes::kYes : Takes::kNo;
  return is_among(word, " front back left right top bottom ") ? Takes::kNo : Takes::kUnknown;
}

// The bound of the end of a prism that the scope calls `side`.
DisplacementBound bound_of_end(BoundState& state, const Statement& comp, const std::string& side) {
  for (const Selector& selector : comp.selectors) {
    const Takes taken = takes(selector, side);
    if (taken == Takes::kUnknown) return kNothing;
    if (taken == Takes::kYes) return bound_of_body(state.context, selector.body, state.slots);
  }
  return kNothing;
}

// Each end is within the height of the other, so the better one is enough.
DisplacementBound better_end(BoundState& state, const Statement& comp, const char* one, const char* other) {
  const DisplacementBound a = bound_of_end(state, comp, one), b = bound_of_end(state, comp, other);
  if (!a.survives || (b.survives && b.moved.to_later_m < a.moved.to_later_m)) return b;
  return a;
}

void bound_components(BoundState& state, const Statement& statement) {
  if (statement.arguments.front().text == "e") return void(state.unbounded = true);
  DisplacementBound parts = worst_of(state, statement.selectors);
  if (!state.shape.is_prism) {
    parts.survives &= has_selector(statement, "all");
    return add_group(state, parts, 0);
  }
  // the ends are front and back over a vertical face, top and bottom over a horizontal one
  const DisplacementBound ends =
      worst_of(better_end(state, statement, "front", "back"), better_end(state, statement, "top", "bottom"));
  add_group(state, {{parts.moved.to_earlier_m, ends.moved.to_later_m}, ends.survives}, state.shape.height_m);
}

void bound_extrude(BoundState& state, const Statement& statement) {
  const bool along_normal = statement.arguments.size() == 1;
  state.unbounded |= !along_normal || state.shape.is_prism;
  state.shape.is_prism = true;
  state.shape.height_m = largest_m(range_of(state.context, statement.arguments.back(), state.slots));
  state.shape.moved.to_earlier_m += state.shape.height_m;
}

void bound_translate(BoundState& state, const Statement& statement) {
  double way_m = 0;
  for (const Expression& argument : statement.arguments)
    way_m += is_share(argument) ? kUnbounded_m : largest_m(range_of(state.context, argument, state.slots));
  state.shape.moved = state.shape.moved + Displacement{way_m, way_m};
}

void bound_operation(BoundState& state, const Statement& statement) {
  const OperationRow& row = operation_table()[statement.index];
  state.pending |= row.alters != Alters::kNothing;
  state.context.has_set |= sets_attribute(statement);
  switch (row.bound) {
    case BoundRule::kFixed:
      return;
    case BoundRule::kFixedFace:
      return void(state.unbounded |= state.shape.is_prism);
    case BoundRule::kExtrude:
      return bound_extrude(state, statement);
    case BoundRule::kTranslate:
      return bound_translate(state, statement);
    case BoundRule::kSplit:
      return bound_split(state, statement);
    case BoundRule::kComponents:
      return bound_components(state, statement);
    case BoundRule::kSetback:
      return bound_setback(state, statement);
    case BoundRule::kUnbounded:
      state.unbounded = true;
  }
}

void bound_successor(BoundState& state, const Statement& statement) {
  if (statement.name == "NIL") return add_group(state, kNothing, 0);
  if (statement.index == ~0u) return add_group(state, kUnmoved, 0);
  // bodies are bounded for faces only
  if (state.shape.is_prism) return void(state.unbounded = true);
  const Rule& rule = state.context.execution.run.program.rules[statement.index];
  add_group(state, bound_of_body(state.context, rule.body, ranges_of(state.context, statement.arguments, state.slots)),
            0);
}

void bound_statement(BoundState& state, const Statement& statement) {
  switch (statement.kind) {
    case StatementKind::kOperation:
      return bound_operation(state, statement);
    case StatementKind::kSuccessor:
      return bound_successor(state, statement);
    case StatementKind::kPush:
      return void(state.pushed.emplace_back(state.shape, state.context.has_set));
    case StatementKind::kPop:
      if (state.pushed.empty()) return;
      std::tie(state.shape, state.context.has_set) = state.pushed.back();
      return state.pushed.pop_back();
    case StatementKind::kBlock:
      state.unbounded = true;  // rare in rule files
  }
}

DisplacementBound bound_of_statements(BoundContext context, const Body& body, const NumberRanges& slots) {
  BoundState state{context, slots};
  for (const Statement& statement : body.statements) {
    bound_statement(state, statement);
    if (state.unbounded || exceeds_tolerance(context, state.to_earlier_m)) return {};
  }
  if (state.pending) add_group(state, kUnmoved, 0);
  return {{state.to_earlier_m, state.to_later_m}, state.survives};
}

// If no branch applies, the shape stays as it is.
DisplacementBound bound_of_branches(BoundContext context, const Body& body, const NumberRanges& slots) {
  DisplacementBound worst = kUnmoved;
  for (const Branch& branch : body.branches) {
    const bool is_tested = body.kind == BodyKind::kCase && !branch.is_else;
    const NumberRange test = is_tested ? range_of(context, branch.test, slots) : kEither;
    if (!is_false(test)) worst = worst_of(worst, bound_of_body(context, branch.body, slots));
    if (is_true(test) || exceeds_tolerance(context, worst.moved.to_earlier_m)) break;
  }
  return worst;
}

DisplacementBound evaluate_bound(BoundContext context, const Body& body, NumberRanges slots) {
  if (++context.depth > kDeepest || ++context.execution.run.bounds.evaluations > kMaxEvaluations) return {};
  for (const Local& local : body.locals) {
    const NumberRange value = range_of(context, local.value, slots);
    slots.resize(std::max<std::size_t>(slots.size(), local.slot + 1));
    slots[local.slot] = value;
  }
  return body.kind == BodyKind::kStatements ? bound_of_statements(context, body, slots)
                                            : bound_of_branches(context, body, slots);
}

bool only_ends(const Body& body) {
  const std::string* terminal = terminal_of(body);
  return terminal != nullptr && *terminal != "NIL";
}

// True if the arguments that affect the bound of the body are equal.
bool are_alike(const Body& body, const NumberRanges& a, const NumberRanges& b) {
  if (body.displacement_slots == 0 || a.size() != b.size()) return body.displacement_slots == 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if ((body.displacement_slots >> std::min<std::size_t>(i, 63) & 1) != 0 && a[i] != b[i]) return false;
  return true;
}

DisplacementBound bound_of_body(BoundContext context, const Body& body, const NumberRanges& slots) {
  if (only_ends(body)) return kUnmoved;
  BoundTable& table = context.execution.run.bounds;
  const std::uint32_t attributes = context.has_set ? kAnyAttributes : context.execution.shape.attributes;
  std::uint32_t& first = table.first_of[body.number];
  for (std::uint32_t i = first; i != 0; i = table.found[i - 1].next) {
    const KnownBound& known = table.found[i - 1];
    if (known.attributes == attributes && are_alike(body, known.arguments, slots)) return known.bound;
  }
  // until it is evaluated the body is unbounded, which ends the recursion of rules that lead to themselves
  const std::size_t index = table.found.size();
  table.found.push_back({.attributes = attributes, .arguments = slots, .bound = {}, .next = first});
  first = static_cast<std::uint32_t>(index + 1);
  const DisplacementBound bound = evaluate_bound(context, body, slots);
  return table.found[index].bound = bound;
}

}  // namespace

bool is_flat(const Shape& shape) {
  if (shape.faces.size() != 1 || !shape.asset.empty()) return false;
  const Vec3 normal = normal_of(shape.faces.front());
  constexpr double kNearly = 1 - 1e-9;
  return std::abs(dot(normal, shape.scope.axis[1])) > kNearly || std::abs(dot(normal, shape.scope.axis[2])) > kNearly;
}

NumberRanges ranges_of(const Execution& execution) {
  NumberRanges ranges;
  ranges.reserve(execution.slots.size());
  for (const Value& value : execution.slots) ranges.push_back(range_of_value(value));
  return ranges;
}

DisplacementBound displacement_bound(Execution& execution, const NumberRanges& arguments, const Body& body) {
  assert(is_flat(execution.shape));
  return bound_of_body({execution}, body, arguments);
}

std::optional<Displacement> bound_within_tolerance(Execution& execution, const Body& body) {
  const DeriveOptions& options = execution.run.options;
  if (!options.prune_early || !execution.run.measures()) return std::nullopt;
  if (!body.divides || (options.keep_appearances && body.changes_appearance) || !is_flat(execution.shape))
    return std::nullopt;
  const DisplacementBound bound = displacement_bound(execution, ranges_of(execution), body);
  if (!bound.survives || bound.moved.largest_m() + execution.shape.deviation_m > options.tolerance_m)
    return std::nullopt;
  return bound.moved;
}

}  // namespace citykiln::grammars
