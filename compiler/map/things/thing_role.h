// The rows of the table of things that the program itself makes or looks for.
#pragma once

#include <cstdint>
#include <string_view>

namespace citykiln::map {

/// A kind of things that the program knows. Other kinds are only rows of the table.
enum class ThingRole : std::uint8_t {
  kNone,
  kCar,           ///< A mapped parking space; its rules are those of parked cars.
  kCatenaryMast,  ///< A mast on the map, which a contact mast replaces.
  kContactMast,
  kContactPortal,
  kContactHanger,
  kContactPole,
  kCount
};

/// Returns the name of the row of a role, such as "contact_mast". `role` is not kNone.
std::string_view name_of(ThingRole role);

/// Returns the role of a kind, the name of a row; kNone for all that the program does not know.
ThingRole role_of(std::string_view kind);

/// True for masts of contact lines that the program makes, and for what hangs from them.
constexpr bool is_contact(ThingRole role) { return role >= ThingRole::kContactMast && role <= ThingRole::kContactPole; }

}  // namespace citykiln::map
