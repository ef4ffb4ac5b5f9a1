// Parts along the scope's axes: shapeL, shapeU, shapeO, innerRectangle.
#include <algorithm>
#include <cmath>

#include "grammars/operations/face_parts.h"
#include "grammars/operations/operations.h"
#include "grammars/shapes/cut.h"

namespace citykiln::grammars {
namespace {

/// The depths of the strips; 0 for none.
struct Depths {
  double front_m = 0, right_m = 0, back_m = 0, left_m = 0;
};

/// The extent of a face along its plan axes.
struct Extent {
  double low_m = HUGE_VAL, high_m = -HUGE_VAL;
};

Extent extent_of(const Face& face, Vec3 along) {
  Extent extent;
  for (const Vec3 p : face.outer) {
    extent.low_m = std::min(extent.low_m, dot(along, p));
    extent.high_m = std::max(extent.high_m, dot(along, p));
  }
  return extent;
}

/// One plane for each strip, which is above it.
std::vector<CutPlane> strip_planes(const PlanAxes& axes, const Face& face, const Depths& depths) {
  const Extent ahead = extent_of(face, axes.front), aside = extent_of(face, axes.right);
  std::vector<CutPlane> planes;
  const auto add = [&](Vec3 outward, double end_m, double depth_m) {
    if (depth_m > kSmallest_m) planes.push_back({outward, end_m - depth_m});
  };
  add(axes.front, ahead.high_m, depths.front_m);
  add(axes.right, aside.high_m, depths.right_m);
  add(axes.front * -1.0, -ahead.low_m, depths.back_m);
  add(axes.right * -1.0, -aside.low_m, depths.left_m);
  return planes;
}

/// A piece of the face, and whether it is in a strip.
struct Cell {
  Face face;
  bool in_strip = false;
};

// All planes cut all cells, so that neighbouring cells share whole edges and can be merged.
std::vector<Cell> cells_of(const Face& face, const std::vector<CutPlane>& planes) {
  std::vector<Cell> cells = {{face, false}};
  for (const CutPlane& plane : planes) {
    std::vector<Cell> finer;
    const CutPlane other{plane.normal * -1.0, -plane.offset_m};
    for (const Cell& cell : cells) {
      for (Face& strip : part_above(cell.face, plane)) finer.push_back({std::move(strip), true});
      for (Face& rest : part_above(cell.face, other)) finer.push_back({std::move(rest), cell.in_strip});
    }
    cells = std::move(finer);
  }
  return cells;
}

std::vector<Face> merged_cells(const std::vector<Cell>& cells, bool in_strip) {
  std::vector<Face> faces;
  for (const Cell& cell : cells)
    if (cell.in_strip == in_strip) faces.push_back(cell.face);
  return merged(faces);
}

void add_parts(Execution& execution, const Statement& statement, std::vector<Face> shape, std::vector<Face> rest,
               std::vector<PartOf>& parts) {
  const std::vector<Key> keys = keys_of(execution, statement, " shape remainder ");
  for (Face& face : shape) parts.push_back({std::move(face), index_of(keys, "shape")});
  for (Face& face : rest) parts.push_back({std::move(face), index_of(keys, "remainder")});
}

void cut_strips(Execution& execution, const Statement& statement, const Depths& depths) {
  std::vector<PartOf> parts;
  for (const Face& face : execution.shape.faces) {
    const PlanAxes axes = plan_axes(execution.shape.scope, face);
    const std::vector<Cell> cells = cells_of(face, strip_planes(axes, face, depths));
    add_parts(execution, statement, merged_cells(cells, true), merged_cells(cells, false), parts);
  }
  spawn_parts(execution, statement, std::move(parts), of_cutting(execution.shape.faces));
}

// ---- the inner rectangle

struct Rectangle {
  double low_x = 0, high_x = 0, low_y = 0, high_y = 0;
  double area() const { return (high_x - low_x) * (high_y - low_y); }
};

/// The part of a segment between two values of a coordinate, as parameters from 0 to 1.
struct Part {
  double from = 0, to = 1;
};

void narrow(Part& part, double start, double way, double low, double high) {
  if (way == 0) {
    if (start <= low || start >= high) part.to = -1;
    return;
  }
  const double t0 = (low - start) / way, t1 = (high - start) / way;
  part.from = std::max(part.from, std::min(t0, t1));
  part.to = std::min(part.to, std::max(t0, t1));
}

bool passes_through(Vec2 a, Vec2 b, const Rectangle& r) {
  constexpr double kBeside_m = 1e-7;  // along a side is not through
  Part part;
  narrow(part, a.x, b.x - a.x, r.low_x + kBeside_m, r.high_x - kBeside_m);
  narrow(part, a.y, b.y - a.y, r.low_y + kBeside_m, r.high_y - kBeside_m);
  return part.from < part.to;
}

bool passes_through(const Ring& ring, const Rectangle& r) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (passes_through(ring[i], ring[(i + 1) % ring.size()], r)) return true;
  return false;
}

/// True if the rectangle is in the polygon: its centre is, and no edge passes through it.
bool lies_in_polygon(const Polygon& polygon, const Rectangle& r) {
  if (!contains(polygon, {(r.low_x + r.high_x) / 2, (r.low_y + r.high_y) / 2})) return false;
  const auto passes = [&](const Ring& ring) { return passes_through(ring, r); };
  return !passes(polygon.outer) && std::none_of(polygon.holes.begin(), polygon.holes.end(), passes);
}

constexpr std::size_t kMostStops = 14;  // 14^4 / 4 rectangles are tried at most: some 10,000

// The coordinates tried for the sides of the rectangle: those of the vertices, and sevenths of the extent.
std::vector<double> stops_of(const Polygon& polygon, bool along_x) {
  std::vector<double> stops;
  for (const Vec2 p : polygon.outer) stops.push_back(along_x ? p.x : p.y);
  std::sort(stops.begin(), stops.end());
  const double low = stops.front(), high = stops.back();
  stops.erase(std::unique(stops.begin(), stops.end(), [](double a, double b) { return b - a < 1e-6; }), stops.end());
  if (stops.size() > kMostStops / 2) stops = {low, high};
  if (polygon.outer.size() != 4 || stops.size() > 2)
    for (int i = 1; i < 7; ++i) stops.push_back(low + (high - low) * i / 7);
  std::sort(stops.begin(), stops.end());
  return stops;
}

Rectangle largest_inside(const Polygon& polygon) {
  const std::vector<double> xs = stops_of(polygon, true), ys = stops_of(polygon, false);
  Rectangle best;
  for (std::size_t i = 0; i < xs.size(); ++i)
    for (std::size_t j = i + 1; j < xs.size(); ++j)
      for (std::size_t k = 0; k < ys.size(); ++k)
        for (std::size_t l = k + 1; l < ys.size(); ++l) {
          const Rectangle tried{xs[i], xs[j], ys[k], ys[l]};
          if (tried.area() > best.area() + 1e-9 && lies_in_polygon(polygon, tried)) best = tried;
        }
  return best;
}

/// The cells of four planes through the sides of the rectangle.
std::vector<Cell> cut_around(const Face& face, const PlanAxes& axes) {
  const Vec3 back = axes.front * -1.0;
  FaceFrame frame = frame_of(face);
  frame.x = axes.right, frame.y = back;
  const Rectangle inner = largest_inside(flat(face, frame));
  if (inner.area() <= kSmallest_m) return {{face, true}};
  const double x_m = dot(axes.right, frame.origin), y_m = dot(back, frame.origin);
  return cells_of(face, {{axes.right, x_m + inner.high_x},
                         {axes.right * -1.0, -(x_m + inner.low_x)},
                         {back, y_m + inner.high_y},
                         {back * -1.0, -(y_m + inner.low_y)}});
}

}  // namespace

void op_shape_l(Execution& execution, const Statement& statement, Arguments arguments) {
  cut_strips(execution, statement, {metres(arguments[0]), 0, 0, metres(arguments[1])});
}

void op_shape_u(Execution& execution, const Statement& statement, Arguments arguments) {
  cut_strips(execution, statement, {metres(arguments[0]), metres(arguments[1]), 0, metres(arguments[2])});
}

void op_shape_o(Execution& execution, const Statement& statement, Arguments arguments) {
  cut_strips(execution, statement,
             {metres(arguments[0]), metres(arguments[1]), metres(arguments[2]), metres(arguments[3])});
}

void op_inner_rectangle(Execution& execution, const Statement& statement, Arguments) {
  std::vector<PartOf> parts;
  for (const Face& face : execution.shape.faces) {
    if (!execution.run.spend(10000 * vertex_count({&face, 1}))) return;
    const std::vector<Cell> cells = cut_around(face, plan_axes(execution.shape.scope, face));
    add_parts(execution, statement, merged_cells(cells, false), merged_cells(cells, true), parts);
  }
  spawn_parts(execution, statement, std::move(parts), of_cutting(execution.shape.faces));
}

}  // namespace citykiln::grammars
