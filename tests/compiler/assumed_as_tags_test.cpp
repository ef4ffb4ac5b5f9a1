// Assumptions about streets give the same lanes, surface and light as tags that say the same.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

#include "compiler/assume/assume.h"
#include "compiler/assume/fit_widths.h"
#include "compiler/map/locate.h"
#include "compiler/source/read_osm.h"
#include "tests/test_files.h"

namespace citykiln {
namespace {

using map::Lane;
using map::LaneKind;
using map::Track;
using source::OsmData;

// New tags by way.
using NewTags = std::map<std::int64_t, std::map<std::string, std::string>>;

std::map<std::string, std::string> tags_of(const OsmData& osm, const source::Range& range) {
  std::map<std::string, std::string> tags;
  for (const source::Tag& tag : osm.tags_of(range)) tags[osm.strings[tag.key]] = osm.strings[tag.value];
  return tags;
}

std::uint32_t index_of(const std::vector<std::string>& sorted, const std::string& text) {
  return static_cast<std::uint32_t>(std::ranges::lower_bound(sorted, text) - sorted.begin());
}

// Inserts strings and moves the indices of all tags and roles to where the old ones are now.
void add_strings(OsmData& osm, const NewTags& added) {
  std::vector<std::string> sorted = osm.strings;
  for (const auto& [way, tags] : added)
    for (const auto& [key, value] : tags) sorted.push_back(key), sorted.push_back(value);
  std::ranges::sort(sorted);
  sorted.erase(std::ranges::unique(sorted).begin(), sorted.end());
  for (source::Tag& tag : osm.tags)
    tag = {index_of(sorted, osm.strings[tag.key]), index_of(sorted, osm.strings[tag.value])};
  for (source::Member& member : osm.members) member.role = index_of(sorted, osm.strings[member.role]);
  osm.strings = std::move(sorted);
}

OsmData with_tags(OsmData osm, const NewTags& added) {
  add_strings(osm, added);
  for (source::Way& way : osm.ways) {
    const auto found = added.find(way.id);
    if (found == added.end()) continue;
    std::map<std::string, std::string> tags = tags_of(osm, way.tags);
    for (const auto& [key, value] : found->second) tags[key] = value;
    way.tags = {static_cast<std::uint32_t>(osm.tags.size()), static_cast<std::uint32_t>(tags.size())};
    for (const auto& [key, value] : tags)
      osm.tags.push_back({index_of(osm.strings, key), index_of(osm.strings, value)});
  }
  return osm;
}

// The lanes of a side: those beyond the kerb, and the one before it.
std::vector<Lane> lanes_beside(const Track& track, bool is_left) {
  std::vector<Lane> lanes = track.section.lanes;
  if (!is_left) std::ranges::reverse(lanes);
  const auto kerb = std::ranges::find(lanes, false, &Lane::is_raised);
  return {lanes.begin(), kerb + 1};
}

// The width of the lane of a kind on a side; 0 for none.
double width_beside_m(const Track& track, LaneKind kind, bool is_left) {
  for (const Lane& lane : lanes_beside(track, is_left))
    if (lane.kind == kind && lane.is_raised == (kind != LaneKind::kParking)) return lane.width_m;
  return 0;
}

void add_tags_of_side(const Track& track, bool is_left, std::map<std::string, std::string>& tags) {
  const std::string side = is_left ? "left" : "right";
  const std::uint8_t bit = is_left ? map::kLeftSide : map::kRightSide;
  const auto add_strip = [&](const std::string& key, LaneKind kind, std::uint8_t tagged) {
    const double width_m = (tagged & bit) == 0 ? width_beside_m(track, kind, is_left) : 0;
    if (width_m == 0) return;
    tags[key + ":" + side] = "yes";
    tags[key + ":" + side + ":width"] = std::to_string(width_m);
  };
  add_strip("sidewalk", LaneKind::kSidewalk, 0);
  // strips before footways beside the kerb are verges too
  if (has(track.assumed, Assumption::kVerges) || has(track.assumed, Assumption::kPavements))
    add_strip("verge", LaneKind::kVerge, track.tagged_verges);
  if (has(track.assumed, Assumption::kParking) && width_beside_m(track, LaneKind::kParking, is_left) > 0)
    tags["parking:" + side] = "lane";
}

// True for ways without kerbs that were made as wide as the room between walls.
bool is_between_walls(const Track& track) {
  return has(track.assumed, Assumption::kPavements) && std::ranges::none_of(track.section.lanes, &Lane::is_raised);
}

// Adds the width of the carriageway: of its lane, or of the lanes of each direction from left to right as seen along
// it.
void add_widths(const Track& track, std::map<std::string, std::string>& tags) {
  const std::vector<Lane>& lanes = track.section.lanes;
  if (lanes.size() == 1) tags["width"] = std::to_string(lanes[0].width_m);
  if (lanes.size() == 1) return;
  for (const Lane& lane : lanes) {
    const bool is_backward = lane.way == map::LaneDirection::kBackward;
    const std::string flow = is_backward ? ":backward" : ":forward";
    std::string& list = tags[track.is_oneway ? "width:lanes" : "width:lanes" + flow];
    const std::string width = std::to_string(lane.width_m);
    list = list.empty() ? width : is_backward ? width + "|" + list : list + "|" + width;
  }
}

std::map<std::string, std::string> tags_that_say(const Track& track) {
  std::map<std::string, std::string> tags;
  add_tags_of_side(track, true, tags), add_tags_of_side(track, false, tags);
  if (is_between_walls(track)) add_widths(track, tags);
  if (has(track.assumed, Assumption::kLamps)) tags["lit"] = "yes";
  if (has(track.assumed, Assumption::kSurfaces)) tags["surface"] = "gravel";
  return tags;
}

std::vector<Track> streets_of(const OsmData& osm, Assumptions on) {
  Report report;
  const source::LonLatBox box = map::choose_box(osm, {});
  map::Features features = map::locate(osm, map::Plane(map::default_origin(box)), box, {}, report);
  features.tracks = assume::fit_assumed_widths(features);
  return assume::assume(std::move(features), {.on = on, .seed = 0}, report).tracks;
}

// The lanes from left to right; raised ones in brackets.
std::string text_of(const Track& track) {
  std::string text;
  for (const Lane& lane : track.section.lanes)
    text +=
        fmt::format(fmt::runtime(lane.is_raised ? "[{} {}] " : "{} {} "), static_cast<int>(lane.kind), lane.width_m);
  return text + fmt::format("axis {} surface {} lit {}", track.section.axis_offset_m, static_cast<int>(track.surface),
                            track.is_lit);
}

struct Counts {
  int equal = 0;
  std::map<Assumption, int> by_assumption;
  std::vector<std::string> different;
};

// Assumes, writes what is assumed of whole ways as tags, and compares the streets.
Counts count_equal_streets(const std::filesystem::path& path) {
  Report report;
  const Result<OsmData> osm = source::read_osm(path.string(), 1, report);
  EXPECT_TRUE(osm) << path;
  if (!osm) return {};
  std::map<ObjectId, Track> assumed;
  NewTags added;
  for (Track& track : streets_of(*osm, kAllAssumptions)) {
    if (track.assumed == kNoAssumptions || track.is_piece || track.passage != map::Passage::kGround) continue;
    added[track.id.osm.id] = tags_that_say(track);
    assumed[track.id] = std::move(track);
  }
  Counts counts;
  for (const Track& track : streets_of(with_tags(*osm, added), kNoAssumptions)) {
    const auto found = assumed.find(track.id);
    if (found == assumed.end()) continue;
    const Track& other = found->second;
    map::CrossSection section = track.section;
    // no tag says where between two walls the mapped axis of a paved way lies
    if (is_between_walls(other)) section.axis_offset_m = other.section.axis_offset_m;
    const bool is_equal = section == other.section && track.surface == other.surface && track.is_lit == other.is_lit;
    if (!is_equal)
      counts.different.push_back(std::to_string(track.id.osm.id) + ": " + text_of(other) + ", as tags " +
                                 text_of(track));
    counts.equal += is_equal ? 1 : 0;
    for (const Assumption one :
         {Assumption::kPavements, Assumption::kVerges, Assumption::kParking, Assumption::kLamps, Assumption::kSurfaces})
      counts.by_assumption[one] += has(other.assumed, one) ? 1 : 0;
  }
  return counts;
}

TEST(AssumedAsTags, GiveTheSameStreetsInTheTown) {
  const Counts counts = count_equal_streets(source_file("examples/town/town.osm"));
  EXPECT_GT(counts.equal, 10);
  EXPECT_EQ(counts.different, std::vector<std::string>{});
}

TEST(AssumedAsTagsReal, GiveTheSameStreetsInSuburbs) {
  std::map<Assumption, int> all;
  for (const char* const file :
       {"los-angeles-north-hills/north-hills.osm.gz", "limerick/limerick.osm.gz", "boston-back-bay/back_bay.osm.pbf"}) {
    if (!std::filesystem::exists(real_data(file))) GTEST_SKIP() << file << " is absent";
    const Counts counts = count_equal_streets(real_data(file));
    EXPECT_GT(counts.equal, 50) << file;
    EXPECT_EQ(counts.different, std::vector<std::string>{}) << file;
    for (const auto& [assumption, count] : counts.by_assumption) all[assumption] += count;
  }
  for (const auto& [assumption, count] : all) EXPECT_GT(count, 0) << static_cast<int>(assumption);
}

}  // namespace
}  // namespace citykiln
