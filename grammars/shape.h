// Shapes: what rules are about.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "grammars/scope.h"
#include "grammars/value.h"

namespace citykiln::grammars {

/// A surface's material: names and numbers; what they look like is decided by whoever takes the terminals.
struct Look {
  std::string name;                     ///< material.name, e.g. "brick"; "" where no rule has set it.
  std::string colour_map;               ///< texture("…").
  double red = 1, green = 1, blue = 1;  ///< sRGB, 0 … 1.
  double opacity = 1, roughness = 1, metallic = 0;
  double emissive_red = 0, emissive_green = 0, emissive_blue = 0;
  bool operator==(const Look&) const = default;
};

/// Texture coordinates as a function of the place: u = dot(p - origin, u_per_m), v likewise; 1 is the picture's width.
struct TextureFrame {
  Vec3 origin;
  Vec3 u_per_m, v_per_m;
  bool operator==(const TextureFrame&) const = default;
};

/// A count and this one's place in it: split.index of split.total.
struct Position {
  double index = 0, total = 0;
};

struct Shape {
  StableId id{};
  Scope scope;
  std::vector<Face> faces;
  Scope parent_scope;  ///< For center().
  Look look;
  std::optional<TextureFrame> projection;  ///< Set up; not on the surface yet.
  std::optional<TextureFrame> texture;     ///< On the surface.
  std::string asset;                       ///< i("…"): what stands in the scope instead of faces.
  Position in_split, in_comp;
  /// Attributes that set() has changed, by index into Program::attributes; shared by those who inherit them.
  std::shared_ptr<const std::map<std::uint32_t, Value>> attributes;
};

/// All that a successor inherits, but for the faces: those are its own.
inline Shape heir_of(const Shape& from) {
  return {from.id,    from.scope,    {},           from.parent_scope, from.look, from.projection, from.texture,
          from.asset, from.in_split, from.in_comp, from.attributes};
}

/// Fits the scope to the faces, keeping its axes.
inline void fit_scope(Shape& shape) { shape.scope = scope_around(shape.faces, shape.scope.axis, shape.scope.origin); }

}  // namespace citykiln::grammars
