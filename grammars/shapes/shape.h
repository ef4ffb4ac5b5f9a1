// Shapes: what rules are about.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "grammars/language/value.h"
#include "grammars/shapes/scope.h"

namespace citykiln::grammars {

/// A surface's material: names and numbers; what they look like is decided by whoever takes the terminals.
struct Appearance {
  std::string name;                     ///< material.name, e.g. "brick"; "" where no rule has set it.
  std::string colour_map;               ///< texture("…").
  double red = 1, green = 1, blue = 1;  ///< sRGB, 0 … 1.
  double opacity = 1, roughness = 1, metallic = 0;
  double emissive_red = 0, emissive_green = 0, emissive_blue = 0;
  auto operator<=>(const Appearance&) const = default;
};

/// Texture coordinates as a function of the place: u = dot(p - origin, u_per_m), v likewise; 1 is the picture's width.
struct TextureProjection {
  Vec3 origin;
  Vec3 u_per_m, v_per_m;
  bool operator==(const TextureProjection&) const = default;
};

/// A count and this one's place in it: split.index of split.total.
struct Position {
  double index = 0, total = 0;
  /// The shape (Shape::birth) that was given it; its successors inherit it. Until that shape is born, ~0.
  std::uint32_t since = ~0u;
};

/// Attributes that set() has changed, by index into Program::attributes.
using AttributeSet = std::map<std::uint32_t, Value>;

struct Shape {
  StableId id{};  ///< Of what a derivation begins with; of others Run::id_of() tells.
  Scope scope;
  std::vector<Face> faces;
  Scope parent_scope;  ///< For center().
  std::string asset;   ///< i("…"): what stands in the scope instead of faces.
  Position in_split, in_comp;
  // into the tables of the derivation, whose first entries are what a lot has: 0
  std::uint32_t look = 0;
  std::uint32_t projection = 0;  ///< A texture frame set up; not on the surface yet.
  std::uint32_t texture = 0;     ///< A texture frame on the surface.
  std::uint32_t attributes = 0;  ///< An AttributeSet.
  std::uint32_t birth = 0;       ///< Which shape of the derivation this is.
};

/// All that a successor inherits, but for the faces: those are its own.
inline Shape inherited_from(const Shape& from) {
  return {from.id,   from.scope,      {},           from.parent_scope, from.asset, from.in_split, from.in_comp,
          from.look, from.projection, from.texture, from.attributes,   from.birth};
}

/// Fits the scope to the faces, keeping its axes.
inline void fit_scope(Shape& shape) { shape.scope = scope_around(shape.faces, shape.scope.axis, shape.scope.origin); }

}  // namespace citykiln::grammars
