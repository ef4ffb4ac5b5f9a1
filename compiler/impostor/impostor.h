// Impostors: orthographic pictures of a model, baked as textures for flat faces (facades, tree cards) that replace it.
//
//      model           face            1. triangles within the view's depth that face the viewer are projected onto the
//     _                  |                face's plane
//    |_  <- a sill       |  <- view    2. each sample shows the nearest surface
//     _|                 |             3. a texel is the mean of its samples
//    |_                  |             4. its slope is the rise of the model between the texel's borders
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/impostor/picture.h"
#include "compiler/materials/material_mesh.h"

namespace citykiln::impostor {

struct Box3 {
  Vec3 low, high;
};

/// A triangle with its bounding box and an index into Model::surfaces.
struct ModelTriangle {
  Vec3 a, b, c;
  Vec3 normal;  ///< Length 1, or 0 without area.
  Box3 box;
  std::uint32_t surface = 0;
};

/// The number of triangles in a block, which is culled by one box: consecutive triangles of a mesh are close to each
/// other.
inline constexpr std::size_t kTrianglesPerBlock = 32;

/// Returns a surface as a texel that is wholly covered.
Texel texel_of(const materials::SurfaceMaterial& surface);

/// A model prepared for rendering.
struct Model {
  std::vector<ModelTriangle> triangles;
  std::vector<Box3> blocks;  ///< The box of each kTrianglesPerBlock consecutive triangles; the last may have fewer.
  std::vector<materials::SurfaceMaterial> surfaces;  ///< Sorted, unique.
};

/// Returns the model of some meshes. Ignores textures and normals; a mesh with tints per vertex gets its first tint.
/// O(n log n).
Model model_of(std::span<const materials::MaterialMesh> meshes);

/// An orthographic view: a rectangle in space, in metres, seen from the side to which cross(v, u) points.
struct View {
  Vec3 corner;  ///< The corner at u = v = 0.
  Vec3 u, v;    ///< Orthonormal directions along rows of texels and down columns.
  double texel_m = 1;
  std::uint32_t columns = 1, rows = 1;
  double before_m = 0, behind_m = 0;  ///< The depth range in front of the rectangle and behind it.
  bool has_slopes = false;            ///< Texels get slopes.
};

/// Light sources are visible past occluders at least kMinOccluderGap_m in front of the source, such as balconies,
/// but not past nearer ones, such as window frames. Sources more than kMaxRoomDepth_m behind the rectangle belong to
/// rooms behind other walls.
inline constexpr double kMinOccluderGap_m = 0.375, kMaxRoomDepth_m = 0.5;

struct Impostor {
  Picture picture;
  /// The material of most covered samples, the first among equals; default if no sample is covered.
  materials::SurfaceMaterial dominant{};
  double dominant_share = 0;  ///< The share of the covered samples that show `dominant`.
};

/// Renders a model. texel_m, columns and rows > 0.
///
/// Method: a z-buffer of 4 × 4 samples per texel (Catmull 1974), whose rows are shifted against each other, with
/// integer edge functions (Pineda, "A Parallel Algorithm for Polygon Rasterization", SIGGRAPH 1988) on a grid of a 64th
/// of a texel. Guarantees: deterministic on every CPU and for every order of triangles; among surfaces of one depth, to
/// 2^-10 m, the lowest index is visible. Triangles with a common edge cover each sample on it once. Back faces and
/// surfaces outside the depth range are not visible. Triangles with a vertex more than 2^20 texels away, or not finite,
/// are ignored. Emission of surfaces up to kMaxRoomDepth_m behind the rectangle is visible past occluders that are
/// kMinOccluderGap_m or more in front of the surface. Slopes include steps in depth: their mean over covered texels is
/// the rise over all of these. Cost: O(blocks + triangles in view + samples).
Impostor render(const Model& model, const View& view);

}  // namespace citykiln::impostor
