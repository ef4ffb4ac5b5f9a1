// The wires of contact lines: between supports that follow each other along the tracks, and across tramways.
//
//     o___          ___o    messenger wire, which sags
//     |   ```----```   |
//     x----------------x    contact wire
#pragma once

#include <tuple>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/things/contact_masts.h"
#include "compiler/wires/recipe.h"

namespace citykiln::wires {

/// The sag of a wire is span² / (8 c). c of the messenger wire, which carries the contact wire, from a tension of 15 kN
/// and 16.5 N/m; of a tramway's contact wire alone, from 10 kN and 10 N/m. Source: Kiessling and others (2018), Re 200
/// and lines of tramways.
inline constexpr double kMessengerParameter_m = 909, kTrolleyParameter_m = 1000;
/// The sag of the contact wire below a messenger wire, as a share of the span (Kiessling and others 2018).
inline constexpr double kContactSag = 0.001;

/// The least height of a contact wire above the land: that above carriageways, and what heights of coarse levels
/// differ.
inline constexpr double kLeastOverTrack_m = 4.6;

/// Returns the wires of contact lines, sorted by id: one span for each two supports that follow each other on a track,
/// at most things::kLongestContactSpan_m apart. At the end of a way, wires go on to the first support of the way that
/// continues it most straightly, also where that one passes the node. Ids are those of the way, with the part
/// kFirstDerivedPart and more. A span whose contact wire is somewhere lower than kLeastOverTrack_m above the
/// land, as where a street beside a sunken track is higher than it, is dropped, kWireTooLow. Ledger
/// "wires/contact span". O(supports · log).
std::vector<WireSpan> contact_spans(const things::ContactLines& lines, const ground::GradedTerrain& ground,
                                    Report& report);

/// The order of spans: by id, then by the ends of the first wire.
inline auto order_of(const WireSpan& span) { return std::tie(span.id, span.wires.front().from, span.wires.front().to); }

}  // namespace citykiln::wires
