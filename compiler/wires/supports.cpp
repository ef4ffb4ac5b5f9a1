#include "compiler/wires/supports.h"

#include <algorithm>
#include <tuple>

namespace citykiln::wires {
namespace {

// Attachments this near to the axis of the line are in its middle.
constexpr double kMiddle_m = 0.25;

double left_m_of(Vec3 hold, Vec2 at, Vec2 along) { return cross(along, in_plan(hold) - at); }

// 0 on the left, 1 in the middle, 2 on the right.
int side_of(Vec3 hold, Vec2 at, Vec2 along) {
  const double left_m = left_m_of(hold, at, along);
  return left_m > kMiddle_m ? 0 : left_m < -kMiddle_m ? 2 : 1;
}

Vec3 in_plane(Vec3 local, const Placement& placement) {
  const Vec2 right{placement.cos_yaw, placement.sin_yaw}, at = in_plan(placement.at);
  return at_height(at + right * local.x + left_of(right) * local.y, placement.at.z + local.z);
}

}  // namespace

Support support_at(const Placement& placement, std::vector<things::WireHold> holds) {
  for (things::WireHold& hold : holds) hold.at = in_plane(hold.at, placement);
  return {in_plan(placement.at), std::move(holds)};
}

void add_supports(Supports& supports, std::span<const things::Thing> things, const things::Kinds& kinds,
                  std::uint64_t seed, const ground::GradedTerrain& ground) {
  std::map<things::Form, std::vector<things::WireHold>> holds_of;
  for (const things::Thing& thing : things) {
    const auto kind = kinds.find(thing.form.kind);
    if (kind == kinds.end() || thing.id.osm.type != OsmType::kNode) continue;
    const auto [entry, is_new] = holds_of.try_emplace(thing.form);
    if (is_new) entry->second = things::wire_holds(thing.form, kind->second, seed);
    if (entry->second.empty()) continue;
    supports.emplace(thing.id.osm.id, support_at(things::place(thing, ground), entry->second));
  }
}

std::vector<Vec3> ordered_holds(const Support& support, things::WireKind kind, Vec2 along) {
  std::vector<Vec3> holds;
  for (const things::WireHold& hold : support.holds)
    if (hold.kind == kind) holds.push_back(hold.at);
  std::ranges::sort(holds, {}, [&](Vec3 hold) {
    return std::tuple(side_of(hold, support.at, along), -hold.z, -left_m_of(hold, support.at, along));
  });
  return holds;
}

std::vector<Vec3> chosen_holds(std::vector<Vec3> holds, std::size_t count, Vec2 at, Vec2 along) {
  if (count >= holds.size()) return holds;
  const auto is_right = [&](Vec3 hold) { return side_of(hold, at, along) == 2; };
  if (static_cast<std::size_t>(std::ranges::count_if(holds, is_right)) >= count) {
    std::erase_if(holds, [&](Vec3 hold) { return !is_right(hold); });
    holds.resize(count);
    return holds;
  }
  while (holds.size() > count) {
    const auto nearest =
        std::ranges::min_element(holds, {}, [&](Vec3 hold) { return std::abs(left_m_of(hold, at, along)); });
    holds.erase(nearest);
  }
  return holds;
}

}  // namespace citykiln::wires
