// Generates the meshes of a building from its recipe and the rules of its style.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/buildings/facade_elements.h"
#include "compiler/buildings/facade_textures.h"
#include "compiler/buildings/lit_windows.h"
#include "compiler/buildings/recipe.h"
#include "compiler/buildings/styles/rulebook.h"
#include "compiler/contract/findings/report.h"
#include "compiler/materials/material_mesh.h"

namespace citykiln::buildings {

/// The meshes of a building at a tolerance: metres in the plane, z above sea level.
struct GeneratedBuilding {
  std::vector<materials::MaterialMesh> meshes;
  double error_m = 0;  ///< Hausdorff distance, both ways, between visible surfaces and the building at tolerance 0.
  /// Walls that a baked texture shows, and elements of facades; they are not in `meshes`. Empty at tolerances without
  /// kFacadeTextures and kFacadeElements (detail_tolerances.inc), and with is_for_blocks.
  std::vector<TexturedFace> textured_faces{};
};

/// The parameters that all buildings of a scene share.
struct SceneContext {
  std::uint64_t seed = 0;
  /// Set while it is dark: the rules' attribute `night` is true, and some windows are lit (lit_windows.h).
  std::optional<WeekTime> night{};
  /// The result is a source of blocks (blocks/certified_blocks.h): low buildings are generated too, and no building has
  /// facade textures.
  bool is_for_blocks = false;
  /// Pictures of elements that were drawn before; null: there are no elements.
  const ElementPictures* pictures = nullptr;
  /// While it is dark, the share of units with lit windows; empty: by use and hour.
  std::optional<double> lit_share{};
};

/// Generates a building at one tolerance.
///
/// The rules of the building's style refine its mass model (mass_model.h) down to the tolerance. Without rules for the
/// style the result is the mass model itself. A building on the ground that is lower than the tolerance, roof
/// structures included, has no mesh, and its height is the error. Tints and random draws of rules depend on the seed
/// and the id, not on `night`. Diagnoses: a flat roof in place of another (kRoofFallback), rule errors (kRuleErrors),
/// rules that place models or lay out textures, since neither is drawn (kRuleWithoutEffect). tolerance_m > 0. Cost:
/// that of the derivation.
GeneratedBuilding generate(const Building& building, const Rulebook& rulebook, SceneContext context, double tolerance_m,
                           Report& report);

/// Generates a building at several tolerances, in their order. The detailed model for facade textures is derived once.
/// There is one report per tolerance.
std::vector<GeneratedBuilding> generate(const Building& building, const Rulebook& rulebook, SceneContext context,
                                        std::span<const double> tolerances_m, std::span<Report> reports);

}  // namespace citykiln::buildings
