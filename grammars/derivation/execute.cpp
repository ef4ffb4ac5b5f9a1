#include "grammars/derivation/execute.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "grammars/derivation/element.h"
#include "grammars/derivation/leave_out_details.h"
#include "grammars/derivation/simplify.h"
#include "grammars/language/operation_table.h"

namespace citykiln::grammars {
namespace {

constexpr double kWorld_m = 1e9;  // farther out, doubles are coarser than 0.1 µm

// A node with several visible appearances is not simplified, nor are its ancestors, so its displacement is not needed.
bool measures(const Execution& execution) { return execution.run.measures() && !execution.seen.are_many(); }

/// A child from before its derivation until its result is known.
struct OpenChild {
  ChildTrace trace;            ///< `vertices`: all points of its surface, those of the first ring first.
  std::size_t first_ring = 0;  ///< The number of points of the first ring.
  std::size_t first_terminal = 0;
  bool may_be_left_out = false;
};

OpenChild open_child(const Execution& parent, const Shape& shape, Displacement before, std::uint32_t group) {
  const bool has_faces = !shape.faces.empty();
  return {.trace = {.before = before,
                    .own = {},
                    .vanished = false,
                    .group = group,
                    .filled = has_faces && shape.faces.front().holes.empty(),
                    .vertices = measures(parent) ? surface_points(shape) : Ring3{}},
          .first_ring = has_faces ? shape.faces.front().outer.size() : 0,
          .first_terminal = parent.run.out.terminals.size(),
          .may_be_left_out = shape.leaves_out_details};
}

void close_child(Execution& execution, OpenChild child, const NodeTrace& result) {
  execution.vanished &= result.vanished;
  execution.seen.add(result.seen);
  execution.left_out_m = std::max(execution.left_out_m, result.left_out_m);
  if (child.may_be_left_out && execution.run.measures() && !result.vanished)
    execution.details.push_back({{child.first_terminal, execution.run.out.terminals.size()}, result.left_out_m});
  if (!measures(execution)) return;
  ChildTrace& trace = child.trace;
  trace.own = result.moved;
  trace.vanished = result.vanished;
  // for a child with a surface, one ring that surely belongs to it is enough
  if (!trace.vanished && child.first_ring > 0 && trace.vertices.size() > child.first_ring)
    trace.vertices = Ring3(trace.vertices.begin(), trace.vertices.begin() + child.first_ring);
  execution.children.push_back(std::move(trace));
}

// Keeps the start shape of a node whose shape is about to change. A node with one successor of its whole surface needs
// none, because the successor is simplified instead.
void remember_start(Execution& execution) {
  if (execution.run.measures() && !execution.start) execution.start = execution.shape;
}

// @param name  Part of the program, which outlives the run.
std::uint32_t create_node(Execution& execution, const char* name) {
  Run& run = execution.run;
  run.nodes.push_back({execution.shape.node, name, execution.child_count++});
  return static_cast<std::uint32_t>(run.nodes.size() - 1);
}

void set_node(Shape& shape, std::uint32_t node) {
  shape.node = node;
  // indices assigned just now are still ~0 and become its own, older ones are inherited
  shape.in_split.since_node = std::min(shape.in_split.since_node, node);
  shape.in_comp.since_node = std::min(shape.in_comp.since_node, node);
}

NodeTrace derive_successor(Execution& execution, const Statement& statement, Shape&& child, Slots arguments,
                           int depth) {
  Run& run = execution.run;
  if (statement.name == "NIL") return {};
  if (statement.index == ~0u)
    return end_as_terminal(run, std::move(child), statement.name, run.path(execution.path, statement.name));
  const Rule& rule = run.program.rules[statement.index];
  return apply_rule(run, std::move(child), rule, std::move(arguments), depth, execution.path);
}

Slots arguments_of_successor(const Statement& successor, Context context) {
  Slots arguments;
  arguments.reserve(successor.arguments.size());
  for (const Expression& argument : successor.arguments) arguments.push_back(evaluate(argument, context));
  return arguments;
}

// A piece whose body is only a successor. Gives the same nodes as run_piece() with run_successor(), at less cost.
NodeTrace name_piece(Execution& execution, Shape&& shape, const Statement& successor) {
  Run& run = execution.run;
  RandomSource random{.node = shape.node};
  Slots arguments = arguments_of_successor(successor, {run, shape, execution.slots, random});
  const auto node = static_cast<std::uint32_t>(run.nodes.size());
  run.nodes.push_back({shape.node, successor.name.c_str(), 0});
  ++run.out.shapes;
  shape.node = node;
  return derive_successor(execution, successor, std::move(shape), std::move(arguments), execution.depth + 2);
}

// Functions with local shapes are not inlined, so that nested blocks take little of the stack.
// @param last  The current shape is not needed any more.
[[gnu::noinline]] void run_successor(Execution& execution, const Statement& statement, bool last) {
  Slots arguments = arguments_of_successor(statement, context_of(execution));
  if (!last) remember_start(execution);
  OpenChild open = open_child(execution, execution.shape, execution.moved, execution.groups++);
  const std::uint32_t node = create_node(execution, statement.name.c_str());
  ++execution.run.out.shapes;
  Shape child = last ? std::move(execution.shape) : execution.shape;
  set_node(child, node);
  const NodeTrace result =
      derive_successor(execution, statement, std::move(child), std::move(arguments), execution.depth + 1);
  close_child(execution, std::move(open), result);
  execution.pending = false;
}

SmallVector<Argument, 4> arguments_of(const Statement& statement, Context& context) {
  SmallVector<Argument, 4> arguments;
  arguments.reserve(statement.arguments.size());
  for (const Expression& expression : statement.arguments) {
    Argument& argument = arguments.emplace_back();
    argument.relative = is_share(expression);
    if (expression.target == Target::kWord) {
      argument.word = &expression;
    } else {
      argument.value = evaluate(argument.relative ? expression.operands[0] : expression, context);
    }
  }
  return arguments;
}

bool is_in_world(const Shape& shape) {
  const auto fits = [](Vec3 p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z) < kWorld_m; };
  bool all = fits(shape.scope.origin) && shape.scope.diagonal_m() < kWorld_m;
  for (const Face& face : shape.faces) each_vertex(face, [&](Vec3 p) { all &= fits(p); });
  return all;
}

void run_in_world(Execution& execution, const Statement& statement, Arguments arguments) {
  // the start shape, if it is kept now, is also the one to return to
  const bool is_start = execution.run.measures() && !execution.start;
  std::optional<Shape> before;
  (is_start ? execution.start : before) = execution.shape;
  operation_function(statement.index)(execution, statement, arguments);
  if (is_in_world(execution.shape)) return;
  execution.run.warn(statement.position,
                     "'" + statement.name + "' takes the shape out of the world; it stays as it was");
  execution.shape = is_start ? *execution.start : *before;
}

// True for the shape of an edge or a point, if the operation is about faces.
bool lacks_surface(const Shape& shape, const OperationRow& row) {
  constexpr const char* kOfFaces =
      " extrude taper roofGable roofHip roofPyramid roofShed roofMansard comp setback offset shapeL shapeU shapeO "
      "innerRectangle alignScopeToAxes alignScopeToGeometry reverseNormals ";
  return !shape.faces.empty() && !has_surface(shape.faces) && is_among(row.name, kOfFaces);
}

[[gnu::noinline]] void run_operation(Execution& execution, const Statement& statement) {
  Run& run = execution.run;
  const OperationRow& row = operation_table()[statement.index];
  Context context = context_of(execution);
  const SmallVector<Argument, 4> evaluated = arguments_of(statement, context);
  const Arguments arguments = span_of(evaluated);
  if (!run.spend(1 + vertex_count(execution.shape.faces)))
    return run.hit(LimitKind::kSteps, execution.name, statement.position);
  execution.pending |= row.alters != Alters::kNothing;
  if (lacks_surface(execution.shape, row))
    return run.warn(statement.position, "the shape is an edge or a point; '" + statement.name + "' has no effect");
  if (row.alters == Alters::kSurface) return run_in_world(execution, statement, arguments);
  if (row.alters == Alters::kFrame || statement.has_selectors) remember_start(execution);
  operation_function(statement.index)(execution, statement, arguments);
}

void pop(Execution& execution) {
  if (execution.pushed.empty()) return;
  execution.shape = std::move(execution.pushed.back().first);
  execution.moved = execution.pushed.back().second;
  execution.pushed.pop_back();
}

void run_body(Execution& execution, const Body& body, bool last);

void run_statement(Execution& execution, const Statement& statement, bool last) {
  switch (statement.kind) {
    case StatementKind::kOperation:
      return run_operation(execution, statement);
    case StatementKind::kSuccessor:
      return run_successor(execution, statement, last);
    case StatementKind::kPush:
      execution.run.spend(vertex_count(execution.shape.faces));
      return void(execution.pushed.emplace_back(execution.shape, execution.moved));
    case StatementKind::kPop:
      return pop(execution);
    case StatementKind::kBlock:
      return run_body(execution, statement.block.front(), false);
  }
}

// @param last  Nothing follows the body, so its last successor may take the shape without a copy.
void run_body(Execution& execution, const Body& body, bool last) {
  Context context = context_of(execution);
  for (const Local& local : body.locals) {
    Value value = evaluate(local.value, context);
    execution.slots.resize(std::max<std::size_t>(execution.slots.size(), local.slot + 1), Value(0.0));
    execution.slots[local.slot] = std::move(value);
  }
  if (body.kind == BodyKind::kStatements) {
    for (const Statement& statement : body.statements)
      run_statement(execution, statement, last && &statement == &body.statements.back());
    return;
  }
  const int branch = chosen_branch(body, context);
  if (branch >= 0) run_body(execution, body.branches[static_cast<std::size_t>(branch)].body, last);
}

// A shape that was changed after its last successor becomes a terminal.
void end_pending(Execution& execution) {
  if (!execution.pending) return;
  OpenChild child = open_child(execution, execution.shape, execution.moved, execution.groups++);
  set_node(execution.shape, create_node(execution, execution.name.c_str()));
  ++execution.run.out.shapes;
  const NodeTrace result = end_as_terminal(execution.run, std::move(execution.shape), execution.name, execution.path);
  close_child(execution, std::move(child), result);
}

NodeTrace trace_of(const Execution& execution) {
  if (!execution.run.measures()) return {{}, execution.vanished};
  if (execution.seen.are_many()) return {{kUnbounded_m, kUnbounded_m}, false, execution.seen};
  NodeTrace trace = combine(span_of(execution.children));
  trace.seen = execution.seen;
  return trace;
}

// Ends the node as its own surface, before anything is derived of it.
NodeTrace prune(Execution& execution, Displacement moved) {
  Run& run = execution.run;
  NodeTrace trace = end_as_terminal(run, std::move(execution.shape), execution.name, execution.path);
  Terminal& terminal = run.out.terminals.back();
  terminal.simplified = true;
  terminal.error_m += moved.largest_m();
  terminal.detail_distance_m = moved.to_earlier_m;
  trace.moved = moved;
  return trace;
}

// Derives all detail of the node and puts its rectangle in the detail's place.
NodeTrace draw_element(Execution& execution, const Body& body, const ElementPlace& place) {
  Run& run = execution.run;
  const std::size_t first = run.out.terminals.size();
  Shape rectangle = std::exchange(execution.shape, place.shape);
  run.is_in_element = true;
  run_body(execution, body, true);
  end_pending(execution);
  run.is_in_element = false;
  return replace_by_element(run, std::move(rectangle), place, first);
}

NodeTrace run_node(Execution& execution, const Body& body) {
  const std::optional<ElementPlace> place = element_place(execution, body);
  if (const auto moved = place ? std::nullopt : bound_within_tolerance(execution, body))
    return prune(execution, *moved);
  const Recording recording = begin_recording(execution, body);
  if (recording.known) return repeat(execution, recording);
  if (place) {
    const NodeTrace trace = draw_element(execution, body, *place);
    end_recording(execution.run, body, recording, trace);
    return trace;
  }
  const std::size_t first = execution.run.out.terminals.size();
  run_body(execution, body, true);
  end_pending(execution);
  leave_out_details(execution, first);
  NodeTrace trace = trace_of(execution);
  trace.left_out_m = execution.left_out_m;
  if (execution.start) simplify_node(execution, *execution.start, first, trace);
  end_recording(execution.run, body, recording, trace);
  return trace;
}

// `Wall.` or `Tile(3)`, the most frequent bodies of pieces.
bool only_names_successor(const Body& body) {
  return body.kind == BodyKind::kStatements && body.statements.size() == 1 && body.locals.empty() &&
         body.statements.front().kind == StatementKind::kSuccessor;
}

NodeTrace run_piece(Execution& execution, Shape&& shape, const Body& body) {
  if (only_names_successor(body)) return name_piece(execution, std::move(shape), body.statements.front());
  const RandomSource random{.node = shape.node};
  Execution inner{.run = execution.run,
                  .shape = std::move(shape),
                  .slots = execution.slots,
                  .random = random,
                  .depth = execution.depth + 1,
                  .path = execution.path,
                  .name = execution.name};
  return run_node(inner, body);
}

}  // namespace

