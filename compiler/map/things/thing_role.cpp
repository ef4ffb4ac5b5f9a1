#include "compiler/map/things/thing_role.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace citykiln::map {
namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(ThingRole::kCount)> kRoleNames = {
    "", "car", "catenary_mast", "contact_mast", "contact_portal", "contact_hanger", "contact_pole"};

}  // namespace

std::string_view name_of(ThingRole role) {
  assert(role > ThingRole::kNone && role < ThingRole::kCount);
  return kRoleNames[static_cast<std::size_t>(role)];
}

ThingRole role_of(std::string_view kind) {
  const auto found = std::ranges::find(kRoleNames, kind);
  return found == kRoleNames.end() ? ThingRole::kNone : static_cast<ThingRole>(found - kRoleNames.begin());
}

}  // namespace citykiln::map
