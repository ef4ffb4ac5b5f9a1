#include "compiler/ground/profiles/graph/approach_paths.h"

#include <gtest/gtest.h>

#include "tests/compiler/ground/profiles/made_network.h"

namespace citykiln::ground {
namespace {

using map::Passage;

// A foot bridge over x from 0 to 20, and paths from its end.
std::vector<bool> led_on_by(std::vector<map::Track> paths) {
  map::Features f;
  f.tracks = {track(1, {{0, 0}, {20, 0}}, kFootway, Passage::kBridge, 1)};
  for (map::Track& path : paths) f.tracks.push_back(std::move(path));
  return approach_paths(f);
}

TEST(ApproachPaths, LeadUpWithinTheirReachAlongPaths) {
  const auto leads = led_on_by({track(2, {{20, 0}, {45, 0}}, kFootway), track(3, {{45, 0}, {75, 0}}, kFootway),
                                track(4, {{75, 0}, {90, 0}}, kFootway), track(5, {{20, 5}, {40, 5}}, kFootway)});
  EXPECT_EQ(leads, (std::vector<bool>{false, true, true, false, false}));
}

TEST(ApproachPaths, AreNoStreetsAndNotLong) {
  const auto leads =
      led_on_by({track(2, {{20, 0}, {45, 0}}), track(3, {{0, 0}, {-kLongestApproach_m - 1, 0}}, kFootway),
                 track(4, {{20, 0}, {20, 30}}, map::LandCoverClass::kSteps)});
  EXPECT_EQ(leads, (std::vector<bool>{false, false, false, true}));
}

TEST(ApproachPaths, DoNotLeadUpToTheMiddleOfABridge) {
  map::Features f;
  f.tracks = {track(1, {{0, 0}, {20, 0}, {40, 0}}, kFootway, Passage::kBridge, 1),
              track(2, {{40, 0}, {60, 0}}, kFootway, Passage::kBridge, 1), track(3, {{20, 0}, {20, 30}}, kFootway),
              track(4, {{40, 0}, {40, 30}}, kFootway), track(5, {{60, 0}, {60, 30}}, kFootway)};
  EXPECT_EQ(approach_paths(f), (std::vector<bool>{false, false, false, false, true}));
}

TEST(ApproachPaths, PassBelowBridges) {
  const auto leads = led_on_by({track(2, {{10, -50}, {10, 50}}, kFootway), track(3, {{30, -50}, {30, 50}}, kFootway),
                                track(4, {{5, -50}, {5, 50}})});
  EXPECT_EQ(leads, (std::vector<bool>{false, true, false, false}));
}

}  // namespace
}  // namespace citykiln::ground
