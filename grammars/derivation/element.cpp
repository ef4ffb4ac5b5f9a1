#include "grammars/derivation/element.h"

#include <algorithm>
#include <cmath>

#include "grammars/derivation/execute.h"

namespace citykiln::grammars {
namespace {

// The two axes of the scope in the plane of a flat face.
std::array<std::size_t, 2> axes_in_face(const Shape& shape) {
  const double along_y = std::abs(dot(normal_of(shape.faces.front()), shape.scope.axis[1]));
  return along_y > 0.5 ? std::array<std::size_t, 2>{0, 2} : std::array<std::size_t, 2>{0, 1};
}

// True if every edge runs along an axis of the scope.
bool is_rectangle_in_scope(const Shape& shape) {
  const Face& face = shape.faces.front();
  if (face.outer.size() != 4 || !face.holes.empty()) return false;
  const auto [x, y] = axes_in_face(shape);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 edge = face.outer[(i + 1) % 4] - face.outer[i];
    const double along_x = std::abs(dot(edge, shape.scope.axis[x])), along_y = std::abs(dot(edge, shape.scope.axis[y]));
    if (std::min(along_x, along_y) > kOnPlane_m) return false;
  }
  return true;
}

// By less than a fifteenth from a metre on.
double rounded_side_m(double side_m) {
  const double step_m = kElementStep_m * (side_m < 2 ? 1 : side_m < 4 ? 2 : 4);
  return std::floor(side_m / step_m + 0.5) * step_m;
}

bool may_be_element(double side_m) { return side_m >= kElementStep_m && side_m <= kMostElementSide_m; }

// Stretches a shape along an axis of its scope, about the scope's origin.
void stretch(Shape& shape, std::size_t axis, double factor) {
  const Vec3 along = shape.scope.axis[axis], origin = shape.scope.origin;
  for (Face& face : shape.faces)
    each_vertex(face, [&](Vec3& p) { p = p + along * (dot(p - origin, along) * (factor - 1)); });
  shape.scope.size_m[axis] *= factor;
}

Shape with_rounded_sides(const Shape& shape) {
  Shape result = shape;
  for (const std::size_t axis : axes_in_face(shape))
    stretch(result, axis, rounded_side_m(shape.scope.size_m[axis]) / shape.scope.size_m[axis]);
  return result;
}

/// The frame of an element's faces.
struct ElementFrame {
  std::array<Vec3, 3> axis;
  Vec3 corner;
  double width_m = 0, height_m = 0;

  Vec3 local(Vec3 p) const {
    const Vec3 v = p - corner;
    return {dot(axis[0], v), dot(axis[1], v), dot(axis[2], v)};
  }
};

ElementFrame frame_of_element(const Face& face) {
  ElementFrame frame{.axis = axes_of(face), .corner = face.outer.front()};
  Vec3 low, high;
  for (const Vec3 p : face.outer) {
    const Vec3 at = frame.local(p);
    low = {std::min(low.x, at.x), std::min(low.y, at.y), 0}, high = {std::max(high.x, at.x), std::max(high.y, at.y), 0};
  }
  frame.corner = frame.corner + frame.axis[0] * low.x + frame.axis[1] * low.y;
  frame.width_m = rounded_side_m(high.x - low.x), frame.height_m = rounded_side_m(high.y - low.y);
  return frame;
}

Element element_of(const Run& run, const Shape& shape, std::size_t first) {
  const ElementFrame frame = frame_of_element(shape.faces.front());
  Element element{frame.width_m, frame.height_m, {}};
  for (std::size_t i = first; i < run.out.terminals.size(); ++i)
    for (const Face& face : run.out.terminals[i].faces) {
      ElementFace& local = element.faces.emplace_back(ElementFace{face, run.out.terminals[i].appearance});
      each_vertex(local.face, [&](Vec3& p) { p = frame.local(p); });
    }
  return element;
}

}  // namespace

std::optional<ElementPlace> element_place(Execution& execution, const Body& body) {
  const Run& run = execution.run;
  const Shape& shape = execution.shape;
  const bool is_kept_start = run.options.keep_start && execution.depth <= 1;
  if (!run.options.draw_elements || !run.measures() || is_kept_start) return std::nullopt;
  if (!body.divides || !body.changes_appearance || body.keeps_surface) return std::nullopt;
  if (!is_flat(shape) || !is_rectangle_in_scope(shape)) return std::nullopt;
  const auto [x, y] = axes_in_face(shape);
  if (!may_be_element(shape.scope.size_m[x]) || !may_be_element(shape.scope.size_m[y])) return std::nullopt;
  const DisplacementBound bound = displacement_bound(execution, ranges_of(execution), body);
  if (!bound.survives || bound.moved.largest_m() + shape.deviation_m > run.options.tolerance_m) return std::nullopt;
  return ElementPlace{with_rounded_sides(shape), bound.moved};
}

NodeTrace replace_by_element(Run& run, Shape&& rectangle, const ElementPlace& place, std::size_t first) {
  run.out.elements.push_back(element_of(run, place.shape, first));
  remove_terminals_from(run, first);
  end_as_terminal(run, std::move(rectangle), "element", 0);
  Terminal& terminal = run.out.terminals.back();
  terminal.element = static_cast<std::uint32_t>(run.out.elements.size());
  terminal.simplified = true;
  terminal.error_m += place.moved.largest_m();
  terminal.detail_distance_m = place.moved.to_earlier_m;
  return {place.moved, false, {VisibleAppearances::Count::kMany, 0}};
}

}  // namespace citykiln::grammars
