// split: pieces along an axis of the scope.
#include <fmt/format.h>

#include <algorithm>

#include "grammars/derivation/evaluate.h"
#include "grammars/derivation/sizes.h"
#include "grammars/operations/merge_pieces.h"
#include "grammars/operations/operations.h"
#include "grammars/shapes/cut.h"

namespace citykiln::grammars {
namespace {

/// The selectors by SizeItem::leaf.
using Leaves = SmallVector<const Selector*, 8>;

// Negative sizes count as 0. In a repeated group they are a mistake: the group would be repeated without end.
SizeItem item_of(const Selector& selector, Context& context, Leaves& leaves, bool is_repeated) {
  SizeItem item;
  item.kind = selector.size;
  if (selector.size == SizeKind::kRepeat) {
    item.nested.reserve(selector.nested.size());
    for (const Selector& nested : selector.nested) item.nested.push_back(item_of(nested, context, leaves, true));
    return item;
  }
  const double size = number_of(evaluate(selector.key, context));
  if (is_repeated && size < 0)
    context.run.warn(selector.position, fmt::format("a size of {:g} in a repeated group; it counts as 0", size));
  item.size = std::clamp(size, 0.0, kMost_m);
  item.leaf = static_cast<std::uint32_t>(leaves.size());
  leaves.push_back(&selector);
  return item;
}

SmallVector<SizeItem, 8> items_of(const Statement& statement, Context& context, Leaves& leaves) {
  SmallVector<SizeItem, 8> items;
  items.reserve(statement.selectors.size());
  leaves.reserve(statement.selectors.size());
  for (const Selector& selector : statement.selectors)
    items.push_back(item_of(selector, context, leaves, statement.repeated));
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

/// Cuts slices off a shape, in order along an axis.
struct Slicer {
  Vec3 along;
  double start_m = 0;  ///< The size of the scope along the axis.
  bool closed = false;
  std::vector<Face> rest;

  /// Cuts the shape of an edge (comp(e)).
  std::vector<Face> cut_edge(double at_m) {
    Ring3& edge = rest.front().outer;
    const double from_m = dot(along, edge[0]), to_m = dot(along, edge[1]);
    const double share = to_m == from_m ? 0 : (start_m + at_m - from_m) / (to_m - from_m);
    const Vec3 middle = edge[0] + (edge[1] - edge[0]) * std::clamp(share, 0.0, 1.0);
    std::vector<Face> piece(1);
    piece.front().outer = {edge[0], middle};
    edge[0] = middle;
    return piece;
  }

  /// Cuts off and returns the part before at_m.
  std::vector<Face> cut(double at_m) {
    if (rest.size() == 1 && rest.front().outer.size() == 2) return cut_edge(at_m);
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

// A point of a cap is within half its shorter side of its border.
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

std::vector<Piece> slices_of(Execution& execution, int axis, std::span<const Slice> slices, const Leaves& leaves,
                             Slicer slicer, bool adjust) {
  std::vector<Piece> pieces;
  pieces.reserve(slices.size() + 1);
  const Shape& from = execution.shape;
  const double end_m = from.scope.size_m[axis];
  std::uint32_t left_out = 0;
  for (const Slice& cut : slices) {
    left_out += cut.left_out;
    if (!execution.run.spend(2 * vertex_count(slicer.rest))) break;
    const Interval& interval = cut.interval;
    const bool last = interval.to_m >= end_m - kSliver_m;
    std::vector<Face> faces = last ? std::move(slicer.rest) : slicer.cut(interval.to_m);
    if (last) slicer.rest.clear();
    if (faces.empty()) continue;
    const Scope slice = slice_of(from.scope, axis, interval.from_m, interval.to_m);
    const Selector* selector = leaves[interval.leaf];
    pieces.push_back({piece_shape(from, slice, std::move(faces), adjust), &selector->body, left_out});
    pieces.back().shape.in_split = {static_cast<double>(cut.index), static_cast<double>(cut.total)};
    left_out = 0;
  }
  const double used_m = slices.empty() ? 0 : slices.back().interval.to_m;
  if (!slicer.rest.empty())
    pieces.push_back(
        {piece_shape(from, slice_of(from.scope, axis, used_m, end_m), std::move(slicer.rest), true), nullptr});
  return pieces;
}

}  // namespace

void op_split(Execution& execution, const Statement& statement, Arguments arguments) {
  Run& run = execution.run;
  const std::string_view word = word_of(arguments[0]);
  const int axis = word == "x" ? 0 : word == "y" ? 1 : 2;
  const double length_m = execution.shape.scope.size_m[axis];
  if (execution.shape.faces.empty() || length_m <= kSliver_m)
    return run.warn(statement.position, "the shape has no size along " + std::string(word) + "; it is not split");
  Leaves leaves;
  Context context = context_of(execution);
  const SmallVector<SizeItem, 8> items = items_of(statement, context, leaves);
  const std::uint64_t most = run.options.limits.shapes;
  const auto intervals = intervals_of(span_of(items), length_m, most > run.out.shapes ? most - run.out.shapes : 0);
  if (!intervals) return run.hit(LimitKind::kShapes, execution.name, statement.position);
  const Vec3 along = execution.shape.scope.axis[axis];
  const bool closed = is_closed(execution.shape.faces);
  Division division = divided(span_of(*intervals));
  if (may_merge_narrow(run, execution.shape))
    division = merge_narrow_pieces(execution, std::move(division), span_of(leaves));
  if (may_merge_terminals(run, execution.shape)) division = merge_terminals(std::move(division), span_of(leaves));
  run.merged_m = std::max(run.merged_m, division.error_m);
  run.out.error_m = std::max(run.out.error_m, division.error_m);
  Slicer slicer{along, dot(along, execution.shape.scope.origin), closed, execution.shape.faces};
  const bool adjust = arguments.size() < 2 || word_of(arguments[1]) == "adjust";
  const Displacement moved =
      cap_displacement(execution.shape, axis, closed) + Displacement{division.error_m, division.error_m};
  std::vector<Piece> pieces = slices_of(execution, axis, span_of(division.slices), leaves, std::move(slicer), adjust);
  // a split that a limit interrupts has no effect
  if (!run.spend(0)) return run.hit(LimitKind::kSteps, execution.name, statement.position);
  const std::uint64_t first = execution.child_count;
  spawn_pieces(execution, std::move(pieces), moved);
  // later children have the same ordinals whatever was left out
  if (division.slices.size() < intervals->size())
    execution.child_count = std::max(execution.child_count, first + intervals->size());
}

}  // namespace citykiln::grammars
