// From a footprint, heights, a roof and a style to a house.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/buildings/facade_textures.h"
#include "compiler/buildings/recipe.h"
#include "compiler/buildings/rulebook.h"
#include "compiler/contract/report.h"
#include "compiler/materials/material_mesh.h"

namespace citykiln::buildings {

struct GeneratedBuilding {
  std::vector<materials::MaterialMesh> meshes;
  double error_m = 0;  ///< Between this and the building at tolerance 0: Hausdorff, both ways, of what can be seen.
  std::vector<TexturedFace> textured_faces{};  ///< With Detail::kFacadeTextures: the faces that show pictures.
};

/// What is the same for all houses of a scene.
struct SceneContext {
  std::uint64_t seed = 0;
  bool is_night = false;  ///< Then rules light some windows.
};

/// The mass (mass.h), worked on by the style's rules as far as the tolerance sees; where it sees nothing of them, or
/// there are none, the bare mass. A building lower than the tolerance, chimneys and all, is dropped, with its height as
/// error.
///
/// Tints, and all chance of the rules, are drawn from (seed, id), by night the same as by day. Roofs that fell back to
/// flat, and rules that asked for what cannot be, are diagnosed. Cost: the derivation's.
GeneratedBuilding generate(const Building& building, const Rulebook& rulebook, SceneContext setting, double tolerance_m,
                           Report& report);

/// The same at several tolerances, in their order: what pictures are made of is derived once. One report a tolerance.
std::vector<GeneratedBuilding> generate(const Building& building, const Rulebook& rulebook, SceneContext setting,
                                        std::span<const double> tolerances_m, std::span<Report> reports);

}  // namespace citykiln::buildings
