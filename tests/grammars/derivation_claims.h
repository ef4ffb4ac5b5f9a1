// The guarantees of derive.h, tested for any rules and footprint.
#pragma once

#include <cmath>
#include <string>

#include "tests/grammars/surfaces.h"

namespace citykiln::grammars {

inline bool is_finite(const Derivation& derivation) {
  bool all = true;
  for (const Terminal& terminal : derivation.terminals)
    for (const Face& face : terminal.faces)
      each_vertex(face, [&](Vec3 p) { all &= std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); });
  return all;
}

/// True if the surface is near enough to the origin to be measured in double precision.
inline bool is_near(const std::vector<Triangle3>& surface) {
  constexpr double kNear_m = 1000;
  return std::all_of(surface.begin(), surface.end(), [](const Triangle3& t) {
    return length(t.a) < kNear_m && length(t.b) < kNear_m && length(t.c) < kNear_m;
  });
}

inline bool has_assets(const Derivation& derivation) {
  return std::any_of(derivation.terminals.begin(), derivation.terminals.end(),
                     [](const Terminal& terminal) { return !terminal.asset.empty(); });
}

inline bool are_same(const Derivation& a, const Derivation& b) {
  bool same = a.terminals.size() == b.terminals.size() && a.shapes == b.shapes && a.steps == b.steps;
  for (std::size_t i = 0; same && i < a.terminals.size(); ++i)
    same = a.terminals[i].id == b.terminals[i].id && a.terminals[i].faces == b.terminals[i].faces;
  return same;
}

/// Derives at tolerance 0 and at that of the options. Returns the guarantee that does not hold, or "".
/// @param is_sound  True if the faces of the shape do not cross themselves, so that distances can be measured.
template <typename Chance>
std::string broken_claim(const Program& program, const Shape& shape, DeriveOptions options, bool is_sound,
                         Chance chance) {
  const Derivation cut = derive(program, shape, options);
  const double tolerance_m = std::exchange(options.tolerance_m, 0);
  const bool prune_early = options.prune_early;
  const Derivation whole = derive(program, shape, options);
  if (!is_finite(whole) || !is_finite(cut)) return "a vertex is not finite";
  if (!are_same(whole, derive(program, shape, options))) return "twice is not the same";
  if (!(cut.error_m <= tolerance_m) || whole.error_m != 0) return "the error is over the tolerance";
  if (!prune_early &&
      (whole.shapes != cut.shapes || whole.steps != cut.steps || whole.limits.size() != cut.limits.size()))
    return "a tolerance changes what is counted";
  // with fewer shapes a limit may not apply
  if (prune_early && !whole.limits.empty()) return "";
  if (cut.terminals.empty() != whole.terminals.empty()) return "all is gone at a tolerance";
  const auto fine = triangles_of(whole), coarse = triangles_of(cut);
  if (!is_sound || fine.empty() || coarse.empty() || fine.size() > 1500 || has_assets(whole)) return "";
  if (!is_near(fine)) return "";
  const double measured_m = std::max(sampled_m(fine, coarse, 40, chance), sampled_m(coarse, fine, 40, chance));
  // a margin for the rounding of sliver triangles
  if (measured_m > cut.error_m + 1e-4)
    return "off by " + std::to_string(measured_m) + " m, stated " + std::to_string(cut.error_m);
  return "";
}

}  // namespace citykiln::grammars
