// KHR_mesh_quantization: attributes in 8 and 16 bits, and back to single precision.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "exporters/gltf/glb_parts.h"
#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {

inline constexpr const char* kQuantizationExtension = "KHR_mesh_quantization";

/// Steps of an attribute in 16 bits, from an offset on.
struct NarrowSteps {
  int exponent = 0;
  bool is_signed = true;
  std::array<double, 3> offset_m{};  ///< Whole metres. Not 0 only for meshes of nodes that are not moved.
  bool operator==(const NarrowSteps&) const = default;
};

/// How the primitives of a file are narrowed: all positions of a mesh, and all uvs of a material, in the same way.
struct NarrowPlan {
  std::vector<std::optional<NarrowSteps>> positions;  ///< By mesh; none where they stay in single precision.
  std::vector<std::optional<NarrowSteps>> uvs;        ///< By material.
};

/// Plans the largest step at which every position and uv stays exact, where 16 bits hold it.
/// @param plain  As encode_glb writes it.
NarrowPlan plan_narrowing(const GlbParts& plain);

/// Positions and uvs of a primitive as planned.
/// @param mesh, material  Numbers of the primitive's.
void narrow_steps(const NarrowPlan& plan, std::size_t mesh, std::size_t material, MeshArrays& arrays);

/// Normals and tangents in 8 bits.
void narrow_directions(MeshArrays& arrays);

/// Writes the plan into a file: meshes of nodes with children get nodes of their own, the last children; scales of
/// nodes, of instances and of textures; the accessors get their limits in steps, and step_m as extras.
void scale_by_plan(const NarrowPlan& plan, GlbParts& parts);

/// Sets an accessor's component type and whether it is normalised.
void set_component(Component component, nlohmann::json& accessor);

/// An attribute in single precision: the inverse, for normals and tangents of unit length. Throws std::runtime_error
/// where the accessor lacks its step.
VertexAttribute widened(VertexAttribute attribute, const nlohmann::json& accessor);

/// The inverse for nodes and instances, before the accessors forget them. Throws
/// std::exception for files that citykiln does not write.
void unscale(GlbParts& parts);

}  // namespace citykiln::exporters