Ring3 surface_points(const Shape& shape) {
  if (shape.asset.empty()) return vertices_of(shape.faces);
  const auto corners = shape.scope.corners();
  return {corners.begin(), corners.end()};
}

NodeTrace end_as_terminal(Run& run, Shape&& shape, const std::string& name, std::uint32_t path) {
  if (!has_surface(shape.faces) && shape.asset.empty()) return {};
  run.origins.push_back({shape.node, shape.texture, 0});
  Terminal& terminal = run.out.terminals.emplace_back();
  terminal.name = name;
  terminal.path = path;
  terminal.appearance = run.appearance_index(shape.appearance);
  terminal.faces = std::move(shape.faces);
  terminal.texture = run.tables.texture_at(shape.texture);
  terminal.asset = std::move(shape.asset);
  terminal.scope = shape.scope;
  terminal.error_m = shape.deviation_m;
  return {{}, false, visible_appearance(run, terminal)};
}

NodeTrace apply_rule(Run& run, Shape&& shape, const Rule& rule, Slots slots, int depth, std::uint32_t parent_path) {
  assert(slots.size() >= rule.parameters.size());
  const std::uint32_t path = run.path(parent_path, rule.name);
  note_depth(run.memo, depth);
  const bool too_deep = depth > run.options.limits.depth || run.depth_hits >= kMostDepthHits,
             too_many = run.out.shapes > run.options.limits.shapes;
  if (too_deep) run.hit(LimitKind::kDepth, rule.name, rule.position);
  if (too_many) run.hit(LimitKind::kShapes, rule.name, rule.position);
  const bool spent = !run.spend(1);
  if (spent) run.hit(LimitKind::kSteps, rule.name, rule.position);
  if (too_deep || too_many || spent) return end_as_terminal(run, std::move(shape), rule.name, path);
  const RandomSource random{.node = shape.node};
  Execution execution{.run = run,
                      .shape = std::move(shape),
                      .slots = std::move(slots),
                      .random = random,
                      .depth = depth,
                      .path = path,
                      .name = rule.name};
  return run_node(execution, rule.body);
}

void spawn_pieces(Execution& execution, std::vector<Piece> pieces, Displacement moved) {
  Run& run = execution.run;
  const std::uint32_t group = execution.groups++;
  const Displacement before = execution.moved + moved;
  run.out.shapes += pieces.size();
  if (measures(execution)) execution.children.reserve(execution.children.size() + pieces.size());
  for (Piece& piece : pieces) {
    execution.child_count += piece.left_out;
    set_node(piece.shape, create_node(execution, "piece"));
    OpenChild child = open_child(execution, piece.shape, before, group);
    child.may_be_left_out = false;  // pieces of one surface would leave holes in it
    const NodeTrace result =
        piece.body == nullptr ? NodeTrace{} : run_piece(execution, std::move(piece.shape), *piece.body);
    close_child(execution, std::move(child), result);
  }
  execution.pending = false;
}

}  // namespace citykiln::grammars
