// split: pieces along an axis of the scope.
#include <algorithm>

#include "grammars/derivation/evaluate.h"
#include "grammars/derivation/sizes.h"
#include "grammars/operations/merge_pieces.h"
#include "grammars/operations/operations.h"
#include "grammars/shapes/cut.h"

namespace citykiln::grammars {
namespace {

struct Leaves {
  SmallVector<const Selector*, 8> selectors;  ///< By SizeItem::leaf.
};

SizeItem item_of(const Selector& selector, Context& context, Leaves& leaves) {
  SizeItem item;
  item.kind = selector.size;
  if (selector.size == SizeKind::kRepeat) {
    item.nested.reserve(selector.nested.size());
    for (const Selector& nested : selector.nested) item.nested.push_back(item_of(nested, context, leaves));
    return item;
  }
  const double size = number_of(evaluate(selector.key, context));
  item.size = std::clamp(size, 0.0, kMost_m);
  item.leaf = static_cast<std::uint32_t>(leaves.selectors.size());
  leaves.selectors.push_back(&selector);
  return item;
}

SmallVector<SizeItem, 8> items_of(const Statement& statement, Context& context, Leaves& leaves) {
  SmallVector<SizeItem, 8> items;
  items.reserve(statement.selectors.size());
  leaves.selectors.reserve(statement.selectors.size());
  for (const Selector& selector : statement.selectors) items.push_back(item_of(selector, context, leaves));
  if (!statement.repeated) return items;
  SmallVector<SizeItem, 8> all(1);
  all.front().kind = SizeKind::kRepeat;
  all.front().nested.assign(items.begin(), items.end());
  return all;
}

Scope slice_of(const Scope& scope, int axis, double from_m, double to_m) {
  Scope slice = scope;
  slice.origin = scope.origin + scope.axis[axis] * from_m;
  slice.size_m[axis] = to_m - from_m;
  return slice;
}

struct Saw {
  Vec3 along;
  double start_m = 0;  ///< Of the scope, along the axis.
  bool closed = false;
  std::vector<Face> rest;

  /// Takes off what lies before at_m.
  std::vector<Face> cut(double at_m) {
    const CutPlane above{along, start_m + at_m}, below{along * -1.0, -(start_m + at_m)};
    if (!closed && rest.size() == 1) {
      std::vector<Face> one(1);
      if (cut_in_two(rest.front(), above, one.front())) return one;
    }
    std::vector<Face> piece = solid_above(rest, below, closed);
    rest = solid_above(rest, above, closed);
    return piece;
  }
};

// a cap's points are no farther from its border than half its shorter side
Displacement cap_displacement(const Shape& shape, int axis, bool closed) {
  if (!closed) return {};
  const Scope box = scope_around(shape.faces, shape.scope.axis, shape.scope.origin);
  return {std::min(box.size_m[(axis + 1) % 3], box.size_m[(axis + 2) % 3]) / 2, 0};
}

Shape piece_shape(const Shape& from, Scope scope, std::vector<Face> faces, bool adjust) {
  Shape shape = inherited_from(from);
  shape.parent_scope = from.scope;
  shape.scope = scope;
  shape.faces = std::move(faces);
  if (adjust && !shape.faces.empty()) fit_scope(shape);
  return shape;
}

std::vector<Piece> saw_up(Execution& execution, int axis, std::span<const Slice> slices, const Leaves& leaves, Saw saw,
                          bool adjust) {
  std::vector<Piece> pieces;
  pieces.reserve(slices.size() + 1);
  const Shape& from = execution.shape;
  const double end_m = from.scope.size_m[axis];
  std::uint32_t left_out = 0;
  for (const Slice& cut : slices) {
    left_out += cut.left_out;
    if (!execution.run.spend(2 * vertex_count(saw.rest))) break;
    const Interval& interval = cut.interval;
    const bool last = interval.to_m >= end_m - kSliver_m;
    std::vector<Face> faces = last ? std::move(saw.rest) : saw.cut(interval.to_m);
    if (last) saw.rest.clear();
    if (faces.empty()) continue;
    const Scope slice = slice_of(from.scope, axis, interval.from_m, interval.to_m);
    const Selector* selector = leaves.selectors[interval.leaf];
    pieces.push_back({piece_shape(from, slice, std::move(faces), adjust), &selector->body, left_out});
    pieces.back().shape.in_split = {static_cast<double>(cut.index), static_cast<double>(cut.total)};
    left_out = 0;
  }
  const double used_m = slices.empty() ? 0 : slices.back().interval.to_m;
  if (!saw.rest.empty())
    pieces.push_back(
        {piece_shape(from, slice_of(from.scope, axis, used_m, end_m), std::move(saw.rest), true), nullptr});
  return pieces;
}

}  // namespace

void op_split(Execution& execution, const Statement& statement, Arguments arguments) {
  Run& run = execution.run;
  const std::string_view word = word_of(arguments[0]);
  const int axis = word == "x" ? 0 : word == "y" ? 1 : 2;
  const double length_m = execution.shape.scope.size_m[axis];
  if (execution.shape.faces.empty() || length_m <= kSliver_m)
    return run.warning(statement.place, "the shape has no size along " + std::string(word) + "; it is not split");
  Leaves leaves;
  Context context{run, execution.shape, execution.frame, execution.dice};
  const SmallVector<SizeItem, 8> items = items_of(statement, context, leaves);
  const std::uint64_t most = run.options.limits.shapes;
  const auto intervals = intervals_of(all_of(items), length_m, most > run.out.shapes ? most - run.out.shapes : 0);
  if (!intervals) return run.hit(LimitKind::kShapes, execution.name, statement.place);
  const Vec3 along = execution.shape.scope.axis[axis];
  const bool closed = is_closed(execution.shape.faces);
  Division division = divided(all_of(*intervals));
  if (may_widen(run, execution.shape))
    division = merge_narrow_pieces(execution, std::move(division), all_of(leaves.selectors));
  if (may_join(run, execution.shape)) division = join_terminals(std::move(division), all_of(leaves.selectors));
  run.out.error_m = std::max(run.out.error_m, division.error_m);
  Saw saw{along, dot(along, execution.shape.scope.origin), closed, execution.shape.faces};
  const bool adjust = arguments.size() < 2 || word_of(arguments[1]) == "adjust";
  const Displacement moved =
      cap_displacement(execution.shape, axis, closed) + Displacement{division.error_m, division.error_m};
  std::vector<Piece> pieces = saw_up(execution, axis, all_of(division.slices), leaves, std::move(saw), adjust);
  // half sawn is not split: the shape then ends whole
  if (!run.spend(0)) return run.hit(LimitKind::kSteps, execution.name, statement.place);
  const std::uint64_t first = execution.born;
  spawn_pieces(execution, std::move(pieces), moved);
  // what comes after is numbered alike whatever was left out
  if (division.slices.size() < intervals->size()) execution.born = std::max(execution.born, first + intervals->size());
}

}  // namespace citykiln::grammars
