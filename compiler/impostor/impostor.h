// A shape seen straight on, as a picture: what a flat face shows of the geometry that it stands for.
//
//      the shape       the face          1. all of the shape that lies within a depth of the face, and turns to where
//     _                  |               the face turns, is put into the face's plane
//    |_  <- a sill       |  <- looks     2. of what lies at one place the foremost is seen
//     _|                 |     this way  3. a texel is the mean of its samples
//    |_                  |                 4. its slope is what the shape comes forward between the texel's borders
#pragma once

#include <compare>
#include <span>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/impostor/picture.h"
#include "compiler/materials/material_mesh.h"

namespace citykiln::impostor {

/// What a surface is made of, and its tint.
struct Appearance {
  materials::Material material{};
  materials::Tint tint = materials::kNoTint;
  auto operator<=>(const Appearance&) const = default;
};

struct Box3 {
  Vec3 low, high;
};

/// A triangle of a shape, with the box about it.
struct ModelTriangle {
  Vec3 a, b, c;
  Box3 box;
  std::uint32_t appearance = 0;
};

/// What follows each other in a mesh lies near each other: what a block's box rules out is not looked at.
inline constexpr std::size_t kTrianglesPerBlock = 32;

/// A shape, made ready to be looked at from many sides.
struct Model {
  std::vector<ModelTriangle> facets;
  std::vector<Box3>
      blocks;  ///< About each kTrianglesPerBlock facets that follow each other; of the last, about the rest.
  std::vector<Appearance> appearances;  ///< Rising, each once.
};

/// Tints by vertex, textures and normals are left out: of a mesh with `tints` the first counts. O(n log n).
Model model_of(std::span<const materials::MaterialMesh> meshes);

/// From where a shape is looked at: a rectangle in its frame, metres.
struct View {
  Vec3 corner;  ///< Where u = v = 0.
  Vec3 u, v;    ///< Unit, at right angles: along rows and along columns of texels. It is seen from cross(v, u).
  double texel_m = 1;
  std::uint32_t columns = 1, rows = 1;
  double before_m = 0, behind_m = 0;  ///< How far before the rectangle, and behind it, what is seen may lie.
  bool has_slopes = false;            ///< Else those of texels are 0.
};

/// Frames and bars stand nearer to what shines behind them, and hide it. Farther behind the rectangle than rooms are
/// deep shine other walls' rooms.
inline constexpr double kMinOccluderGap_m = 0.375, kMaxRoomDepth_m = 0.5;

struct Impostor {
  Picture picture;
  Appearance dominant{};      ///< That most samples show; of several the first. Of nothing: Appearance{}.
  double dominant_share = 0;  ///< Of the samples that show something, those that show it.
};

/// The picture of a shape.
///
/// Method: a z-buffer of 4 × 4 samples a texel (Catmull 1974), by edge functions of whole numbers (Pineda, "A Parallel
/// Algorithm for Polygon Rasterization", SIGGRAPH 1988): corners on a grid of a 64th of a texel.
/// Guarantees: the same bytes on every CPU, and for triangles in any order: of what lies equally far to 2^-10 m the
/// least coat is seen. Of two triangles with a common edge, exactly one shows at a sample on it. What is turned away,
/// or lies beyond the depth, is not seen. Triangles with a corner farther than 2^20 texels off are left out, and what
/// is not finite. What shines, and lies no more than kMaxRoomDepth_m behind the rectangle, does so past what stands
/// more than kMinOccluderGap_m before it: a balcony hides its window from straight ahead alone. Slopes are of all that
/// the shape rises between a texel's borders, steps as well as what leans: of texels that are all shown the mean is the
/// slope of all they cover. Cost: O(blocks), a few nanoseconds each that lies elsewhere; O(samples).
Impostor render(const Model& shape, const View& view);

}  // namespace citykiln::impostor
