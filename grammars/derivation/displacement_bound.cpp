#include "grammars/derivation/displacement_bound.h"

#include <algorithm>
#include <cmath>

#include "grammars/derivation/evaluate.h"
#include "grammars/derivation/run.h"
#include "grammars/language/body_properties.h"
#include "grammars/language/builtin.h"
#include "grammars/operations/table.h"

namespace citykiln::grammars {
namespace {

constexpr std::uint32_t kMostLooks =
    10'000;                            // at bodies and values: some twenty times what our largest rule files hold
constexpr int kDeepest = 40;           // bodies in each other
constexpr double kOfTheGrid_m = 2e-4;  // what a setback's overlay bends, generously

/// What is looked at.
struct BoundContext {
  Execution& execution;
  int depth = 0;
  bool has_set = false;  ///< Attributes may no longer be what they are for the node's shape.
};

// nobody asks how far what moves more than the tolerance does
bool is_out_of_question(const BoundContext& outlook, double out_m) {
  return out_m > outlook.execution.run.options.tolerance_m;
}

// ---- numbers
// ----------------------------------------------------------------------------------------------------------

NumberRange range_of(BoundContext outlook, const Expression& expression, const NumberRanges& frame);

NumberRange around(std::initializer_list<double> values) {
  NumberRange interval{std::min(values), std::max(values)};
  if (!(std::abs(interval.low) + std::abs(interval.high) < kMost_m)) return {};
  return interval;
}

NumberRange either(NumberRange a, NumberRange b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

// of conditions: they are numbers that are 0 or 1
constexpr NumberRange kFalse = {0, 0}, kTrue = {1, 1}, kEither = {0, 1};

bool is_true(NumberRange a) { return a.low > 0 || a.high < 0; }
bool is_false(NumberRange a) { return a == kFalse; }

NumberRange decided(bool yes, bool no) { return yes ? kTrue : no ? kFalse : kEither; }
NumberRange negated(NumberRange a) { return decided(is_false(a), is_true(a)); }

// texts are unbounded numbers here, so that nothing is ever decided about them
NumberRange range_of_comparison(const std::string& sign, NumberRange a, NumberRange b) {
  const bool is_below = a.high<b.low, is_above = a.low> b.high;
  if (sign == "<") return decided(is_below, a.low >= b.high);
  if (sign == ">") return decided(is_above, a.high <= b.low);
  if (sign == "<=") return decided(a.high <= b.low, is_above);
  if (sign == ">=") return decided(a.low >= b.high, is_below);
  const NumberRange equal = decided(a == b && a.low == a.high, is_below || is_above);
  return sign == "==" ? equal : negated(equal);
}

NumberRange range_of_binary(const std::string& sign, NumberRange a, NumberRange b) {
  switch (sign.front()) {
    case '+':
      return around({a.low + b.low, a.high + b.high});
    case '-':
      return around({a.low - b.high, a.high - b.low});
    case '*':
      return around({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    case '&':
      return decided(is_true(a) && is_true(b), is_false(a) || is_false(b));
    case '|':
      return decided(is_true(a) || is_true(b), is_false(a) && is_false(b));
    case '/':
    case '%':
      return {};
    default:
      return range_of_comparison(sign, a, b);
  }
}

NumberRange range_of_value(const Value& value) {
  return std::holds_alternative<std::string>(value) ? NumberRange{} : around({number_of(value)});
}

NumberRange range_of_function(BoundContext outlook, const Expression& call, const NumberRanges& frame) {
  NumberRanges arguments;
  arguments.reserve(call.operands.size());
  for (const Expression& operand : call.operands) arguments.push_back(range_of(outlook, operand, frame));
  return range_of(outlook, outlook.execution.run.program.functions[call.index].value, arguments);
}

// rand alone: of the others most are about shapes
NumberRange range_of_builtin(BoundContext outlook, const Expression& call, const NumberRanges& frame) {
  if (call.text != "rand") return {};
  if (call.operands.empty()) return {0, 1};
  const NumberRange first = range_of(outlook, call.operands.front(), frame);
  const NumberRange other = call.operands.size() > 1 ? range_of(outlook, call.operands[1], frame) : NumberRange{0, 0};
  return either(first, other);
}

NumberRange range_of_name(BoundContext outlook, const Expression& name, const NumberRanges& frame) {
  Execution& execution = outlook.execution;
  switch (name.target) {
    case Target::kLocal:
      return name.index < frame.size() ? frame[name.index] : NumberRange{};
    case Target::kAttribute: {
      if (outlook.has_set && execution.run.program.attributes[name.index].is_set) return {};
      Context context{execution.run, execution.shape, execution.frame, execution.dice};
      return range_of_value(attribute_value(name.index, context));
    }
    case Target::kFunction:
      return range_of_function(outlook, name, frame);
    case Target::kBuiltin:
      return range_of_builtin(outlook, name, frame);
    default:
      return {};
  }
}

// values of shares: any of them; of case, any whose condition may hold
NumberRange range_of_choice(BoundContext outlook, const Expression& choice, const NumberRanges& frame) {
  if (choice.operands.size() % 2 == 0) return {};
  std::optional<NumberRange> all;
  const auto add = [&](const Expression& value) {
    const NumberRange range = range_of(outlook, value, frame);
    all = all ? either(*all, range) : range;
  };
  const bool is_case = choice.kind == ExpressionKind::kCase;
  for (std::size_t i = 0; i + 1 < choice.operands.size(); i += 2) {
    const NumberRange test = is_case ? range_of(outlook, choice.operands[i], frame) : kEither;
    if (!is_false(test)) add(choice.operands[i + 1]);
    if (is_true(test)) return *all;
  }
  add(choice.operands.back());
  return *all;
}

NumberRange range_of(BoundContext outlook, const Expression& expression, const NumberRanges& frame) {
  if (++outlook.depth > kDeepest || ++outlook.execution.run.reaches.looks > kMostLooks) return {};
  const auto& operands = expression.operands;
  switch (expression.kind) {
    case ExpressionKind::kLiteral:
      return range_of_value(expression.value);
    case ExpressionKind::kName:
    case ExpressionKind::kCall:
      return range_of_name(outlook, expression, frame);
    case ExpressionKind::kUnary:
      if (expression.text == "!") return negated(range_of(outlook, operands[0], frame));
      if (expression.text != "-" && expression.text != "+") return {};
      return range_of_binary(expression.text, {0, 0}, range_of(outlook, operands[0], frame));
    case ExpressionKind::kBinary:
      return range_of_binary(expression.text, range_of(outlook, operands[0], frame),
                             range_of(outlook, operands[1], frame));
    case ExpressionKind::kCase:
    case ExpressionKind::kChance:
      return range_of_choice(outlook, expression, frame);
    default:
      return {};
  }
}

double largest_m(NumberRange interval) { return std::max(std::abs(interval.low), std::abs(interval.high)); }

// ---- bodies
// -----------------------------------------------------------------------------------------------------------

DisplacementBound reach_of_body(BoundContext outlook, const Body& body, const NumberRanges& frame);

/// What is known of the current shape.
enum class Form : std::uint8_t {
  kFace,   ///< One flat face that looks along the scope's z.
  kPrism,  ///< A prism over one, along z.
  kUnknown
};

/// A body's statements, one after the other.
struct Course {
  BoundContext outlook;
  const NumberRanges& frame;
  Form form = Form::kFace;
  Displacement moved = {};  ///< Up to the current shape.
  double height_m = 0;      ///< Of kPrism.
  bool pending = true;
  bool unbounded = false;  ///< Something was met that is not known.
  std::vector<std::tuple<Form, Displacement, double, bool>> pushed = {};
  double out_m = 0;              ///< Of all children.
  double back_m = kUnbounded_m;  ///< Of the best group of children.
  bool stays = false;
};

// `cover_m`: from a point of the current surface to the children that stand for it
void add_group(Course& course, const DisplacementBound& reach, double cover_m) {
  course.out_m = std::max(course.out_m, course.moved.out_m + reach.moved.out_m);
  course.pending = false;
  if (!reach.stays) return;
  course.stays = true;
  course.back_m = std::min(course.back_m, course.moved.back_m + cover_m + reach.moved.back_m);
}

/// All children of a group: as far out as any, as far back as any, and staying if all do.
DisplacementBound worst_of(DisplacementBound a, DisplacementBound b) {
  return {{std::max(a.moved.out_m, b.moved.out_m), std::max(a.moved.back_m, b.moved.back_m)}, a.stays && b.stays};
}

constexpr DisplacementBound kNothing = {{0, kUnbounded_m}, false};
constexpr DisplacementBound kItself = {{0, 0}, true};

// nested ones too
DisplacementBound worst_of(Course& course, const std::vector<Selector>& selectors) {
  DisplacementBound worst = kItself;
  for (const Selector& selector : selectors) {
    const bool nests = selector.size == SizeKind::kRepeat;
    worst = worst_of(
        worst, nests ? worst_of(course, selector.nested) : reach_of_body(course.outlook, selector.body, course.frame));
    if (is_out_of_question(course.outlook, worst.moved.out_m)) break;
  }
  return worst;
}

bool fills(const std::vector<Selector>& selectors);

// A group inside of a repeated one is laid out once, as a list of its own.
bool is_filled_inside(const std::vector<Selector>& repeated) {
  return std::ranges::all_of(
      repeated, [](const Selector& selector) { return selector.size != SizeKind::kRepeat || fills(selector.nested); });
}

// Surely nothing of the length is lost: something floats, or one group is repeated as often as it takes.
bool fills(const std::vector<Selector>& selectors) {
  const auto is = [](SizeKind kind) { return [kind](const Selector& selector) { return selector.size == kind; }; };
  return (std::ranges::any_of(selectors, is(SizeKind::kFloating)) ||
          std::ranges::count_if(selectors, is(SizeKind::kRepeat)) == 1) &&
         std::ranges::all_of(selectors, [](const Selector& s) { return is_filled_inside(s.nested); });
}

bool fills(const Statement& split) {
  return split.repeated ? is_filled_inside(split.selectors) : fills(split.selectors);
}

bool has(const Statement& statement, const char* word) {
  return std::any_of(statement.selectors.begin(), statement.selectors.end(), [&](const Selector& selector) {
    return selector.key.target == Target::kWord && selector.key.text == word;
  });
}

void look_at_split(Course& course, const Statement& statement) {
  DisplacementBound pieces = worst_of(course, statement.selectors);
  // what no size takes is lost
  pieces.stays &= fills(statement);
  add_group(course, pieces, 0);
}

void look_at_setback(Course& course, const Statement& statement) {
  DisplacementBound parts = worst_of(course, statement.selectors);
  parts.stays &= has(statement, "all") && has(statement, "remainder");
  course.moved = course.moved + Displacement{kOfTheGrid_m, kOfTheGrid_m};
  add_group(course, parts, 0);
}

/// True if the word takes faces that the scope calls `side`, false if it does not; neither if that depends on more.
enum class Takes : std::uint8_t { kYes, kNo, kPerhaps };

Takes takes(const Selector& selector, const std::string& side) {
  if (selector.key.target != Target::kWord) return Takes::kPerhaps;
  const std::string& word = selector.key.text;
  if (word == "all" || word == side) return Takes::kYes;
  if (word == "side") return side == "front" || side == "back" ? Takes::kYes : Takes::kNo;
  return is_among(word, " front back left right top bottom ") ? Takes::kNo : Takes::kPerhaps;
}

// of the prism's end that the scope calls `side`
DisplacementBound reach_of_end(Course& course, const Statement& comp, const std::string& side) {
  for (const Selector& selector : comp.selectors) {
    const Takes taken = takes(selector, side);
    if (taken == Takes::kPerhaps) return kNothing;
    if (taken == Takes::kYes) return reach_of_body(course.outlook, selector.body, course.frame);
  }
  return kNothing;
}

// either end will do: both are within the height of each other
DisplacementBound reach_of_ends(Course& course, const Statement& comp, const char* one, const char* other) {
  const DisplacementBound a = reach_of_end(course, comp, one), b = reach_of_end(course, comp, other);
  if (!a.stays || (b.stays && b.moved.back_m < a.moved.back_m)) return b;
  return a;
}

void look_at_comp(Course& course, const Statement& statement) {
  DisplacementBound parts = worst_of(course, statement.selectors);
  if (course.form == Form::kFace) {
    parts.stays &= has(statement, "all");
    return add_group(course, parts, 0);
  }
  // ends are front and back of what stands, top and bottom of what lies
  const DisplacementBound ends =
      worst_of(reach_of_ends(course, statement, "front", "back"), reach_of_ends(course, statement, "top", "bottom"));
  add_group(course, {{parts.moved.out_m, ends.moved.back_m}, ends.stays}, course.height_m);
}

void look_at_extrude(Course& course, const Statement& statement) {
  const bool along_normal = statement.arguments.size() == 1;
  course.unbounded |= !along_normal || course.form != Form::kFace;
  course.height_m = largest_m(range_of(course.outlook, statement.arguments.back(), course.frame));
  course.form = Form::kPrism;
  course.moved.out_m += course.height_m;
}

void look_at_translation(Course& course, const Statement& statement) {
  double way_m = 0;
  for (const Expression& argument : statement.arguments)
    way_m += is_share(argument) ? kUnbounded_m : largest_m(range_of(course.outlook, argument, course.frame));
  course.moved = course.moved + Displacement{way_m, way_m};
}

bool sets_attribute(const Statement& statement) {
  return statement.name == "set" && statement.arguments.front().index != ~0u;
}

void look_at_operation(Course& course, const Statement& statement) {
  const OperationRow& row = operation_table()[statement.index];
  const bool is_face = course.form == Form::kFace;
  course.pending |= row.alters != Alters::kNothing;
  course.outlook.has_set |= sets_attribute(statement);
  if (statement.name == "comp" && course.form != Form::kUnknown) return look_at_comp(course, statement);
  if (statement.name == "split" && is_face) return look_at_split(course, statement);
  if (statement.name == "setback" && is_face) return look_at_setback(course, statement);
  if (statement.name == "extrude") return look_at_extrude(course, statement);
  if (statement.name == "t") return look_at_translation(course, statement);
  // the scope may be turned, but the face stays along its z: that is all that is used
  const bool keeps_form = statement.name == "reverseNormals" || (statement.name == "alignScopeToGeometry" && is_face);
  const bool moves = row.alters == Alters::kSurface || row.selectors != SelectorKind::kNone;
  course.unbounded |= moves || (row.alters == Alters::kFrame && !keeps_form);
}

void look_at_successor(Course& course, const Statement& statement) {
  if (statement.name == "NIL") return add_group(course, kNothing, 0);
  if (statement.index == ~0u) return add_group(course, kItself, 0);
  // a prism is no face
  if (course.form != Form::kFace) return void(course.unbounded = true);
  NumberRanges arguments;
  arguments.reserve(statement.arguments.size());
  for (const Expression& argument : statement.arguments)
    arguments.push_back(range_of(course.outlook, argument, course.frame));
  const Rule& rule = course.outlook.execution.run.program.rules[statement.index];
  add_group(course, reach_of_body(course.outlook, rule.body, arguments), 0);
}

void look_at_pop(Course& course) {
  if (course.pushed.empty()) return;
  std::tie(course.form, course.moved, course.height_m, course.outlook.has_set) = course.pushed.back();
  course.pushed.pop_back();
}

void look_at(Course& course, const Statement& statement) {
  switch (statement.kind) {
    case StatementKind::kOperation:
      return look_at_operation(course, statement);
    case StatementKind::kSuccessor:
      return look_at_successor(course, statement);
    case StatementKind::kPush:
      return void(course.pushed.emplace_back(course.form, course.moved, course.height_m, course.outlook.has_set));
    case StatementKind::kPop:
      return look_at_pop(course);
    case StatementKind::kBlock:
      course.unbounded = true;  // rare
  }
}

DisplacementBound reach_of_statements(BoundContext outlook, const Body& body, const NumberRanges& frame) {
  Course course{outlook, frame};
  for (const Statement& statement : body.statements) {
    look_at(course, statement);
    if (course.unbounded || is_out_of_question(outlook, course.out_m)) return {};
  }
  if (course.pending) add_group(course, kItself, 0);
  return {{course.out_m, course.back_m}, course.stays};
}

// A case that no branch fits leaves the shape as it is.
DisplacementBound reach_of_branches(BoundContext outlook, const Body& body, const NumberRanges& frame) {
  DisplacementBound worst = kItself;
  for (const Branch& branch : body.branches) {
    const bool is_tested = body.kind == BodyKind::kCase && !branch.is_else;
    const NumberRange test = is_tested ? range_of(outlook, branch.test, frame) : kEither;
    if (!is_false(test)) worst = worst_of(worst, reach_of_body(outlook, branch.body, frame));
    if (is_true(test) || is_out_of_question(outlook, worst.moved.out_m)) break;
  }
  return worst;
}

DisplacementBound reach_with(BoundContext outlook, const Body& body, const NumberRanges& frame) {
  const bool chooses = body.kind != BodyKind::kStatements;
  return chooses ? reach_of_branches(outlook, body, frame) : reach_of_statements(outlook, body, frame);
}

DisplacementBound found_reach(BoundContext outlook, const Body& body, const NumberRanges& frame) {
  BoundTable& table = outlook.execution.run.reaches;
  if (++outlook.depth > kDeepest || ++table.looks > kMostLooks) return {};
  if (body.locals.empty()) return reach_with(outlook, body, frame);
  NumberRanges with_locals = frame;
  for (const Local& local : body.locals) {
    const NumberRange value = range_of(outlook, local.value, with_locals);
    with_locals.resize(std::max<std::size_t>(with_locals.size(), local.slot + 1));
    with_locals[local.slot] = value;
  }
  return reach_with(outlook, body, with_locals);
}

bool only_ends(const Body& body) {
  const std::string* terminal = terminal_of(body);
  return terminal != nullptr && *terminal != "NIL";
}

// in what the body's reach depends on
bool are_alike(const Body& body, const NumberRanges& a, const NumberRanges& b) {
  if (body.displacement_slots == 0 || a.size() != b.size()) return body.displacement_slots == 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if ((body.displacement_slots >> std::min<std::size_t>(i, 63) & 1) != 0 && a[i] != b[i]) return false;
  return true;
}

DisplacementBound reach_of_body(BoundContext outlook, const Body& body, const NumberRanges& frame) {
  if (only_ends(body)) return kItself;
  BoundTable& table = outlook.execution.run.reaches;
  const std::uint32_t attributes = outlook.has_set ? kAnyAttributes : outlook.execution.shape.attributes;
  std::uint32_t& first = table.first_of[body.number];
  for (std::uint32_t i = first; i != 0; i = table.found[i - 1].next) {
    const KnownBound& known = table.found[i - 1];
    if (known.attributes == attributes && are_alike(body, known.arguments, frame)) return known.reach;
  }
  // what is under way is unbounded: a rule that comes to itself again
  const std::size_t place = table.found.size();
  table.found.push_back({attributes, frame, {}, first});
  first = static_cast<std::uint32_t>(place + 1);
  const DisplacementBound reach = found_reach(outlook, body, frame);
  return table.found[place].reach = reach;
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
  ranges.reserve(execution.frame.size());
  for (const Value& value : execution.frame) ranges.push_back(range_of_value(value));
  return ranges;
}

DisplacementBound displacement_bound(Execution& execution, const NumberRanges& arguments, const Body& body) {
  return reach_of_body({execution}, body, arguments);
}

std::optional<Displacement> bound_within_tolerance(Execution& execution, const Body& body) {
  const DeriveOptions& options = execution.run.options;
  if (!options.ahead || !execution.run.measures()) return std::nullopt;
  if (!body.divides || (options.keep_appearances && body.changes_appearance) || !is_flat(execution.shape))
    return std::nullopt;
  const DisplacementBound reach = displacement_bound(execution, ranges_of(execution), body);
  if (!reach.stays || reach.moved.largest_m() > options.tolerance_m) return std::nullopt;
  return reach.moved;
}

}  // namespace citykiln::grammars
