// From lines and points to walls, hedges and lamps.
#pragma once

#include <span>
#include <vector>

#include "compiler/geometry/placement.h"
#include "compiler/map/heightfield.h"
#include "compiler/materials/dressed_mesh.h"
#include "compiler/props/recipe.h"

namespace citykiln::props {

struct Expanded {
  std::vector<materials::DressedMesh> meshes;
  double error_m = 0;
};

/// A wall, fence or hedge as a band that follows the ground, split where the field bends. Dropped, with its height as
/// error, where it is lower than the tolerance.
Expanded expand(const Barrier& barrier, const map::Heightfield& heights, double tolerance_m);

/// A lamp 1 m tall with its foot at the origin (scale is the height), empty where a lamp of `height_m` is lower than
/// the tolerance.
Expanded lamp_mesh(double height_m, double tolerance_m);
Placement place(const Lamp& lamp, const map::Heightfield& heights);

}  // namespace citykiln::props
