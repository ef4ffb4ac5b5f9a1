// Materials and texture coordinates: set, color, texture, setupProjection, projectUV, tileUV.
#include <algorithm>

#include "grammars/operations/operations.h"

namespace citykiln::grammars {
namespace {

bool set_look(Appearance& look, const std::string& name, const Value& value) {
#define MATERIAL_TEXT(key, member) \
  if (name == key) return look.member = text_of(value), true;
#define MATERIAL_NUMBER(key, member) \
  if (name == key) return look.member = std::clamp(number_of(value), 0.0, 1000.0), true;
#include "grammars/language/material_values.inc"
#undef MATERIAL_TEXT
#undef MATERIAL_NUMBER
  return false;
}

int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// "#rrggbb" or "#rrggbbaa": 0 … 1 each; false if it is neither
bool read_colour(const std::string& text, std::array<double, 4>& colour) {
  if ((text.size() != 7 && text.size() != 9) || text[0] != '#') return false;
  for (std::size_t i = 0; 2 * i + 2 < text.size(); ++i) {
    const int high = digit_of(text[2 * i + 1]), low = digit_of(text[2 * i + 2]);
    if (high < 0 || low < 0) return false;
    colour[i] = (high * 16 + low) / 255.0;
  }
  return true;
}

double share(double v) { return std::clamp(v, 0.0, 1.0); }

/// Two directions of a plane, by name: "scope.xy".
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

// a width that is shared of the scope's counts as that
double width_of(const Argument& argument, double size_m) {
  const double width_m = argument.relative ? metres(argument) * size_m : metres(argument);
  return std::max(width_m, kSmallest_m);
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
    Appearance look = tables.looks[shape.look];
    set_look(look, name.text, arguments[1].value);
    shape.look = tables.index_of(look);
    return;
  }
  AttributeSet changed = tables.attribute_sets[shape.attributes];
  changed[name.index] = arguments[1].value;
  shape.attributes = tables.index_of(changed);
}

void op_color(Execution& execution, const Statement& statement, Arguments arguments) {
  Tables& tables = execution.run.tables;
  Appearance look = tables.looks[execution.shape.look];
  std::array<double, 4> colour = {0, 0, 0, look.opacity};
  for (std::size_t i = 0; i < arguments.size() && arguments.size() > 1; ++i)
    colour[i] = share(number_of(arguments[i].value));
  if (arguments.size() == 1 && !read_colour(text_of(arguments[0].value), colour))
    return execution.run.warning(statement.place, "expected a colour as \"#rrggbb\"");
  look.red = colour[0], look.green = colour[1], look.blue = colour[2], look.opacity = colour[3];
  execution.shape.look = tables.index_of(look);
}

void op_texture(Execution& execution, const Statement&, Arguments arguments) {
  Appearance look = execution.run.tables.looks[execution.shape.look];
  look.colour_map = text_of(arguments[0].value);
  execution.shape.look = execution.run.tables.index_of(look);
}

void op_setup_projection(Execution& execution, const Statement& statement, Arguments arguments) {
  if (number_of(arguments[0].value) != 0)
    return execution.run.warning(statement.place, "uv set 0 is the only one that is built");
  const Scope& scope = execution.shape.scope;
  const Directions axes = directions_of(scope, word_of(arguments[1]));
  const double width_m = width_of(arguments[2], size_along(scope, axes.u));
  const double height_m = width_of(arguments[3], size_along(scope, axes.v));
  const Vec3 from = axes.u * number_or(arguments, 4, 0) + axes.v * number_or(arguments, 5, 0);
  const bool of_world = word_of(arguments[1]).starts_with("world");
  if (of_world) execution.run.depends_on(0);
  const Vec3 origin = of_world ? Vec3{} : scope.origin;
  execution.shape.projection =
      execution.run.tables.add(TextureProjection{origin + from, axes.u * (1 / width_m), axes.v * (1 / height_m)});
}

void op_project_uv(Execution& execution, const Statement& statement, Arguments) {
  if (execution.shape.projection == 0)
    return execution.run.warning(statement.place, "projectUV without a setupProjection before it");
  execution.shape.texture = execution.shape.projection;
}

void op_tile_uv(Execution& execution, const Statement&, Arguments arguments) {
  const Scope& scope = execution.shape.scope;
  const double width_m = width_of(arguments[1], scope.size_m[0]), height_m = width_of(arguments[2], scope.size_m[1]);
  execution.shape.texture = execution.run.tables.add(
      TextureProjection{scope.origin, scope.axis[0] * (1 / width_m), scope.axis[1] * (1 / height_m)});
}

}  // namespace citykiln::grammars
