// Generates the mesh of a form of things, and places things on the ground.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/placement.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/things/catalogue.h"
#include "compiler/things/recipe.h"
#include "grammars/derivation/derive.h"

namespace citykiln::things {

/// The meshes of a form and their distance from those of full detail.
struct GeneratedThing {
  std::vector<materials::MaterialMesh> meshes;
  double error_m = 0;
  /// Operations that could not be carried out, and limits that were hit.
  std::vector<grammars::RuleFault> rule_faults{};
};

/// Generates a form by the rule Thing of its kind: its base is around the origin, and it faces -y. The first shape is
/// the box of its size, with x from left to right as seen from in front of it, y to the back and z up. A form that is
/// as low as the tolerance, and whose row keeps it no longer, has no mesh, and its height is the error.
///
/// Guarantees: error_m <= tolerance_m; the same bytes on every CPU. Cost: that of the derivation.
/// @param is_night  The rules' attribute `night`.
GeneratedThing generate(const Form& form, const Kind& kind, std::uint64_t seed, bool is_night, double tolerance_m);

/// The kind of a wire that hangs on a thing.
enum class WireKind : std::uint8_t { kConductor, kEarthWire, kCable, kContactWire, kMessenger, kCount };

/// A place of a form where a wire hangs.
struct WireHold {
  WireKind kind{};
  Vec3 at;  ///< In the frame of the mesh: metres, the middle of the base at the origin, -y in front.
};

/// Returns the places where wires hang on a form: the terminals of its rules that are named WireBelow (the middle of
/// the lower end of their scope), WireAbove, EarthWireAbove and CableAbove. In the order of the rules. Cost: that of
/// the derivation with all detail.
std::vector<WireHold> wire_holds(const Form& form, const Kind& kind, std::uint64_t seed);

/// True if a form has a mesh at a tolerance.
bool is_shown(const Form& form, const map::ThingRow& row, double tolerance_m);

/// Returns the placement of a thing: at its foot, or on the ground, as high as the lowest corner of its base.
Placement place(const Thing& thing, const ground::GradedTerrain& ground);

}  // namespace citykiln::things
