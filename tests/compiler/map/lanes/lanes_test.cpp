// Cross-sections of real ways, and properties of all.
#include "compiler/map/lanes/lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "compiler/geometry/snap.h"
#include "compiler/map/tags/read_context.h"
#include "tests/compiler/map/map_text.h"

namespace citykiln::map {
namespace {

using Tags = std::map<std::string, std::string>;

Tags tags_of(const std::string& text) {
  Tags tags;
  std::istringstream words(text);
  for (std::string word; words >> word;) tags[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
  return tags;
}

std::string text_of_tags(const Tags& tags) {
  std::string text;
  for (const auto& [key, value] : tags) text += key + "=" + value + " ";
  return text;
}

struct Read {
  CrossSection section;
  Report report;
  std::size_t bad_values;
};

Read read(const std::string& tags, DrivingSide side = DrivingSide::kRight) {
  static const Plane plane(kTestOrigin);
  const source::OsmData osm = extract("w1 0:0 50:0 " + tags);
  Report report;
  const ReadContext reading{osm, plane, Box2{}, report};
  CrossSection section = tagged_section_of(reading, {OsmType::kWay, 1}, osm.ways[0].tags, side).section;
  const std::size_t bad_values = report.counts()[Code::kBadTagValue];
  return {std::move(section), std::move(report), bad_values};
}

// The tags that are diagnosed as bad, each followed by a space.
std::string bad_tags_of(const std::string& tags) {
  std::string text;
  const Read result = read(tags);
  for (const Diagnosis& diagnosis : result.report.diagnoses())
    if (diagnosis.code == Code::kBadTagValue) text += diagnosis.tag + " ";
  return text;
}

std::string drawn(const std::string& tags, DrivingSide side = DrivingSide::kRight) {
  return to_string(read(tags, side).section);
}

// The bits of every lane: equal for sections that are drawn alike.
std::string all_of(const CrossSection& section) {
  std::string text = to_string(section) + fmt::format(" axis {:a}", section.axis_offset_m);
  for (const Lane& lane : section.lanes) text += fmt::format(" {:a}.{}", lane.width_m, lane.turns);
  return text;
}

struct RealWay {
  const char *tags, *on_the_right, *on_the_left;
};
// © OpenStreetMap contributors, ODbL 1.0; extract and way before each; ~ stands for a space.
constexpr RealWay kRealWays[] = {
    // niteroi.osm.pbf w29188387
    {"highway=busway access=no bus=yes busway=yes oneway=yes", "b ^", "b ^"},
    // niteroi.osm.pbf w156662370
    {"highway=busway bus=yes oneway=yes", "b ^", "b ^"},
    // st_georges_cycletrack.osm w416813997
    {"highway=cycleway est_width=4 lanes=2 oneway=no", "c -", "c -"},
    // Helsinki.osm.pbf w4253744
    {"highway=cycleway lanes=2", "c -", "c -"},
    // niteroi.osm.pbf w699279423
    {"highway=living_street lanes=1", "d -", "d -"},
    // niteroi.osm.pbf w33637000
    {"highway=motorway cycleway=no lanes=4 oneway=yes sidewalk=no", "dddd ^^^^", "dddd ^^^^"},
    // i5_exit_ramp.osm w4644156
    {"highway=motorway lanes=4 oneway=yes turn:lanes=none|none|none|through;slight_right", "dddd ^^^^", "dddd ^^^^"},
    // porto_portugal.osm.pbf w151578610
    {"highway=motorway_link lanes=2 oneway=no", "dd v^", "dd ^v"},
    // chicago_loop.osm.pbf w435716633
    {"highway=motorway_link lanes=3 oneway=yes turn:lanes=left|left;through|", "ddd ^^^", "ddd ^^^"},
    // berlin-reinickendorf-2026.osm.pbf w229321135
    {"highway=path oneway=yes width=1.1", "f -", "f -"},
    // niteroi.osm.pbf w81023353
    {"highway=pedestrian lanes=2 oneway=no", "f -", "f -"},
    // cut-andorra-la-vella.osm.pbf w30567542
    {"highway=primary access=yes cycleway=no lanes=2 lanes:backward=1 lanes:forward=1 oneway=no sidewalk=both",
     "s|dd|s -|v^|-", "s|dd|s -|^v|-"},
    // andorra-2013.osm.gz w6178632
    {"highway=primary access=yes cycleway=no lanes=3 lanes:left=1 oneway=no", "ddd v-^", "ddd ^-v"},
    // andorra-2013.osm.gz w107066831
    {"highway=primary access=yes cycleway=no lanes=4 lanes:left=2 oneway=no", "dddd vv^^", "dddd ^^vv"},
    // st_georges_cycletrack.osm w385869005
    {"highway=primary bicycle:lanes=yes|designated|yes!yes cycleway:left=lane lanes=3 oneway=yes sidewalk=left "
     "turn:lanes=left|through|through|through",
     "s|dcd -|^^^", "s|dcd -|^^^"},
    // niteroi.osm.pbf w605884113
    {"highway=primary cycleway:left=lane cycleway:left:oneway=no lanes=4 lanes:psv=1 oneway=yes oneway:bicycle=no "
     "psv:lanes=yes|yes|yes|designated",
     "cdddb -^^^^", "cdddb -^^^^"},
    // niteroi.osm.pbf w688978991
    {"highway=primary cycleway:left=lane lanes=5 oneway=yes oneway:bicycle=no "
     "turn:lanes=left|through|through|through|through",
     "cddddd v^^^^^", "cddddd ^^^^^^"},
    // neubrandenburg.osm.bz2 w148770557
    {"highway=primary cycleway:left=none cycleway:right=track lanes=4 lanes:forward=3 sidewalk=right",
     "dddd|cs v^^^|^-", "dddd|cs ^^^v|v-"},
    // porto_portugal.osm.pbf w157461618
    {"highway=primary cycleway=no junction=roundabout", "d ^", "d ^"},
    // cut-andorra-la-vella.osm.pbf w6275504
    {"highway=primary cycleway=no junction=roundabout lanes=2", "dd ^^", "dd ^^"},
    // cut-canillo-village.osm.pbf w456350898
    {"highway=primary cycleway=no lanes=3 lanes:backward=1 lanes:forward=2 oneway=no placement:forward=left_of:1 "
     "sidewalk=both",
     "s|ddd|s -|v^^|-", "s|ddd|s -|^^v|-"},
    // bristol_sausage_links.osm w291394487
    {"highway=primary lanes=1 oneway=yes sidewalk:left=yes", "s|d -|^", "s|d -|^"},
    // borough_sausage_links.osm w211780343
    {"highway=primary lanes=2 oneway=yes parking:both=no sidewalk=left turn:lanes=left;through|through;right",
     "s|dd -|^^", "s|dd -|^^"},
    // Helsinki.osm.pbf w155367885
    {"highway=primary lanes=2 oneway=yes parking:lane:left=no_parking parking:lane:right=parallel "
     "parking:lane:right:parallel=lay_by",
     "ddp ^^^", "ddp ^^^"},
    // neubrandenburg.osm.bz2 w233666601
    {"highway=primary lanes=2 turn:lanes:forward=none|through;right", "dd v^", "dd ^v"},
    // Helsinki.osm.pbf w217189185
    {"highway=primary lanes=3 oneway=yes parking:lane:both=no_stopping turn:lanes=||right width:lanes=3.5|3.5|2.5",
     "ddd ^^^", "ddd ^^^"},
    // poa_osm.pbf w447936232
    {"highway=primary lanes=3 oneway=yes shoulder=yes sidewalk=no", "dddS ^^^^", "Sddd ^^^^"},
    // porto_portugal.osm.pbf w160503767
    {"highway=primary_link lanes:psv:backward=1 oneway=no", "bd v-", "db -v"},
    // spreewaldring.osm w172927499
    {"highway=raceway oneway=yes width=10", "d ^", "d ^"},
    // niteroi.osm.pbf w144352154
    {"highway=residential access=private lanes=1 oneway=yes", "d ^", "d ^"},
    // berlin-reinickendorf-2026.osm.pbf w301821696
    {"highway=residential cycleway:both=no parking:both=lane parking:both:orientation=parallel "
     "parking:both:staggered=yes sidewalk:both=separate width=5",
     "pdp v-^", "pdp ^-v"},
    // berlin-reinickendorf-2026.osm.pbf w1460600738
    {"highway=residential cycleway:both=no parking:left=no parking:right=lane parking:right:orientation=parallel "
     "sidewalk=right width=6",
     "dp|s -^|-", "dp|s -v|-"},
    // berlin-reinickendorf-2026.osm.pbf w1462425642
    {"highway=residential cycleway:both=no parking:left=no parking:right=shoulder parking:right:informal=yes "
     "parking:right:orientation=parallel",
     "ddp v^^", "ddp ^vv"},
    // berlin-reinickendorf-2026.osm.pbf w8100317
    {"highway=residential cycleway:both=track cycleway:both:oneway=yes cycleway:both:width=1 parking:both=no "
     "sidewalk:both=separate",
     "c|dd|c v|v^|^", "c|dd|c ^|^v|v"},
    // niteroi.osm.pbf w874950477
    {"highway=residential cycleway:right=lane cycleway:right:oneway=no", "ddc v^-", "ddc ^v-"},
    // Helsinki.osm.pbf w75621804
    {"highway=residential lanes=2 parking:lane:both=parallel parking:lane:both:inline=on_street "
     "parking:right:placement=dedicated",
     "pddp vv^^", "pddp ^^vv"},
    // neubrandenburg.osm.bz2 w357845598
    {"highway=residential lanes=3 lanes:backward=1 lanes:forward=2 sidewalk=both turn:lanes:forward=left;through|right",
     "s|ddd|s -|v^^|-", "s|ddd|s -|^^v|-"},
    // poa_osm.pbf w222420361
    {"highway=residential lanes=4 oneway=no", "dddd vv^^", "dddd ^^vv"},
    // Helsinki.osm.pbf w60754211
    {"highway=residential parking:lane:left=parallel parking:lane:left:parallel=painted_area_only "
     "parking:lane:right=no_stopping",
     "pdd vv^", "pdd ^^v"},
    // porto_portugal.osm.pbf w130597446
    {"highway=residential width=2~m", "d -", "d -"},
    // chicago_loop.osm.pbf w435724087
    {"highway=secondary bus:lanes=||designated busway:right=lane cycleway:right=no lanes=3 oneway=yes "
     "sidewalk=separate turn:lanes=||right",
     "ddb ^^^", "ddb ^^^"},
    // niteroi.osm.pbf w868069250
    {"highway=secondary busway:both=yes lanes=3 oneway=yes oneway:bicycle=no", "bdb ^^^", "bdb ^^^"},
    // poa_osm.pbf w189476999
    {"highway=secondary busway:left=opposite_lane lanes=4 oneway=yes", "bddd v^^^", "dddd ^^^^"},
    // chicago_loop.osm.pbf w56150137
    {"highway=secondary busway=lane cycleway:right=separate lanes=2 oneway=yes sidewalk:left=no "
     "sidewalk:right=separate",
     "db ^^", "bd ^^"},
    // berlin-reinickendorf-2026.osm.pbf w1466308466
    {"highway=secondary cycleway:both=lane cycleway:both:lane=advisory lanes=2 parking:both=lane "
     "parking:both:orientation=parallel sidewalk:both=separate",
     "pcddcp vvv^^^", "pcddcp ^^^vvv"},
    // berlin-reinickendorf-2026.osm.pbf w1460828707
    {"highway=secondary cycleway:both=no lanes=2 parking:left=street_side parking:left:orientation=parallel "
     "parking:right=no sidewalk:both=separate",
     "pdd vv^", "pdd ^^v"},
    // chicago_loop.osm.pbf w59678172
    {"highway=secondary cycleway:both=no lanes=3 lanes:forward=1 placement:forward=left_of:1 sidewalk:both=separate "
     "turn:lanes:backward=left|right",
     "ddd vv^", "ddd ^vv"},
    // chicago_loop.osm.pbf w435561327
    {"highway=secondary cycleway:both=no lanes=4 lanes:forward=2 sidewalk=separate", "dddd vv^^", "dddd ^^vv"},
    // chicago_loop.osm.pbf w452182383
    {"highway=secondary cycleway:left=lane cycleway:left:buffer=no cycleway:right=separate lanes=3 lanes:backward=2 "
     "lanes:forward=1 sidewalk:both=separate",
     "cddd vvv^", "cddd ^^vv"},
    // poa_osm.pbf w356396256
    {"highway=secondary cycleway:left=no cycleway:right=no lanes=4 oneway=yes parking:lane:left=parallel "
     "parking:lane:right=no_parking sidewalk=both",
     "s|pdddd|s -|^^^^^|-", "s|pdddd|s -|^^^^^|-"},
    // chicago_loop.osm.pbf w488107951
    {"highway=secondary cycleway:right=separate lanes=3 lanes:bus=1 oneway=yes placement=left_of:2 sidewalk=separate",
     "ddb ^^^", "bdd ^^^"},
    // chicago_loop.osm.pbf w48781729
    {"highway=secondary cycleway:right=track cycleway:right:buffer=no cycleway:right:lane=advisory oneway=yes",
     "d|c ^|^", "d|c ^|^"},
    // chicago_loop.osm.pbf w24213603
    {"highway=secondary cycleway=lane cycleway:both:buffer=yes lanes=3 lanes:backward=2 lanes:forward=1 "
     "sidewalk:both=separate turn:lanes:backward=left|",
     "c/ddd/c v-vv^-^", "c/ddd/c ^-^vv-v"},
    // chicago_loop.osm.pbf w929942824
    {"highway=secondary cycleway=separate cycleway:both=separate lanes=2 parking:right=lane sidewalk:both=separate",
     "ddp v^^", "ddp ^vv"},
    // Helsinki.osm.pbf w30242130
    {"highway=secondary lanes=2 lanes:psv=1 oneway=yes", "db ^^", "bd ^^"},
    // chicago_loop.osm.pbf w930446697
    {"highway=secondary lanes=3 lanes:backward=1 lanes:both_ways=1 lanes:forward=1 sidewalk=separate "
     "turn:lanes:both_ways=left",
     "dtd v-^", "dtd ^-v"},
    // chicago_loop.osm.pbf w407991200
    {"highway=secondary lanes=5 lanes:backward=2 lanes:forward=3 parking:lane:right:parallel=no_parking "
     "sidewalk=separate turn:lanes:backward=right|right",
     "ddddd vv^^^", "ddddd ^^^vv"},
    // tempe_light_rail.osm w845775034
    {"highway=secondary lanes=6 lanes:backward=2 lanes:both_ways=1 lanes:forward=3 oneway=no sidewalk=both "
     "turn:lanes:both_ways=left",
     "s|ddtddd|s -|vv-^^^|-", "s|dddtdd|s -|^^^-vv|-"},
    // niteroi.osm.pbf w183047623
    {"highway=secondary_link lanes=2 oneway=yes oneway:foot=no sidewalk:left=yes sidewalk:right=no", "s|dd -|^^",
     "s|dd -|^^"},
    // poa_osm.pbf w285732202
    {"highway=service access=yes lanes=2 oneway=yes parking:lane:both=no_parking sidewalk=no", "dd ^^", "dd ^^"},
    // berlin-reinickendorf-2026.osm.pbf w1276545873
    {"highway=service cycleway:both=no oneway=no parking:left=no parking:right=street_side "
     "parking:right:orientation=parallel sidewalk=no",
     "dp -^", "dp -v"},
    // northgate_dual_carriageway.osm w486023141
    {"highway=service lanes=2 lanes:backward=1 lanes:forward=1 turn:lanes:forward=right", "dd v^", "dd ^v"},
    // chicago_loop.osm.pbf w199561670
    {"highway=service oneway=yes parking:lane:left:parallel=on_street parking:left=yes "
     "parking:left:orientation=parallel",
     "pd ^^", "pd ^^"},
    // neubrandenburg.osm.bz2 w231863978
    {"highway=service parking:lane:both:perpendicular=lay_by sidewalk=left", "s|d -|-", "s|d -|-"},
    // portland-central-filtered.osm.pbf w69340957
    {"highway=tertiary bicycle:lanes=yes|designated cycleway=lane lanes=2 oneway=yes sidewalk=right", "dc|s ^^|-",
     "dc|s ^^|-"},
    // berlin-siegessaeule.osm.gz w156341117
    {"highway=tertiary bus:lanes=yes|yes|designated lanes=3 oneway=yes", "ddb ^^^", "ddb ^^^"},
    // niteroi.osm.pbf w79785364
    {"highway=tertiary cycleway:left=lane cycleway:left:width=2.5 lanes=1 oneway=yes oneway:bicycle=no sidewalk=both",
     "s|cd|s -|v^|-", "s|cd|s -|^^|-"},
    // portland-central-filtered.osm.pbf w281755221
    {"highway=tertiary cycleway:left=lane cycleway:right=shared_lane oneway=yes oneway:bicycle=no oneway:bus=no "
     "sidewalk=right",
     "cd|s v^|-", "cd|s ^^|-"},
    // niteroi.osm.pbf w264070400
    {"highway=tertiary cycleway:left=no cycleway:right=track cycleway:right:foot=yes lanes=2", "dd|c v^|^",
     "dd|c ^v|v"},
    // portland-central-filtered.osm.pbf w160390336
    {"highway=tertiary cycleway=track sidewalk=both", "sc|dd|cs -v|v^|^-", "sc|dd|cs -^|^v|v-"},
    // Helsinki.osm.pbf w300665534
    {"highway=tertiary lanes=3 lanes:psv=1 oneway=yes placement=right_of:2 turn:lanes=left|through|through", "ddb ^^^",
     "bdd ^^^"},
    // niteroi.osm.pbf w74379669
    {"highway=trunk busway:left=lane lanes=3 oneway=yes sidewalk=right", "bdd|s ^^^|-", "bdd|s ^^^|-"},
    // kingsway_junction.osm w999493252
    {"highway=trunk cycleway:left=lane lanes=2 oneway=yes turn:lanes=through|through;right", "cdd ^^^", "cdd ^^^"},
    // porto_portugal.osm.pbf w152815049
    {"highway=unclassified lanes=1 oneway=-1", "d v", "d v"},
    // Helsinki.osm.pbf w81239438
    {"highway=unclassified oneway=yes parking:lane:left=diagonal parking:lane:left:diagonal=painted_area_only", "pd ^^",
     "pd ^^"},
    // Helsinki.osm.pbf w81353463
    {"highway=unclassified parking:lane:left=perpendicular parking:lane:left:orthogonal=on_street "
     "parking:lane:right=no_parking",
     "pdd vv^", "pdd ^^v"},
    // Helsinki.osm.pbf w81353482
    {"highway=unclassified lanes=1 parking:lane:both=parallel parking:lane:both:inline=on_street", "pdp v-^",
     "pdp ^-v"},
    // tempe_light_rail.osm w966022991
    {"railway=light_rail oneway=yes", "r -", "r -"},
    // i5_exit_ramp.osm w4644170
    {"highway=motorway_link junction:ref=169 lanes=1 oneway=reversible", "d -", "d -"},
    // berlin-reinickendorf-2026.osm.pbf w1265293071
    {"highway=residential cycleway:both=no parking:left=half_on_kerb parking:left:orientation=parallel "
     "parking:right=lane parking:right:orientation=parallel sidewalk:both=separate",
     "pddp vv^^", "pddp ^^vv"},
    // portland-central-filtered.osm.pbf w32143447
    {"highway=tertiary cycleway=opposite_lane oneway=yes sidewalk=both", "s|cd|s -|v^|-", "s|dc|s -|^v|-"},
    // neubrandenburg.osm.bz2 w28925589
    {"highway=primary cycleway=opposite_track lanes=2 oneway=yes", "c|dd v|^^", "dd|c ^^|v"},
    // st_georges_cycletrack.osm w567023139
    {"highway=primary cycleway:right=share_busway cycleway:right:oneway=-1 lanes=3 oneway=yes oneway:bicycle=no "
     "oneway:bus=no psv=opposite_lane sidewalk=both",
     "s|bdd|s -|v^^|-", "s|ddb|s -|^^v|-"},
    // aurora_sausage_link.osm w792024857
    {"highway=primary bus:lanes:backward=yes|yes|designated bus:lanes:forward=yes|yes|designated cycleway:right=no "
     "lanes=3 oneway=yes parking:lane:both=no_stopping sidewalk:left=no sidewalk:right=separate",
     "ddb ^^^", "ddb ^^^"},
    // porto_portugal.osm.pbf w326777935
    {"highway=secondary lanes=5 lanes:psv=2 oneway=no", "bdddb vv-^^", "bdddb ^^-vv"},
    // Helsinki.osm.pbf w29478214
    {"highway=steps est_width=65", "f -", "f -"},
    // neubrandenburg.osm.bz2 w8074906
    {"aeroway=taxiway", "d -", "d -"},
    // poa_osm.pbf w356396266
    {"highway=tertiary junction=roundabout oneway=yes sidewalk=right;no", "d|s ^|-", "d|s ^|-"},
    // porto_portugal.osm.pbf w171142750
    {"highway=primary access=designated lanes=1;2 oneway=yes", "d ^", "d ^"},
    // chicago_loop.osm.pbf w433783094
    {"highway=secondary bus:lanes=no|no|yes cycleway:left=separate lanes=4 oneway=yes sidewalk:both=separate "
     "turn:lanes=left|||",
     "dddd ^^^^", "dddd ^^^^"},
    // seattle_slip_lane.osm w7978646
    {"highway=service access=destination lanes=1 width=16'0\"", "d -", "d -"},
    // berlin-reinickendorf-2026.osm.pbf w1460547309
    {"highway=residential cycleway:both=track cycleway:both:oneway=yes cycleway:both:width=1 parking:left=on_kerb "
     "parking:left:orientation=parallel parking:right=no sidewalk:both=separate",
     "c|pdd|c v|vv^|^", "c|pdd|c ^|^^v|v"},
};

TEST(Lanes, RealWaysAreReadAsDrawn) {
  for (const RealWay& way : kRealWays) {
    EXPECT_EQ(drawn(way.tags, DrivingSide::kRight), way.on_the_right) << way.tags;
    EXPECT_EQ(drawn(way.tags, DrivingSide::kLeft), way.on_the_left) << way.tags;
  }
}

// ---- mirrors

std::string swapped_words(std::string text, const std::string& a, const std::string& b) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (text.compare(i, a.size(), a) == 0)
      result += b, i += a.size();
    else if (text.compare(i, b.size(), b) == 0)
      result += a, i += b.size();
    else
      result += text[i++];
  }
  return result;
}

std::string reversed_list(const std::string& text) {
  std::string result, entry;
  for (const char c : text + "|")
    if (c == '|')
      result = result.empty() && entry.empty() ? "|" : entry + "|" + result, entry.clear();
    else
      entry += c;
  return result.substr(0, result.size() - 1);
}

// Left for right everywhere.
Tags mirrored(const Tags& tags) {
  Tags result;
  for (const auto& [key, value] : tags) {
    const std::string swapped = swapped_words(value, "left", "right");
    result[swapped_words(key, "left", "right")] =
        value.find('|') == std::string::npos ? swapped : reversed_list(swapped);
  }
  return result;
}

std::uint16_t mirrored(std::uint16_t turns) {
  const auto swap = [&](LaneTurn a, LaneTurn b) { return ((turns & a) ? b : 0) | ((turns & b) ? a : 0); };
  return static_cast<std::uint16_t>((turns & (kTurnThrough | kTurnReverse)) | swap(kTurnLeft, kTurnRight) |
                                    swap(kTurnSlightLeft, kTurnSlightRight) | swap(kTurnSharpLeft, kTurnSharpRight) |
                                    swap(kTurnMergeToLeft, kTurnMergeToRight));
}

CrossSection mirrored(CrossSection section) {
  section.axis_offset_m = carriageway_width_m(section) - section.axis_offset_m;
  std::reverse(section.lanes.begin(), section.lanes.end());
  for (Lane& lane : section.lanes) lane.turns = mirrored(lane.turns);
  return section;
}

// Tags of the road if it is drawn from its other end. Lists and turns stay, since they are given as drivers see them.
Tags turned_round(const Tags& tags) {
  Tags result;
  for (const auto& [key, value] : tags) {
    const std::string new_key = swapped_words(swapped_words(key, "left", "right"), "forward", "backward");
    const bool names_side = key == "sidewalk" || key == "verge" || key == "shoulder" || key == "busway";
    result[new_key] = names_side ? swapped_words(value, "left", "right") : value;
    if (key == "oneway" && (value == "yes" || value == "-1")) result[key] = value == "yes" ? "-1" : "yes";
  }
  return result;
}

CrossSection turned_round(CrossSection section) {
  section.axis_offset_m = carriageway_width_m(section) - section.axis_offset_m;
  std::reverse(section.lanes.begin(), section.lanes.end());
  for (Lane& lane : section.lanes)
    if (lane.way != LaneDirection::kBoth)
      lane.way = lane.way == LaneDirection::kForward ? LaneDirection::kBackward : LaneDirection::kForward;
  return section;
}

// Tags without a mirror image: lanes counted from the left without a total, and positions relative to the way.
bool has_mirror(const Tags& tags) {
  const auto is_absolute = [](const auto& tag) {
    return tag.first.starts_with("placement") || tag.first.ends_with(":oneway");
  };
  return std::none_of(tags.begin(), tags.end(), is_absolute);
}
bool can_be_turned_round(const Tags& tags) {
  if (!has_mirror(tags)) return false;
  if (tags.count("oneway") > 0) return tags.at("oneway") != "maybe";
  return tags.count("junction") == 0 && !tags.at("highway").starts_with("motorway");
}

void expect_mirrored(const Tags& tags) {
  const CrossSection right = read(text_of_tags(tags), DrivingSide::kRight).section,
                     left = read(text_of_tags(mirrored(tags)), DrivingSide::kLeft).section;
  EXPECT_EQ(all_of(mirrored(right)), all_of(left)) << text_of_tags(tags);
}

void expect_turned_round(const Tags& tags, DrivingSide side) {
  const CrossSection turned = turned_round(read(text_of_tags(tags), side).section),
                     other = read(text_of_tags(turned_round(tags)), side).section;
  ASSERT_EQ(to_string(turned), to_string(other)) << text_of_tags(tags);
  for (std::size_t i = 0; i < turned.lanes.size(); ++i) {
    EXPECT_NEAR(turned.lanes[i].width_m, other.lanes[i].width_m, 0x1p-10) << text_of_tags(tags);
    EXPECT_EQ(turned.lanes[i].turns, other.lanes[i].turns) << text_of_tags(tags);
  }
  EXPECT_NEAR(turned.axis_offset_m, other.axis_offset_m, 0x1p-6) << text_of_tags(tags);
}

TEST(Lanes, RealWaysDrivenOnTheOtherSideAreMirrored) {
  int count = 0;
  for (const RealWay& way : kRealWays) {
    const Tags tags = tags_of(way.tags);
    if (!has_mirror(tags)) continue;
    expect_mirrored(tags);
    ++count;
  }
  EXPECT_GT(count, 60);
}

TEST(Lanes, RealWaysTurnedRoundAreReversed) {
  int count = 0;
  for (const RealWay& way : kRealWays) {
    const Tags tags = tags_of(way.tags);
    if (tags.count("highway") == 0 || !can_be_turned_round(tags)) continue;
    for (const DrivingSide side : {DrivingSide::kRight, DrivingSide::kLeft}) expect_turned_round(tags, side);
    ++count;
  }
  EXPECT_GT(count, 60);
}

// ---- random tags

struct Choice {
  std::vector<std::string> keys, values;
};

const std::vector<Choice>& choices() {
  static const std::vector<Choice> all = {
      {{"lanes"}, {"1", "2", "3", "4", "5", "6", "8", "16", "1.5", "0", "-3", "1000", "many", "2;3"}},
      {{"lanes:forward", "lanes:backward"}, {"0", "1", "2", "3", "16", "-1", "x"}},
      {{"lanes:both_ways"}, {"1", "2", "9"}},
      {{"turn:lanes", "turn:lanes:forward", "turn:lanes:backward", "turn:lanes:both_ways"},
       {"left|", "left|through", "left|through;right", "|right", "left|through|through;slight_right", "left", "|||",
        "reverse;sharp_left|none|merge_to_left", "up|down", ";;|;"}},
      {{"width"}, {"2", "3.3", "4.4", "6.3", "9", "25", "79", "0", "wide", "-4"}},
      {{"est_width"}, {"5", "4.6+"}},
      {{"width:lanes", "width:lanes:forward", "width:lanes:backward"}, {"3|3.1", "2.7", "3||3", "a|b", "3|-1|9999"}},
      {{"oneway"}, {"yes", "-1", "no", "reversible", "alternating", "maybe"}},
      {{"junction"}, {"roundabout", "circular"}},
      {{"cycleway", "cycleway:left", "cycleway:right", "cycleway:both"},
       {"lane", "track", "opposite_lane", "opposite_track", "no", "separate", "shared_lane", "shoulder"}},
      {{"cycleway:left:width", "cycleway:right:width"}, {"1", "2.25", "x", "900"}},
      {{"cycleway:left:buffer", "cycleway:both:buffer"}, {"yes", "no", "0.8", "x"}},
      {{"oneway:bicycle"}, {"no", "yes"}},
      {{"sidewalk", "shoulder", "verge"}, {"both", "left", "right", "no", "yes", "separate", "right;no"}},
      {{"sidewalk:left", "sidewalk:right", "sidewalk:both", "shoulder:left", "shoulder:right", "shoulder:both"},
       {"yes", "no", "separate"}},
      {{"verge:left", "verge:right", "verge:both"}, {"yes", "no", "separate"}},
      {{"verge:left:width", "verge:both:width", "verge:width"}, {"2.5", "0.01", "x"}},
      {{"parking:left", "parking:right", "parking:both"},
       {"lane", "street_side", "half_on_kerb", "on_kerb", "yes", "no", "separate", "diagonal"}},
      {{"parking:left:orientation", "parking:right:orientation"}, {"parallel", "diagonal", "perpendicular", "odd"}},
      {{"parking:lane:left", "parking:lane:right", "parking:lane:both"}, {"parallel", "diagonal", "no_stopping"}},
      {{"parking:lane:both:parallel", "parking:lane:left:diagonal"}, {"lay_by", "half_on_kerb", "on_street"}},
      {{"busway", "busway:left", "busway:right", "busway:both"}, {"lane", "opposite_lane", "yes", "no"}},
      {{"lanes:bus", "lanes:psv", "lanes:bus:forward", "lanes:psv:backward"}, {"1", "2", "16", "yes", "x"}},
      {{"bus:lanes", "psv:lanes:forward", "bus:lanes:backward"}, {"|designated", "no|no|yes", "designated", "yes|yes"}},
      {{"bicycle:lanes", "bicycle:lanes:forward", "bicycle:lanes:backward"},
       {"|designated", "|designated|", "designated|designated|designated", "yes|yes", "designated"}},
      {{"centre_turn_lane", "access", "bus", "psv"}, {"yes", "no", "designated"}},
  };
  return all;
}

// Tags for random tests alone, since they have no mirror image.
const std::vector<Choice>& absolute_choices() {
  static const std::vector<Choice> all = {
      {{"placement", "placement:forward", "placement:backward"},
       {"right_of:1", "left_of:2", "middle_of:1", "transition", "right_of:99", "left_of:", ":", "middle_of:x", "1"}},
      {{"cycleway:left:oneway", "cycleway:right:oneway", "cycleway:both:oneway"}, {"yes", "no", "-1"}},
      {{"layer", "maxspeed"}, {"999", "fast", ""}},
      {{"turn:lanes", "bicycle:lanes"}, {"|||||||||||||||", "||||||||||||||||||||||||||||", "|", "~", "left;;right"}},
  };
  return all;
}

class RandomTags {
 public:
  explicit RandomTags(unsigned seed) : random_(seed) {}
  Tags draw(bool is_mirrored_later) {
    static const std::vector<std::string> classes = {"motorway",    "trunk",         "primary", "secondary_link",
                                                     "residential", "living_street", "service", "footway",
                                                     "cycleway",    "busway",        "track"};
    Tags tags = {{"highway", one_of(classes)}};
    for (std::size_t n = below(9); n-- > 0;) add(tags, one_of(choices()));
    if (!is_mirrored_later && below(2) == 0) add(tags, one_of(absolute_choices()));
    if (!is_mirrored_later && below(20) == 0) tags.erase("highway");
    return tags;
  }

