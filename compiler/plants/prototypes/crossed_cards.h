// Crossed cards: vertical planes through a plant's trunk and horizontal ones through its crown, each with an
// orthographic picture of the parts near it.
//
//       \ | /          from above: n planes; every point is within R sin(90°/n) of one
//     ---\|/---
//       / | \.
#pragma once

#include <vector>

#include "compiler/impostor/cutout.h"
#include "compiler/materials/material_mesh.h"

namespace citykiln::plants {

struct CrossedCards {
  materials::MaterialMesh mesh;  ///< Textured by the cutout.
  impostor::Cutout cutout;
  double error_m = 0;
};

/// @param shape  The plant; leaves as polygons of their true area, on both sides.
/// @param tolerance_m  > 0.
///
/// A picture shows the shape within three quarters of the tolerance on both sides of its plane, or as far as
/// kMostPlanes planes need to show all of it. Error: stated, not proved, since a single leaf may be lost. A point of
/// the shape is within R sin(90°/n) of a vertical plane; a point of a picture is within its depth of the shape; a
/// texel, a quarter of the tolerance, is added.
CrossedCards crossed_cards(const std::vector<materials::MaterialMesh>& shape, double tolerance_m);

inline constexpr int kMostPlanes = 8, kMostLevels = 3;

}  // namespace citykiln::plants
