// A mesh, what it is made of, and whose it is: what every expand door hands out.
#pragma once

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/mesh.h"
#include "compiler/materials/material.h"

namespace citykiln::materials {

struct DressedMesh {
  Mesh mesh;
  Material material{};
  Tint tint = kNoTint;
  OsmId feature;  ///< The OSM element it stands for; type kNone where there is none.
};

}  // namespace citykiln::materials
