// Generates the meshes of barriers and of street lamps, and places lamps on the ground.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/placement.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/props/recipe.h"
#include "compiler/props/street_lamps.h"

namespace citykiln::props {

/// The meshes of a prop.
struct GeneratedProp {
  std::vector<materials::MaterialMesh> meshes;  ///< One per material; empty if the prop is left out.
  double error_m = 0;                           ///< Upper bound of their distance from the prop in full detail.
};

/// Generates a barrier on the ground, in plane metres. A railing has posts and rails (railing_mesh.h). All others are a
/// rectangle swept along the axis, without an underside, from 0.5 m below the ground up.
///
/// - The axis is draped over the ground within a quarter of the tolerance, at most 0.125 m, which is part of the error.
///   Retaining walls follow the ground exactly: they stand on its lower side and are at least as high as its higher
///   one.
/// - A wall (BarrierKind::kWall) over 0.16 m has a coping that stands over by 0.06 m on each side. It is left out where
///   the tolerance allows that, and 0.06 m is then part of the error.
/// - A barrier that is not higher than the tolerance has no mesh, and its height is the error.
///
/// Guarantees: error_m <= tolerance_m; vertices are snapped. Cannot fail; an axis of one place has no mesh.
/// O(points of the draped axis).
/// @param ground       Must cover the axis.
/// @param tolerance_m  Largest deviation, > 0.
GeneratedProp generate(const Barrier& barrier, const ground::GradedTerrain& ground, double tolerance_m);

/// Generates the mesh that lamps of one kind share: 1 m high, to be scaled by the lamp's height. Its foot is at the
/// origin, z is up, and its arm is 0.21 m long along +x. Every part is closed; at most 80 triangles. A lamp that is not
/// higher than the tolerance has no mesh, and its height is the error.
///
/// Guarantee: error_m, which is that of the scaled lamp, is at most tolerance_m. O(1).
/// @param height_m     The height by which the mesh will be scaled, > 0.
/// @param tolerance_m  Largest deviation of the scaled lamp, > 0.
/// @param is_lit       True by night: its glass shines.
GeneratedProp lamp_mesh(LampKind kind, double height_m, double tolerance_m, bool is_lit);

/// Returns the placement of a lamp's mesh: its foot on the ground, +x in the direction that the lamp faces, scaled by
/// lamp.height_m.
/// @param ground  Must cover lamp.at.
Placement place(const StreetLamp& lamp, const ground::GradedTerrain& ground);

}  // namespace citykiln::props
