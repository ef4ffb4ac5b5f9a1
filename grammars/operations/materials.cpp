// Materials and texture coordinates: set, color, texture, setupProjection, projectUV, tileUV.
#include <algorithm>
#include <charconv>

#include "grammars/operations/operations.h"

namespace citykiln::grammars {
namespace {

bool set_material_value(Appearance& appearance, const std::string& name, const Value& value) {
#define MATERIAL_TEXT(key, member) \
  if (name == key) return appearance.member = text_of(value), true;
#define MATERIAL_NUMBER(key, member) \
  if (name == key) return appearance.member = std::clamp(number_of(value), 0.0, 1000.0), true;
#include "grammars/language/material_values.inc"
#undef MATERIAL_TEXT
#undef MATERIAL_NUMBER
  return false;
}

// Reads "#rrggbb" or "#rrggbbaa" as numbers from 0 to 1; false for another text.
bool read_colour(const std::string& text, std::array<double, 4>& colour) {
  if ((text.size() != 7 && text.size() != 9) || text[0] != '#') return false;
  for (std::size_t i = 0; 2 * i + 2 < text.size(); ++i) {
    unsigned byte = 0;
    const char* const first = text.data() + 2 * i + 1;
    if (std::from_chars(first, first + 2, byte, 16).ptr != first + 2) return false;
    colour[i] = byte / 255.0;
  }
  return true;
}

double share(double v) { return std::clamp(v, 0.0, 1.0); }

/// The directions of a plane given by name, like "scope.xy".
struct Directions {
  Vec3 u, v;
};

Directions directions_of(const Scope& scope, std::string_view plane) {
  const auto axis = [&](char letter) {
    const Scope world;
    const Scope& frame = plane.starts_with("world") ? world : scope;
    return frame.axis[static_cast<std::size_t>(letter - 'x')];
  };
  return {axis(plane[plane.size() - 2]), axis(plane[plane.size() - 1])};
}

double texture_size_m(const Argument& argument, double size_m) {
  return std::max(size_or_share(argument, size_m), kSmallest_m);
}

double size_along(const Scope& scope, Vec3 direction) {
  const NearestAxis nearest = nearest_axis(scope, direction);
  return scope.size_m[static_cast<std::size_t>(nearest.axis)];
}

}  // namespace

void op_set(Execution& execution, const Statement&, Arguments arguments) {
  const Expression& name = *arguments[0].word;
  Tables& tables = execution.run.tables;
  Shape& shape = execution.shape;
  if (name.index == ~0u) {
    Appearance appearance = tables.appearances[shape.appearance];
    set_material_value(appearance, name.text, arguments[1].value);
    shape.appearance = tables.index_of(appearance);
    return;
  }
  AttributeSet changed = tables.attribute_sets[shape.attributes];
  changed[name.index] = arguments[1].value;
  shape.attributes = tables.index_of(changed);
}

void op_color(Execution& execution, const Statement& statement, Arguments arguments) {
  Tables& tables = execution.run.tables;
  Appearance appearance = tables.appearances[execution.shape.appearance];
  std::array<double, 4> colour = {0, 0, 0, appearance.opacity};
  for (std::size_t i = 0; i < arguments.size() && arguments.size() > 1; ++i)
    colour[i] = share(number_of(arguments[i].value));
  if (arguments.size() == 1 && !read_colour(text_of(arguments[0].value), colour))
    return execution.run.warn(statement.position, "expected a colour as \"#rrggbb\"");
  appearance.red = colour[0], appearance.green = colour[1], appearance.blue = colour[2], appearance.opacity = colour[3];
  execution.shape.appearance = tables.index_of(appearance);
}

void op_texture(Execution& execution, const Statement&, Arguments arguments) {
  Appearance appearance = execution.run.tables.appearances[execution.shape.appearance];
  appearance.colour_map = text_of(arguments[0].value);
  execution.shape.appearance = execution.run.tables.index_of(appearance);
}

void op_setup_projection(Execution& execution, const Statement& statement, Arguments arguments) {
  if (number_of(arguments[0].value) != 0) return execution.run.warn(statement.position, "only uv set 0 is implemented");
  const Scope& scope = execution.shape.scope;
  const Directions axes = directions_of(scope, word_of(arguments[1]));
  const double width_m = texture_size_m(arguments[2], size_along(scope, axes.u));
  const double height_m = texture_size_m(arguments[3], size_along(scope, axes.v));
  const Vec3 from = axes.u * number_or(arguments, 4, 0) + axes.v * number_or(arguments, 5, 0);
  const bool of_world = word_of(arguments[1]).starts_with("world");
  if (of_world) execution.run.depends_on(0);
  const Vec3 origin = of_world ? Vec3{} : scope.origin;
  execution.shape.projection =
      execution.run.tables.add(TextureProjection{origin + from, axes.u * (1 / width_m), axes.v * (1 / height_m)});
}

void op_project_uv(Execution& execution, const Statement& statement, Arguments) {
  if (execution.shape.projection == 0)
    return execution.run.warn(statement.position, "projectUV without a setupProjection before it");
  execution.shape.texture = execution.shape.projection;
}

void op_tile_uv(Execution& execution, const Statement&, Arguments arguments) {
  const Scope& scope = execution.shape.scope;
  const double width_m = texture_size_m(arguments[1], scope.size_m[0]),
               height_m = texture_size_m(arguments[2], scope.size_m[1]);
  execution.shape.texture = execution.run.tables.add(
      TextureProjection{scope.origin, scope.axis[0] * (1 / width_m), scope.axis[1] * (1 / height_m)});
}

}  // namespace citykiln::grammars
