#include "compiler/bake/pole_wires.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/snap.h"
#include "compiler/wires/sag.h"
#include "compiler/wires/supports.h"

namespace citykiln::bake {
namespace {

constexpr std::uint8_t kPoleWire_mm = 8, kTelephoneCable_mm = 20;
// The height of telephone cables above the foot of a pole, and their sag compared with that of wires.
constexpr double kTelephone_m = 6.25, kTelephoneSag = 1.5;

double on_wire_grid(double value_m) { return snapped_to(wires::kWireQuantum_m, value_m); }

Vec3 on_wire_grid(Vec3 p) { return {on_wire_grid(p.x), on_wire_grid(p.y), on_wire_grid(p.z)}; }

void add_telephone_cable(const PlacedPoleSpan& span, double sag_m, std::vector<wires::Wire>& wires) {
  const Vec3 up{0, 0, kTelephone_m};
  wires.push_back({.from = on_wire_grid(span.from.at + up),
                   .to = on_wire_grid(span.to.at + up),
                   .sag_m = on_wire_grid(sag_m * kTelephoneSag),
                   .radius_mm = kTelephoneCable_mm,
                   .kind = wires::WireKind::kConductor});
}

wires::WireSpan wires_between(const PlacedPoleSpan& span, const std::vector<things::WireHold>& holds) {
  const wires::Support from = wires::support_at(span.from, holds), to = wires::support_at(span.to, holds);
  const Vec2 along = unit(to.at - from.at);
  const double length_m = distance(from.at, to.at);
  const double sag_m = on_wire_grid(length_m * length_m / (8 * wires::kMinorLineSag.parameter_m));
  const std::vector<Vec3> a = ordered_holds(from, wires::WireKind::kConductor, along),
                          b = ordered_holds(to, wires::WireKind::kConductor, along);
  wires::WireSpan made{
      .id = span.id, .above_m = std::ceil(span.form.height_m + std::abs(span.to.at.z - span.from.at.z)), .wires = {}};
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    made.wires.push_back({.from = on_wire_grid(a[i]),
                          .to = on_wire_grid(b[i]),
                          .sag_m = sag_m,
                          .radius_mm = kPoleWire_mm,
                          .kind = wires::WireKind::kConductor});
  add_telephone_cable(span, sag_m, made.wires);
  return made;
}

}  // namespace

std::vector<wires::WireSpan> wires_of(std::span<const PlacedPoleSpan> spans, const PrototypeCache& prototypes) {
  std::vector<wires::WireSpan> made;
  std::vector<things::WireHold> holds;
  const things::Form* form = nullptr;
  for (const PlacedPoleSpan& span : spans) {
    if (!form || *form != span.form) holds = prototypes.wire_holds(span.form), form = &span.form;
    made.push_back(wires_between(span, holds));
  }
  return made;
}

}  // namespace citykiln::bake
