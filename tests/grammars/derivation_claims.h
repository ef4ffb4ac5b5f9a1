// What every derivation keeps, whatever its rules and its footprint.
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

/// Near enough for doubles to measure it.
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

/// Derives whole and at the options' tolerance; says what is not as derive.h has it, or "".
/// @param is_sound  The shape's faces do not cross themselves, so that distances mean something.
template <typename Chance>
std::string broken_claim(const Program& program, const Shape& shape, DeriveOptions options, bool is_sound,
                         Chance chance) {
  const Derivation cut = derive(program, shape, options);
  const double tolerance_m = std::exchange(options.tolerance_m, 0);
  const bool ahead = options.ahead;
  const Derivation whole = derive(program, shape, options);
  if (!is_finite(whole) || !is_finite(cut)) return "a vertex is not finite";
  if (!are_same(whole, derive(program, shape, options))) return "twice is not the same";
  if (!(cut.error_m <= tolerance_m) || whole.error_m != 0) return "the error is over the tolerance";
  if (!ahead && (whole.shapes != cut.shapes || whole.steps != cut.steps || whole.limits.size() != cut.limits.size()))
    return "a tolerance changes what is counted";
  // what a limit has ended, fewer shapes may reach
  if (ahead && !whole.limits.empty()) return "";
  if (cut.terminals.empty() != whole.terminals.empty()) return "all is gone at a tolerance";
  const auto fine = triangles_of(whole), coarse = triangles_of(cut);
  if (!is_sound || fine.empty() || coarse.empty() || fine.size() > 1500 || has_assets(whole)) return "";
  if (!is_near(fine)) return "";
  const double measured_m = std::max(sampled_m(fine, coarse, 40, chance), sampled_m(coarse, fine, 40, chance));
  // what slivers of triangles leave of a double
  if (measured_m > cut.error_m + 1e-4)
    return "off by " + std::to_string(measured_m) + " m, stated " + std::to_string(cut.error_m);
  return "";
}

}  // namespace citykiln::grammars
