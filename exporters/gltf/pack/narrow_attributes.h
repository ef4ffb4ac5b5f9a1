// KHR_mesh_quantization: converts attributes to 8 and 16 bits, and back to single precision.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "exporters/gltf/glb_parts.h"
#include "exporters/gltf/vertex_attributes.h"

namespace citykiln::exporters {

inline constexpr const char* kQuantizationExtension = "KHR_mesh_quantization";

/// An attribute in 16 bits: values are offset_m plus whole multiples of 2^exponent m.
struct NarrowSteps {
  int exponent = 0;
  bool is_signed = true;
  /// Whole metres. It becomes the translation of the mesh's node, and is 0 if that has one already.
  std::array<double, 3> offset_m{};
  bool operator==(const NarrowSteps&) const = default;
};

/// The steps of a file's attributes. All positions of a mesh have the same steps, and so have all uvs of a material.
struct NarrowPlan {
  std::vector<std::optional<NarrowSteps>> positions;  ///< By mesh; std::nullopt: single precision.
  std::vector<std::optional<NarrowSteps>> uvs;        ///< By material, in the same way.
};

/// Chooses the largest steps at which every position and uv stays exact, if 16 bits hold their range.
/// @param plain  A .glb written by encode_glb().
NarrowPlan plan_narrowing(const GlbParts& plain);

/// Converts the positions and uvs of a primitive to the planned steps.
/// @param mesh, material  The primitive's numbers of these.
void narrow_steps(const NarrowPlan& plan, std::size_t mesh, std::size_t material, MeshArrays& arrays);

/// Converts normals and tangents to 8 bits.
void narrow_directions(MeshArrays& arrays);

/// Writes the plan into a file. Moves a mesh whose node has children into a new last child. Scales nodes, instances and
/// textures by the steps. Accessors get their limits in steps, and step_m and offset_m as extras.
void scale_by_plan(const NarrowPlan& plan, GlbParts& parts);

/// Sets an accessor's component type and whether it is normalised.
void set_component(Component component, nlohmann::json& accessor);

/// Converts an attribute back to single precision; normals and tangents get unit length. Throws std::runtime_error if
/// the accessor lacks its step.
VertexAttribute widened(VertexAttribute attribute, const nlohmann::json& accessor);

/// Restores nodes and instances: the inverse of scale_by_plan(). Call it while accessors still have their extras.
/// Throws std::exception for files that citykiln does not write.
void unscale(GlbParts& parts);

}  // namespace citykiln::exporters