 private:
  std::size_t below(std::size_t n) { return random_() % n; }
  template <typename T>
  const T& one_of(const std::vector<T>& from) {
    return from[below(from.size())];
  }
  void add(Tags& tags, const Choice& choice) { tags[one_of(choice.keys)] = one_of(choice.values); }

  std::mt19937 random_;
};

TEST(Lanes, RandomTagsAreReadTotallyAndAlwaysAlike) {
  RandomTags random(1);
  for (int i = 0; i < 20000; ++i) {
    const std::string tags = text_of_tags(random.draw(false));
    const DrivingSide side = i % 2 == 0 ? DrivingSide::kRight : DrivingSide::kLeft;
    const CrossSection section = read(tags, side).section;
    ASSERT_FALSE(section.lanes.empty()) << tags;
    ASSERT_LE(section.lanes.size(), 42u) << tags;
    for (const Lane& lane : section.lanes) {
      ASSERT_GT(lane.width_m, 0) << tags;
      ASSERT_EQ(lane.width_m, snapped(lane.width_m)) << tags;
    }
    ASSERT_GT(carriageway_width_m(section), 0) << tags;
    ASSERT_GE(section.axis_offset_m, 0) << tags;
    ASSERT_LE(section.axis_offset_m, carriageway_width_m(section)) << tags;
    ASSERT_EQ(2 * section.axis_offset_m, snapped(2 * section.axis_offset_m)) << tags;
    ASSERT_EQ(all_of(section), all_of(read(tags, side).section)) << tags;
  }
}

TEST(Lanes, RandomTagsDrivenOnTheOtherSideAreMirrored) {
  RandomTags random(2);
  for (int i = 0; i < 5000 && !HasFailure(); ++i) expect_mirrored(random.draw(true));
}

TEST(Lanes, RandomTagsTurnedRoundAreReversed) {
  RandomTags random(3);
  for (int i = 0; i < 5000 && !HasFailure(); ++i) {
    const Tags tags = random.draw(true);
    if (can_be_turned_round(tags)) expect_turned_round(tags, i % 2 == 0 ? DrivingSide::kRight : DrivingSide::kLeft);
  }
}

// ---- widths, axes, turns, bad values

TEST(Lanes, WithoutTagsOfLanesTheWholeIsAsWideAsTheTrack) {
  const struct {
    const char *key, *value;
    int lanes;
  } classes[] = {
#define TRACK(key, value, surface, width_m, lanes) {key, value, lanes},
#include "compiler/map/lanes/track_rules.inc"
#undef TRACK
  };
  for (const auto& row : classes)
    for (const std::string more : {"", "oneway=yes", "oneway=-1", "oneway=reversible", "junction=roundabout", "lanes=1",
                                   "lanes=1.5", "lanes=3", "lanes=8", "width=2.2", "width=6.3", "width=20"}) {
      if (row.lanes == 0 && more.starts_with("lanes")) continue;
      const std::string tags = std::string(row.key) + "=" + row.value + " " + more;
      const Features features = features_of("w1 0:0 50:0 " + tags);
      ASSERT_EQ(features.tracks.size(), 1u) << tags;
      for (const DrivingSide side : {DrivingSide::kRight, DrivingSide::kLeft}) {
        const CrossSection section = read(tags, side).section;
        EXPECT_EQ(total_width_m(section), carriageway_width_m(features.tracks[0].section)) << tags;
        EXPECT_EQ(section.axis_offset_m, carriageway_width_m(features.tracks[0].section) / 2) << tags;
      }
    }
}

TEST(Lanes, SidesAreToldOnWhichPavementsAreTagged) {
  static const Plane plane(kTestOrigin);
  const auto tagged = [](const std::string& tags, DrivingSide side = DrivingSide::kRight) {
    const source::OsmData osm = extract("w1 0:0 50:0 highway=residential " + tags);
    Report report;
    const ReadContext reading{osm, plane, Box2{}, report};
    return int{tagged_section_of(reading, {OsmType::kWay, 1}, osm.ways[0].tags, side).tagged_pavements};
  };
  EXPECT_EQ(tagged("lit=yes"), 0);
  for (const char* tags : {"sidewalk=no", "sidewalk=left", "sidewalk=separate", "sidewalk:both=no"})
    EXPECT_EQ(tagged(tags), kBothSides) << tags;
  for (const DrivingSide side : {DrivingSide::kRight, DrivingSide::kLeft}) {
    EXPECT_EQ(tagged("sidewalk:left=separate", side), kLeftSide);
    EXPECT_EQ(tagged("sidewalk:right=no", side), kRightSide);
  }
}

TEST(Lanes, SidesAreToldOnWhichTheWidthOfThePavementIsTagged) {
  static const Plane plane(kTestOrigin);
  const auto fixed = [](const std::string& tags) {
    const source::OsmData osm = extract("w1 0:0 50:0 highway=residential " + tags);
    Report report;
    const ReadContext reading{osm, plane, Box2{}, report};
    return int{tagged_section_of(reading, {OsmType::kWay, 1}, osm.ways[0].tags, DrivingSide::kRight).fixed_pavements};
  };
  for (const char* tags : {"lit=yes", "sidewalk=both", "sidewalk=separate", "sidewalk:left=separate"})
    EXPECT_EQ(fixed(tags), 0) << tags;
  EXPECT_EQ(fixed("sidewalk=no"), kBothSides);
  EXPECT_EQ(fixed("sidewalk=left"), kRightSide);
  EXPECT_EQ(fixed("sidewalk=both sidewalk:left:width=1.5"), kLeftSide);
}

TEST(Lanes, AnAddedPavementIsTheOneThatTagsGive) {
  CrossSection silent = read("highway=residential cycleway:right=track").section;
  for (const auto& [sides, tags] : {std::pair{kLeftSide, "sidewalk:left=yes sidewalk:left:width=1.25"},
                                    std::pair{kRightSide, "sidewalk:right=yes sidewalk:right:width=1.25"},
                                    std::pair{kBothSides, "sidewalk=both sidewalk:both:width=1.25"}})
    EXPECT_EQ(with_pavement(silent, sides, 1.25),
              read(std::string("highway=residential cycleway:right=track ") + tags).section);
}

TEST(Lanes, WidthsAndNumbersWithoutTagsAreThoseOfTheRegion) {
  static const Plane plane(kTestOrigin);
  const auto drawn_in = [](RoadGuidelines guidelines, const std::string& tags) {
    const source::OsmData osm = extract("w1 0:0 50:0 " + tags);
    Report report;
    const ReadContext reading{osm, plane, Box2{}, report};
    const CrossSection section =
        tagged_section_of(reading, {OsmType::kWay, 1}, osm.ways[0].tags, DrivingSide::kRight, guidelines).section;
    return std::pair(section.lanes.size(), carriageway_width_m(section));
  };
  EXPECT_EQ(drawn_in(RoadGuidelines::kElsewhere, "highway=residential"), std::pair(2ul, 5.5));
  EXPECT_EQ(drawn_in(RoadGuidelines::kNorthAmerica, "highway=residential"), std::pair(2ul, 6.0));
  EXPECT_EQ(drawn_in(RoadGuidelines::kBritishIsles, "highway=primary"), std::pair(2ul, 7.25));
  EXPECT_EQ(drawn_in(RoadGuidelines::kJapan, "highway=residential"), std::pair(1ul, 4.0));
  EXPECT_EQ(drawn_in(RoadGuidelines::kJapan, "highway=residential lanes=2"), std::pair(2ul, 5.5));
  EXPECT_EQ(drawn_in(RoadGuidelines::kJapan, "highway=residential width=5"), std::pair(1ul, 5.0));
}

TEST(Lanes, AWidthThatIsThatOfTheWholeStreetIsNotUsed) {
  EXPECT_EQ(carriageway_width_m(read("highway=residential lanes=2 width=16").section), 5.5);
  EXPECT_EQ(read("highway=residential lanes=2 width=16").bad_values, 1u);
  EXPECT_EQ(carriageway_width_m(read("highway=residential lanes=2 width=9").section), 9);
  EXPECT_EQ(carriageway_width_m(read("highway=residential width=16").section), 16);
}

TEST(Lanes, WidthIsSharedByTheLanesDownToTheNarrowest) {
  const struct {
    const char *tags, *section;
    double carriageway_m, first_m;
    std::size_t bad_values;
  } cases[] = {
      {"highway=residential width=6", "dd v^", 6, 3, 0},
      {"highway=residential width=4.4", "d -", 4.4, 4.4, 0},
      {"highway=residential width=4.4 lanes=2", "dd v^", 4.4, 2.2, 0},
      {"highway=residential width=3 lanes=2", "dd v^", 3.5, 1.75, 1},
      {"highway=residential width=9 parking:right=lane", "ddp v^^", 9, 3.5, 0},
      {"highway=residential width=8 parking:right=half_on_kerb", "ddp v^^", 9, 3.5, 0},
      {"highway=residential width=7 parking:right=street_side", "ddp v^^", 9, 3.5, 0},
      {"highway=residential width=7 sidewalk=both", "s|dd|s -|v^|-", 7, 2, 0},
      {"highway=residential width=7 parking:both=lane", "pdp v-^", 7, 2, 0},
      {"highway=primary oneway=yes lanes=3 width:lanes=3.5|3|2.5", "ddd ^^^", 9, 3.5, 0},
      {"highway=primary oneway=yes lanes=3 width:lanes=3.5||2.5 width=10", "ddd ^^^", 10, 3.5, 0},
      {"highway=primary est_width=8", "dd v^", 8, 4, 0},
      {"highway=service lanes=2", "dd v^", 5.5, 2.75, 0},
  };
  for (const auto& c : cases) {
    const Read result = read(c.tags);
    EXPECT_EQ(to_string(result.section), c.section) << c.tags;
    EXPECT_NEAR(carriageway_width_m(result.section), c.carriageway_m, 0x1p-10) << c.tags;
    EXPECT_NEAR(result.section.lanes[0].width_m, c.first_m, 0x1p-10) << c.tags;
    EXPECT_EQ(result.bad_values, c.bad_values) << c.tags;
  }
}

TEST(Lanes, TheAxisLiesWherePlacementSays) {
  const struct {
    const char* tags;
    double right_m, left_m;  // by driving side
  } cases[] = {
      // one-way: counted from the left whichever side one drives on
      {"highway=primary oneway=yes lanes=3 placement=left_of:1", 0, 0},
      {"highway=primary oneway=yes lanes=3 placement=middle_of:1", 1.75, 1.75},
      {"highway=primary oneway=yes lanes=3 placement=right_of:2", 7, 7},
      {"highway=primary oneway=-1 lanes=3 placement=right_of:1", 7, 7},
      {"highway=primary oneway=yes lanes=3 placement=transition", 5.25, 5.25},
      {"highway=primary oneway=yes lanes=3 placement=right_of:4", 5.25, 5.25},
      // two-way, with forward lanes right or left of the others
      {"highway=primary lanes=4 placement:forward=left_of:1", 7, 0},
      {"highway=primary lanes=4 placement:forward=right_of:1", 10.5, 3.5},
      {"highway=primary lanes=4 placement:backward=right_of:1", 3.5, 10.5},
      // bays and shoulders do not move it, cars on the carriageway do
      {"highway=primary parking:left=street_side", 5.5, 5.5},
      {"highway=primary parking:left=lane", 4.5, 4.5},
      {"highway=primary parking:left=half_on_kerb", 5, 5},
      {"highway=primary shoulder:left=yes sidewalk=both", 5, 5},
      {"highway=primary shoulder=right", 3.5, 3.5},
  };
  for (const auto& c : cases) {
    EXPECT_EQ(read(c.tags, DrivingSide::kRight).section.axis_offset_m, c.right_m) << c.tags;
    EXPECT_EQ(read(c.tags, DrivingSide::kLeft).section.axis_offset_m, c.left_m) << c.tags;
  }
}

TEST(Lanes, TurnsAreReadAsTheDriverSeesThem) {
  const auto turns = [](const std::string& tags, DrivingSide side) {
    std::vector<unsigned> all;
    for (const Lane& lane : read(tags, side).section.lanes) all.push_back(lane.turns);
    return all;
  };
  const std::string two_way =
      "highway=primary lanes=4 turn:lanes:forward=left|through;right turn:lanes:backward=reverse|";
  EXPECT_EQ(turns(two_way, DrivingSide::kRight),
            (std::vector<unsigned>{0, kTurnReverse, kTurnLeft, kTurnThrough | kTurnRight}));
  EXPECT_EQ(turns(two_way, DrivingSide::kLeft),
            (std::vector<unsigned>{kTurnLeft, kTurnThrough | kTurnRight, 0, kTurnReverse}));
  const std::string one_way = "highway=primary oneway=yes turn:lanes=sharp_left|merge_to_right;slight_left|none";
  for (const DrivingSide side : {DrivingSide::kRight, DrivingSide::kLeft})
    EXPECT_EQ(turns(one_way, side), (std::vector<unsigned>{kTurnSharpLeft, kTurnMergeToRight | kTurnSlightLeft, 0}));
}

TEST(Lanes, ContradictionsAreSettledAsTheHeaderSaysAndDiagnosedOnce) {
  const struct {
    const char *tags, *section, *bad;
  } cases[] = {
      {"highway=primary lanes=3 lanes:forward=2 lanes:backward=2", "dddd vv^^", "lanes=3 "},
      {"highway=primary lanes=2 lanes:forward=2", "ddd v^^", "lanes=2 "},
      {"highway=primary lanes=1 lanes:both_ways=1", "dtd v-^", "lanes=1 "},
      {"highway=primary oneway=yes lanes=3 lanes:forward=2", "dd ^^", "lanes=3 "},
      {"highway=primary oneway=yes lanes=2 turn:lanes=left||", "dd ^^", "lanes=2 "},
      {"highway=primary oneway=yes lanes=2 turn:lanes=left|up", "dd ^^", "turn:lanes=left|up "},
      {"highway=primary oneway=yes lanes=3 bus:lanes=||designated turn:lanes=left|", "ddb ^^^", "turn:lanes=left| "},
      {"highway=primary oneway=yes lanes=2 bicycle:lanes=|designated", "dc ^^", "lanes=2 "},
      {"highway=primary lanes:forward=16 lanes:backward=16", "dd v^", "lanes:forward=16 "},
      {"highway=primary width=wide", "dd v^", "width=wide "},
      {"highway=primary lanes=-3", "dd v^", "lanes=-3 "},
      {"highway=primary lanes=1000", "dd v^", "lanes=1000 "},
      {"highway=primary lanes=many", "dd v^", "lanes=many "},
      {"highway=primary lanes:forward=x", "dd v^", "lanes:forward=x "},
      {"highway=primary est_width=4.6+", "dd v^", "est_width=4.6+ "},
      {"highway=primary placement=left_of:9", "dd v^", "placement=left_of:9 "},
      {"highway=primary cycleway:right=lane cycleway:right:width=wide", "ddc v^^", "cycleway:right:width=wide "},
      {"highway=primary verge=right verge:width=wide", "dd|g v^|-", "verge:width=wide "},
  };
  for (const auto& c : cases) {
    const Read result = read(c.tags);
    EXPECT_EQ(to_string(result.section), c.section) << c.tags;
    EXPECT_EQ(result.bad_values, 1u) << c.tags;
    EXPECT_EQ(bad_tags_of(c.tags), c.bad) << c.tags;
  }
  for (const char* fine : {"highway=primary layer=999 maxspeed=fast", "highway=primary lanes=1;2", "building=yes",
                           "highway=primary lanes=5 lanes:forward=2 lanes:both_ways=1 lanes:backward=2"})
    EXPECT_EQ(read(fine).bad_values, 0u) << fine;
}

TEST(Lanes, BusLanesLeaveALaneToDriveOn) {
  EXPECT_EQ(drawn("highway=primary lanes=4 busway=lane"), "bddb vv^^");
  EXPECT_EQ(drawn("highway=primary lanes=2 busway=lane"), "bddb vv^^");
  EXPECT_EQ(drawn("highway=primary oneway=yes lanes=1 busway=lane"), "db ^^");
  EXPECT_EQ(drawn("highway=primary oneway=yes lanes=1 bus:lanes=designated"), "b ^");
  EXPECT_EQ(drawn("highway=service motor_vehicle=no bus=yes"), "b -");
}

TEST(Lanes, PavementsAreOnlyWhereTagged) {
  for (const char* none : {"", "sidewalk=no", "sidewalk=none", "sidewalk=separate", "sidewalk:both=separate"})
    EXPECT_EQ(drawn(std::string("highway=residential ") + none), "dd v^") << none;
  EXPECT_EQ(drawn("highway=residential sidewalk:left=yes sidewalk:right=separate"), "s|dd -|v^");
  EXPECT_EQ(drawn("highway=residential sidewalk=yes"), "s|dd|s -|v^|-");
}

// No extract at hand has these tags: the ways are invented.
TEST(Lanes, VergesLieBetweenTheKerbAndWhatElseIsRaised) {
  const struct {
    const char *tags, *on_the_right, *on_the_left;
  } cases[] = {
      {"verge=both", "g|dd|g -|v^|-", "g|dd|g -|^v|-"},
      {"verge=yes", "g|dd|g -|v^|-", "g|dd|g -|^v|-"},
      {"verge=left", "g|dd -|v^", "g|dd -|^v"},
      {"verge=right oneway=yes", "d|g ^|-", "d|g ^|-"},
      {"verge=no", "dd v^", "dd ^v"},
      {"verge=separate", "dd v^", "dd ^v"},
      {"verge=both verge:left=no", "dd|g v^|-", "dd|g ^v|-"},
      {"verge:both=yes sidewalk=both", "sg|dd|gs --|v^|--", "sg|dd|gs --|^v|--"},
      {"verge:right=yes sidewalk=left", "s|dd|g -|v^|-", "s|dd|g -|^v|-"},
      {"verge=right cycleway:right=track cycleway:right:buffer=yes sidewalk=right parking:right=street_side",
       "ddp|g/cs v^^|--^-", "ddp|g/cs ^vv|--v-"},
  };
  for (const auto& c : cases) {
    const std::string tags = std::string("highway=tertiary ") + c.tags;
    EXPECT_EQ(drawn(tags, DrivingSide::kRight), c.on_the_right) << tags;
    EXPECT_EQ(drawn(tags, DrivingSide::kLeft), c.on_the_left) << tags;
  }
}

TEST(Lanes, VergesAreAsWideAsTheirSideTells) {
  const struct {
    const char* tags;
    double left_m, right_m;
  } cases[] = {
      {"", 1.5, 1.5},
      {"verge:width=2", 2, 2},
      {"verge:both:width=2 verge:width=5", 2, 2},
      {"verge:left:width=2.5 verge:width=3", 2.5, 3},
      {"verge:right:width=900", 1.5, 1.5},
  };
  for (const auto& c : cases) {
    const CrossSection section = read(std::string("highway=tertiary width=7 verge=both ") + c.tags).section;
    EXPECT_EQ(section.lanes.front().width_m, c.left_m) << c.tags;
    EXPECT_EQ(section.lanes.back().width_m, c.right_m) << c.tags;
    EXPECT_EQ(carriageway_width_m(section), 7) << c.tags;
    EXPECT_EQ(section.axis_offset_m, 3.5) << c.tags;
  }
}

}  // namespace
}  // namespace citykiln::map
