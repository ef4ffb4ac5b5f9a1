// From a string to a skeleton: the turtle walks along it once.
#pragma once

#include "lsystems/environment.h"
#include "lsystems/skeleton.h"

namespace citykiln::lsystems {

/// Walks an interpreted string (interpret()) from the origin, upwards; turtle_symbols.inc says what modules do. What
/// the turtle does not know it passes over. With `height` in the file, the whole is scaled about the origin.
///
/// Tropism: after each segment the turtle turns towards the tropism T by e |heading × T| radians (the book,
/// section 2.1). Guarantees: the same bytes on every machine; directions are orthonormal within 1e-9; everything is
/// finite. Total: polygons that nothing closes, } and . outside of one, polygons of fewer than three corners, numbers
/// beyond kWalkLimit, and branches deeper than kBranchLimit are left out, and troubles. O(n), n = modules.
Skeleton walk(const LSystem& system, const ModuleString& interpreted);

/// Everything at once: derive, interpret, walk.
struct Plant {
  Derivation derivation;
  Skeleton skeleton;
};
Plant grow(const LSystem& system, const DeriveOptions& options = {});

/// What the environment says to the ?-modules of a string, in turn: three numbers for ?P, one for ?H and ?S.
std::vector<double> answers_to(const LSystem& system, const ModuleString& interpreted, const Environment& environment);

inline constexpr double kWalkLimit = 1e9;            ///< Of one length, angle or width.
inline constexpr std::size_t kBranchLimit = 10'000;  ///< Brackets, and polygons, in each other.

}  // namespace citykiln::lsystems
