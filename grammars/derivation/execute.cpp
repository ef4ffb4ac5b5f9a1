#include "grammars/derivation/execute.h"

#include <algorithm>
#include <cmath>

#include "grammars/derivation/sizes.h"
#include "grammars/operations/table.h"

namespace citykiln::grammars {
namespace {

constexpr double kWorld_m = 1e9;  // beyond it doubles no longer know millimetres

Ring3 surface_points(const Shape& shape) {
  if (shape.asset.empty()) return vertices_of(shape.faces);
  const auto corners = shape.scope.corners();
  return {corners.begin(), corners.end()};
}

// a node that shows many looks stays, and so do all that it is in: then nobody asks how far it moves
bool measures(const Execution& execution) { return execution.run.measures() && !execution.seen.are_many(); }

/// What a parent keeps of a child before it is derived: all points of its surface, the first face's ring first.
ChildTrace trace_of(const Execution& parent, const Shape& shape, Displacement before, std::uint32_t group) {
  return {before,
          {},
          false,
          group,
          shape.faces.size() > 0 && shape.faces.front().holes.empty(),
          measures(parent) ? surface_points(shape) : Ring3{}};
}

// of a survivor the first face's ring is enough: points that its surface surely holds
void complete(ChildTrace& trace, const Outcome& outcome, std::size_t first_ring) {
  trace.own = outcome.trace.moved;
  trace.vanished = outcome.trace.vanished;
  if (trace.vanished || trace.vertices.size() <= first_ring || first_ring == 0) return;
  trace.vertices = Ring3(trace.vertices.begin(), trace.vertices.begin() + first_ring);
}

std::size_t first_ring_of(const Shape& shape) { return shape.faces.empty() ? 0 : shape.faces.front().outer.size(); }

void add_child(Execution& execution, ChildTrace trace, const Outcome& outcome, std::size_t first_ring) {
  execution.vanished &= outcome.trace.vanished;
  execution.seen.add(outcome.trace.seen);
  if (!measures(execution)) return;
  complete(trace, outcome, first_ring);
  execution.children.push_back(std::move(trace));
}

// a node whose only successor has its whole surface is cut where that is: it need not remember where it began
void remember_start(Execution& execution) {
  if (execution.run.measures() && !execution.start) execution.start = execution.shape;
}

Outcome nothing() { return {}; }

// the child's number; `name` has to live in the program
std::uint32_t create_node(Execution& execution, const char* name) {
  Run& run = execution.run;
  run.nodes.push_back({execution.shape.birth, name, execution.born++});
  return static_cast<std::uint32_t>(run.nodes.size() - 1);
}

void set_node(Shape& shape, std::uint32_t birth) {
  shape.birth = birth;
  // what it was given just now is its own, what came earlier it has inherited
  shape.in_split.since = std::min(shape.in_split.since, birth);
  shape.in_comp.since = std::min(shape.in_comp.since, birth);
}

Outcome derive_successor(Execution& execution, const Statement& statement, Shape&& child, Frame arguments, int depth) {
  Run& run = execution.run;
  if (statement.name == "NIL") return nothing();
  if (statement.index == ~0u)
    return end_as_terminal(run, std::move(child), statement.name, run.path(execution.path, statement.name));
  const Rule& rule = run.program.rules[statement.index];
  return apply_rule(run, std::move(child), rule, std::move(arguments), depth, execution.path);
}

Frame frame_of(const Statement& successor, Context context) {
  Frame arguments;
  arguments.reserve(successor.arguments.size());
  for (const Expression& argument : successor.arguments) arguments.push_back(evaluate(argument, context));
  return arguments;
}

// as run_successor() of a node of the piece's own would
Outcome name_piece(Execution& execution, Shape&& shape, const Statement& successor) {
  Run& run = execution.run;
  RandomSource dice{"rule", 0, true, shape.birth};
  Frame arguments = frame_of(successor, {run, shape, execution.frame, dice});
  const auto birth = static_cast<std::uint32_t>(run.nodes.size());
  run.nodes.push_back({shape.birth, successor.name.c_str(), 0});
  ++run.out.shapes;
  shape.birth = birth;
  return derive_successor(execution, successor, std::move(shape), std::move(arguments), execution.depth + 2);
}

// not inlined, nor are other holders of shapes, so that blocks in each other cost the stack no shapes
// `last`: nothing asks for the current shape any more
[[gnu::noinline]] void run_successor(Execution& execution, const Statement& statement, bool last) {
  Frame arguments = frame_of(statement, context_of(execution));
  if (!last) remember_start(execution);
  ChildTrace trace = trace_of(execution, execution.shape, execution.moved, execution.groups++);
  const std::size_t first_ring = first_ring_of(execution.shape);
  const std::uint32_t newborn = create_node(execution, statement.name.c_str());
  ++execution.run.out.shapes;
  Shape child = last ? std::move(execution.shape) : execution.shape;
  set_node(child, newborn);
  const Outcome outcome =
      derive_successor(execution, statement, std::move(child), std::move(arguments), execution.depth + 1);
  add_child(execution, std::move(trace), outcome, first_ring);
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

void run_in_world(Execution& execution, const Statement& statement, const OperationRow& row,
                  std::span<const Argument> arguments) {
  // one copy will do for the start and for this
  const bool is_start = execution.run.measures() && !execution.start;
  std::optional<Shape> before;
  (is_start ? execution.start : before) = execution.shape;
  row.run(execution, statement, arguments);
  if (is_in_world(execution.shape)) return;
  execution.run.warning(statement.place,
                        "'" + statement.name + "' takes the shape out of the world; it stays as it was");
  execution.shape = is_start ? *execution.start : *before;
}

[[gnu::noinline]] void run_operation(Execution& execution, const Statement& statement) {
  Run& run = execution.run;
  const OperationRow& row = operation_table()[statement.index];
  Context context = context_of(execution);
  const SmallVector<Argument, 4> evaluated = arguments_of(statement, context);
  const std::span<const Argument> arguments = all_of(evaluated);
  if (!run.spend(1 + vertex_count(execution.shape.faces)))
    return run.hit(LimitKind::kSteps, execution.name, statement.place);
  execution.pending |= row.alters != Alters::kNothing;
  // what leaves the points where they are leaves them in the world
  if (row.alters == Alters::kSurface) return run_in_world(execution, statement, row, arguments);
  if (row.alters == Alters::kFrame || statement.has_selectors) remember_start(execution);
  row.run(execution, statement, arguments);
}

void pop(Execution& execution) {
  if (execution.pushed.empty()) return;
  execution.shape = std::move(execution.pushed.back().first);
  execution.moved = execution.pushed.back().second;
  execution.pushed.pop_back();
}

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

// what the rules have made of the current shape after its last successor
void end_pending(Execution& execution) {
  if (!execution.pending) return;
  ChildTrace trace = trace_of(execution, execution.shape, execution.moved, execution.groups++);
  const std::size_t first_ring = first_ring_of(execution.shape);
  set_node(execution.shape, create_node(execution, execution.name.c_str()));
  ++execution.run.out.shapes;
  const Outcome outcome = end_as_terminal(execution.run, std::move(execution.shape), execution.name, execution.path);
  add_child(execution, std::move(trace), outcome, first_ring);
}

double area_m2_of(const Terminal& terminal) {
  double sum_m2 = 0;
  for (const Face& face : terminal.faces) sum_m2 += area_m2(face);
  return sum_m2;
}

/// What would go if a node were cut.
struct Removed {
  AppearanceAreas areas_m2;   ///< Of all detail, also of what was cut before.
  std::uint32_t look = 0;     ///< Of most of it.
  std::uint32_t texture = 0;  ///< Of the largest that looks so; into Tables::textures.
};

// an asset is worth a cut whatever it weighs
std::size_t vertices_from(const Run& run, std::size_t first) {
  std::size_t count = 0;
  for (std::size_t i = first; i < run.out.terminals.size(); ++i) {
    const Terminal& terminal = run.out.terminals[i];
    count += terminal.asset.empty() ? vertex_count(terminal.faces) : 1000;
  }
  return count;
}

void weigh(const Run& run, std::size_t i, Removed& removed) {
  const Terminal& terminal = run.out.terminals[i];
  if (run.notes[i].stands_for == 0) {
    removed.areas_m2[terminal.look] += area_m2_of(terminal);
  } else {
    for (const auto& [look, m2] : run.tables.appearance_areas[run.notes[i].stands_for]) removed.areas_m2[look] += m2;
  }
}

// of equal ones the first, whatever rounding says
bool is_larger(double a_m2, double b_m2) { return a_m2 > b_m2 + 1e-6 * std::abs(b_m2); }

std::uint32_t look_of_most(const AppearanceAreas& areas_m2) {
  double most_m2 = -1;
  std::uint32_t look = 0;
  for (const auto& [each, m2] : areas_m2)
    if (is_larger(m2, most_m2)) most_m2 = m2, look = each;
  return look;
}

Removed weigh_from(const Run& run, std::size_t first) {
  Removed removed;
  for (std::size_t i = first; i < run.out.terminals.size(); ++i) weigh(run, i, removed);
  removed.look = look_of_most(removed.areas_m2);
  double largest_m2 = -1;
  for (std::size_t i = first; i < run.out.terminals.size(); ++i) {
    const Terminal& terminal = run.out.terminals[i];
    if (terminal.look != removed.look) continue;
    const double m2 = area_m2_of(terminal);
    if (!is_larger(m2, largest_m2)) continue;
    largest_m2 = m2;
    removed.texture = run.notes[i].texture;
  }
  return removed;
}

double length_around_m(std::span<const Vec3> ring) {
  double sum_m = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum_m += length(ring[(i + 1) % ring.size()] - ring[i]);
  return sum_m;
}

double extent_m(std::span<const Vec3> ring, Vec3 axis) {
  double low_m = kUnbounded_m, high_m = -kUnbounded_m;
  for (const Vec3 p : ring) low_m = std::min(low_m, dot(axis, p)), high_m = std::max(high_m, dot(axis, p));
  const double size_m = high_m - low_m;
  return size_m < kOnPlane_m ? 0 : size_m;
}

double narrower_side_m(std::span<const Vec3> ring, const std::array<Vec3, 3>& axis) {
  return ring.empty() ? 0 : std::min(extent_m(ring, axis[0]), extent_m(ring, axis[1]));
}

// the shorter side of its box; of a frame around a hole, the frame's own width
double width_m(const Face& face) {
  if (face.holes.empty()) return narrower_side_m(face.outer, axes_of(face));
  double border_m = length_around_m(face.outer);
  for (const Ring3& hole : face.holes) border_m += length_around_m(hole);
  return border_m > 0 ? 2 * area_m2(face) / border_m : narrower_side_m(face.outer, axes_of(face));
}

bool is_rectangle(std::span<const Vec3> ring) {
  if (ring.size() != 4) return false;
  const Vec3 a = ring[1] - ring[0], b = ring[2] - ring[1];
  return length(ring[3] - ring[2] + a) < kOnPlane_m && std::abs(dot(a, b)) < kOnPlane_m;
}

// a rectangle is nowhere narrower than its shorter side
bool is_surely_wider(const Face& face, double than_m) {
  if (!face.holes.empty() || !is_rectangle(face.outer)) return false;
  return std::min(length(face.outer[1] - face.outer[0]), length(face.outer[2] - face.outer[1])) > 2 * than_m;
}

double width_m(const Terminal& terminal) {
  double widest_m = terminal.asset.empty() ? 0 : terminal.scope.diagonal_m();
  for (const Face& face : terminal.faces) widest_m = std::max(widest_m, width_m(face));
  return widest_m;
}

// by its look, what is wider than the tolerance
VisibleAppearances seen_of(const Run& run, const Terminal& terminal) {
  if (!run.measures() || !run.options.keep_appearances) return {};
  const double narrow_m = run.options.tolerance_m + kSliver_m;
  const bool is_wide = !terminal.faces.empty() && is_surely_wider(terminal.faces.front(), narrow_m);
  if (!is_wide && width_m(terminal) <= narrow_m) return {};
  return {VisibleAppearances::Count::kOne, terminal.look};
}

bool may_be_cut(const Run& run, const Outcome& outcome, const Shape& start) {
  if (outcome.trace.vanished || outcome.trace.seen.are_many()) return false;
  if (start.faces.empty() || !start.asset.empty()) return false;
  return outcome.trace.moved.largest_m() <= run.options.tolerance_m;
}

// puts the node's own surface in the place of all that was made of it, if that is less
void cut_if_near(Execution& execution, const Shape& start, std::size_t first, Outcome& outcome) {
  Run& run = execution.run;
  std::vector<Terminal>& terminals = run.out.terminals;
  if (!may_be_cut(run, outcome, start)) return;
  if (run.options.keep_start && execution.depth <= 1) return;
  if (vertex_count(start.faces) >= vertices_from(run, first)) return;
  Removed removed = weigh_from(run, first);
  // something that is wide enough to be seen looks otherwise
  if (outcome.trace.seen.show_other_than(removed.look)) return;
  cut_away_from(run, first);
  terminals.push_back({{},
                       execution.name,
                       execution.path,
                       removed.look,
                       start.faces,
                       run.tables.texture_at(removed.texture),
                       {},
                       start.scope,
                       true,
                       outcome.trace.moved.largest_m(),
                       outcome.trace.moved.out_m});
  run.notes.push_back({start.birth, removed.texture, run.tables.add(std::move(removed.areas_m2))});
  outcome.trace.seen = seen_of(run, terminals.back());
}

NodeTrace traced(const Execution& execution) {
  if (!execution.run.measures()) return {{}, execution.vanished};
  if (execution.seen.are_many()) return {{kUnbounded_m, kUnbounded_m}, false, execution.seen};
  NodeTrace trace = together(all_of(execution.children));
  trace.seen = execution.seen;
  return trace;
}

// the node's own surface for all that would be made of it
Outcome end_ahead(Execution& execution, Displacement moved) {
  Run& run = execution.run;
  Outcome outcome = end_as_terminal(run, std::move(execution.shape), execution.name, execution.path);
  run.out.terminals.back().cut = true;
  run.out.terminals.back().error_m = moved.largest_m();
  run.out.terminals.back().out_m = moved.out_m;
  outcome.trace.moved = moved;
  return outcome;
}

Outcome run_node(Execution& execution, const Body& body) {
  if (const auto moved = bound_within_tolerance(execution, body)) return end_ahead(execution, *moved);
  const Recording recording = begin_recording(execution, body);
  if (recording.known) return {repeat(execution, recording)};
  const std::size_t first = execution.run.out.terminals.size();
  run_body(execution, body, true);
  end_pending(execution);
  Outcome outcome{traced(execution)};
  if (execution.start) cut_if_near(execution, *execution.start, first, outcome);
  end_recording(execution.run, body, recording, outcome.trace);
  return outcome;
}

// `Wall.` or `Tile(3)`, as most pieces of facades have it: a node of which nothing is left but its successor's
bool only_names_successor(const Body& body) {
  return body.kind == BodyKind::kStatements && body.statements.size() == 1 && body.locals.empty() &&
         body.statements.front().kind == StatementKind::kSuccessor;
}

Outcome run_piece(Execution& execution, Shape&& shape, const Body& body) {
  Run& run = execution.run;
  if (only_names_successor(body)) return name_piece(execution, std::move(shape), body.statements.front());
  const RandomSource dice{"rule", 0, true, shape.birth};
  Execution inner{run, std::move(shape), execution.frame, dice, execution.depth + 1, execution.path, execution.name};
  return run_node(inner, body);
}

}  // namespace

Outcome end_as_terminal(Run& run, Shape&& shape, const std::string& name, std::uint32_t path) {
  if (shape.faces.empty() && shape.asset.empty()) return nothing();
  run.notes.push_back({shape.birth, shape.texture, 0});
  Terminal& terminal = run.out.terminals.emplace_back();
  terminal.name = name;
  terminal.path = path;
  terminal.look = run.appearance_index(shape.look);
  terminal.faces = std::move(shape.faces);
  terminal.texture = run.tables.texture_at(shape.texture);
  terminal.asset = std::move(shape.asset);
  terminal.scope = shape.scope;
  return {{{}, false, seen_of(run, terminal)}};
}

void run_body(Execution& execution, const Body& body, bool last) {
  Context context = context_of(execution);
  for (const Local& local : body.locals) {
    Value value = evaluate(local.value, context);
    execution.frame.resize(std::max<std::size_t>(execution.frame.size(), local.slot + 1), Value(0.0));
    execution.frame[local.slot] = std::move(value);
  }
  if (body.kind == BodyKind::kStatements) {
    for (const Statement& statement : body.statements)
      run_statement(execution, statement, last && &statement == &body.statements.back());
    return;
  }
  const int branch = chosen_branch(body, context);
  if (branch >= 0) run_body(execution, body.branches[static_cast<std::size_t>(branch)].body, last);
}

Outcome apply_rule(Run& run, Shape&& shape, const Rule& rule, Frame frame, int depth, std::uint32_t parent_path) {
  const std::uint32_t path = run.path(parent_path, rule.name);
  came_to(run.memo, depth);
  const bool too_deep = depth > run.options.limits.depth, too_many = run.out.shapes > run.options.limits.shapes;
  if (too_deep) run.hit(LimitKind::kDepth, rule.name, rule.place);
  if (too_many) run.hit(LimitKind::kShapes, rule.name, rule.place);
  const bool spent = !run.spend(1);
  if (spent) run.hit(LimitKind::kSteps, rule.name, rule.place);
  if (too_deep || too_many || spent) return end_as_terminal(run, std::move(shape), rule.name, path);
  const RandomSource dice{"rule", 0, true, shape.birth};
  Execution execution{run, std::move(shape), std::move(frame), dice, depth, path, rule.name};
  return run_node(execution, rule.body);
}

void spawn_pieces(Execution& execution, std::vector<Piece> pieces, Displacement moved) {
  Run& run = execution.run;
  const std::uint32_t group = execution.groups++;
  const Displacement before = execution.moved + moved;
  run.out.shapes += pieces.size();
  if (measures(execution)) execution.children.reserve(execution.children.size() + pieces.size());
  for (Piece& piece : pieces) {
    execution.born += piece.left_out;
    set_node(piece.shape, create_node(execution, "piece"));
    ChildTrace trace = trace_of(execution, piece.shape, before, group);
    const std::size_t first_ring = first_ring_of(piece.shape);
    const Outcome outcome =
        piece.body == nullptr ? nothing() : run_piece(execution, std::move(piece.shape), *piece.body);
    add_child(execution, std::move(trace), outcome, first_ring);
  }
  execution.pending = false;
}

}  // namespace citykiln::grammars
