// Masts of electrified railways and tramways that are assumed where none is mapped, and where their wires hang.
//
//      one track        two tracks            three and more          tramway in a street
//     |-----            |----     ----|      |===============|       |______________|
//     |  x              |  x       x  |      |  x   x    x   |       |   x      x   |
//     |  =              |  =       =  |      |  =   =    =   |       |   =      =   |
//
// At each station of a group of tracks that lie beside each other (contact_tracks.h) there is one structure for all of
// them: cantilevers on masts outside of the tracks or in a wide space between them, else a portal; along tramways a
// pole on both sides with a wire across, else one pole with an arm. The track with the lowest id decides where the
// stations of its group are.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/things/catalogue.h"
#include "compiler/things/contact_tracks.h"
#include "compiler/things/recipe.h"

namespace citykiln::things {

/// Heights above the rail of the contact wire of railways and tramways, and of the messenger wire. Source: nominal
/// contact wire heights of 5.0 to 5.75 m (TSI ENE 4.2.9.1), system heights of 1.1 to 1.8 m (Kiessling and others 2018).
inline constexpr double kRailWire_m = 5.3, kTramWire_m = 5.5, kSystemHeight_m = 1.4;
/// The least height of a contact wire above the rail, below bridges.
inline constexpr double kLeastWire_m = 4.9;
/// The distance of a mast's middle from the axis of a track, at least: 2.5 m of clear space beside a railway (EBO,
/// annex 1) and half a mast; 1.65 m and half a pole beside a tramway.
inline constexpr double kMastClear_m = 2.75, kPoleClear_m = 1.9;
/// The stagger of the contact wire: to both sides in turn on straights, to the outside in curves.
inline constexpr double kStagger_m = 0.2, kCurveStagger_m = 0.3;
/// Within this distance of a mapped mast none is assumed.
inline constexpr double kMappedMasts_m = 96;
/// The longest span of contact wires.
inline constexpr double kLongestContactSpan_m = 100;
/// The radius of influence: a span of wires ends at stations of another track's way, of which others are left out.
inline constexpr double kContactRadius_m = 384;

/// A place where the wires of a track hang.
struct ContactSupport {
  std::uint32_t track = 0;  ///< Index into ContactLines::index.
  double along_m = 0;       ///< Along the way.
  Vec3 contact;             ///< The contact wire.
  double messenger_m = 0;   ///< Height of the messenger wire above the contact wire; 0: none.
};

/// A wire across the tracks between two poles.
struct CrossWire {
  ObjectId id;
  Vec3 from, to;
};

/// The contact lines of a map.
struct ContactLines {
  TrackIndex index;
  std::vector<Thing> masts;              ///< Sorted by id.
  std::vector<ContactSupport> supports;  ///< Sorted by track, then along it.
  std::vector<CrossWire> cross_wires;
  std::set<OsmId> replaced;  ///< Mapped masts that are among `masts`, with an arm that reaches their track.
};

/// The data that contact lines depend on, besides the map.
struct ContactSurroundings {
  std::span<const ground::LandCoverPolygon> cover;  ///< The land cover of the whole map, with buildings.
  std::span<const roads::Road> roads;               ///< On the ground; must outlive the result.
  std::span<const structures::Span> bridges;        ///< Must outlive the result.
  const ground::GradedTerrain& ground;
};

/// Plans the contact lines of a map. None is in a tunnel or below a cover. On bridges wires pass without masts; below a
/// bridge they are lowered, and end where less than kLeastWire_m is left. A station without a place for its masts has
/// none, kNoPlaceForThing. Ids of masts are those of the track with the part kFirstDerivedPart and more. Counted as
/// Assumption::kMasts, once for each way. Ledger "things/contact mast". O(stations · tracks near).
ContactLines plan_contact_lines(const map::FeatureView& features, const ContactSurroundings& around, Report& report);

}  // namespace citykiln::things
