// The settings of people, a property of the whole scene. A person has no recipe: spots and people are functions of the
// recipes of streets, and are made when a tile is baked (people.h).
#pragma once

namespace citykiln::people {

/// The share of spots that have people.
struct PeopleShare {
  bool is_by_table = false;  ///< By use, country group and hour (presence.h).
  double share = 0;          ///< Otherwise this share of all spots: 0 to 1, a multiple of kPeopleStep.
  bool operator==(const PeopleShare&) const = default;
};

/// The step of PeopleShare::share.
inline constexpr double kPeopleStep = 0x1p-10;
inline constexpr PeopleShare kNobody{}, kUsualPeople{.is_by_table = true};

inline bool has_people(const PeopleShare& wish) { return wish.is_by_table || wish.share > 0; }

}  // namespace citykiln::people
