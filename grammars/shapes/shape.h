// Shapes, to which the rules of a CGA grammar are applied: faces in a scope (an oriented box), with an appearance and
// inherited values. A node is one application of a rule to a shape.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "grammars/language/value.h"
#include "grammars/shapes/scope.h"

namespace citykiln::grammars {

/// The material of a surface as set by rules. The caller of derive() decides how a name is rendered.
struct Appearance {
  std::string name;                     ///< material.name, e.g. "brick"; "" if no rule has set it.
  std::string colour_map;               ///< texture("…").
  double red = 1, green = 1, blue = 1;  ///< sRGB, 0 … 1.
  double opacity = 1, roughness = 1, metallic = 0;
  double emissive_red = 0, emissive_green = 0, emissive_blue = 0;
  auto operator<=>(const Appearance&) const = default;
};

/// Texture coordinates as an affine function of position p: u = dot(p - origin, u_per_m), v = dot(p - origin, v_per_m).
/// The texture covers 0 to 1.
struct TextureProjection {
  Vec3 origin;
  Vec3 u_per_m, v_per_m;
  bool operator==(const TextureProjection&) const = default;
};

/// The index of a shape among the `total` parts of a split or comp. Shapes made from this shape inherit the index.
struct SiblingIndex {
  double index = 0, total = 0;
  /// The node to which the index was assigned (Shape::node); ~0 until that node exists.
  std::uint32_t since_node = ~0u;
};

/// The values of attributes changed by set(), by index into Program::attributes.
using AttributeSet = std::map<std::uint32_t, Value>;

/// The current state of a node: its surface, scope and attributes.
struct Shape {
  StableId id{};  ///< Set for the first shape of a derivation; Run::id_of() computes the others.
  Scope scope;
  std::vector<Face> faces;
  Scope parent_scope;  ///< The scope of the parent, for center().
  std::string asset;   ///< The instance of i("…") that fills the scope instead of faces; "" for none.
  /// The Hausdorff distance of the faces from the exact body, for the faces of a round body or a part of one; else 0.
  double deviation_m = 0;
  bool leaves_out_details = false;  ///< Successors that are near to others may be left out (leave_out_details.h).
  SiblingIndex in_split, in_comp;
  // indices into Tables; 0 is the default
  std::uint32_t appearance = 0;
  std::uint32_t projection = 0;  ///< A texture projection that is set up but not applied yet.
  std::uint32_t texture = 0;     ///< The texture projection applied to the surface.
  std::uint32_t attributes = 0;  ///< The changed attributes (AttributeSet).
  std::uint32_t node = 0;        ///< Index into Run::nodes.
};

/// Returns a copy without faces, for a shape that is made from this one.
inline Shape inherited_from(const Shape& from) {
  return {.id = from.id,
          .scope = from.scope,
          .faces = {},
          .parent_scope = from.parent_scope,
          .asset = from.asset,
          .deviation_m = from.deviation_m,
          .leaves_out_details = from.leaves_out_details,
          .in_split = from.in_split,
          .in_comp = from.in_comp,
          .appearance = from.appearance,
          .projection = from.projection,
          .texture = from.texture,
          .attributes = from.attributes,
          .node = from.node};
}

/// Fits the scope to the faces, keeping its axes.
inline void fit_scope(Shape& shape) { shape.scope = scope_around(shape.faces, shape.scope.axis, shape.scope.origin); }

}  // namespace citykiln::grammars
