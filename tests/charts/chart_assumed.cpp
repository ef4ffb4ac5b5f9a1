// How well assumptions hold: what tags state is left out and assumed again, of whole places and of blocks within them,
// beside simple guesses.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "compiler/lots/courts.h"
#include "compiler/source/read_raster.h"
#include "tests/charts/assumed_values.h"
#include "tests/charts/chart.h"

namespace citykiln::charts {
namespace {

constexpr std::array kSubjects = {
    Subject{"pavements", "", LeftOut::kPavements, true, tagged_pavements, built_pavements},
    Subject{"lit", "", LeftOut::kLamps, true, tagged_lit, built_lit},
    Subject{"lamps", "lamps/km", LeftOut::kLamps, false, tagged_lamps_per_km, built_lamps_per_km},
    Subject{"lamp_spacing", "m", LeftOut::kLamps, false, tagged_lamp_spacings, built_lamp_spacings},
    Subject{"lamp_sides", "", LeftOut::kLamps, true, tagged_lamp_sides, built_lamp_sides},
    Subject{"widths", "m", LeftOut::kWidths, false, tagged_widths, built_widths},
    Subject{"heights", "m", LeftOut::kHeights, false, tagged_heights, built_heights},
    Subject{"storeys", "storeys", LeftOut::kHeights, false, tagged_storeys, built_storeys},
    Subject{"courts", "", LeftOut::kCourts, true, tagged_courts, built_courts},
    Subject{"field_sizes", "ha", LeftOut::kFields, false, tagged_field_sizes, built_field_sizes},
    Subject{"meadow_sizes", "ha", LeftOut::kFields, false, tagged_meadow_sizes, built_field_sizes},
    Subject{"fields", "fields/km²", LeftOut::kFields, false, tagged_fields_per_km2, built_fields_per_km2},
    Subject{"field_borders", "", LeftOut::kFields, true, tagged_field_borders, built_field_borders},
    Subject{"avenues", "", LeftOut::kTrees, true, tagged_avenues, built_avenues},
    Subject{"lane_hedges", "", LeftOut::kHedges, true, tagged_lane_hedges, built_lane_hedges},
    Subject{"frontages", "", LeftOut::kFrontages, true, tagged_frontages, built_frontages}};

constexpr std::array kAllKinds = {LeftOut::kPavements, LeftOut::kLamps,  LeftOut::kWidths,
                                  LeftOut::kHeights,   LeftOut::kCourts, LeftOut::kFields,
                                  LeftOut::kTrees,     LeftOut::kHedges, LeftOut::kFrontages};

/// True for kinds of which an assumption looks at tagged neighbours, so that blocks within a place differ from a place.
bool looks_at_neighbours(LeftOut kind) { return kind < LeftOut::kFields; }

/// Places with fewer values are left out: their scores are chance.
constexpr std::size_t kFewestSamples = 20;

/// A way of guessing.
struct Guess {
  const char* name;
  double Sample::*value;
};
constexpr std::array kGuesses = {Guess{"assumed", &Sample::assumed}, Guess{"nothing assumed", &Sample::unassumed},
                                 Guess{"constant of other places", &Sample::constant},
                                 Guess{"assumed in blocks", &Sample::in_block},
                                 Guess{"mean of neighbours", &Sample::mean}};

/// The elements that have a middle in blocks of a colour.
std::set<OsmId> elements_in_blocks(const map::Features& features, int colour) {
  std::set<OsmId> inside;
  const auto add = [&](OsmId id, Vec2 at) {
    if (block_colour(at) == colour) inside.insert(id);
  };
  for (const map::Track& track : features.tracks) add(track.id.osm, box_of(track.axis).centre());
  for (const map::Footprint& footprint : features.footprints)
    add(footprint.id.osm, box_of(footprint.polygon.outer).centre());
  for (const map::PointFeature& point : features.points) add(point.id.osm, point.at);
  for (const map::AreaFeature& area : features.areas)
    if (lots::is_green_court(area.surface)) add(area.id.osm, box_of(area.polygon.outer).centre());
  return inside;
}

/// The features of a place whose tags of a kind are left out.
struct Guesses {
  map::Features assumed, unassumed;
  std::array<map::Features, 2> blocks;  ///< By the colour of the blocks that are left out.
};

Guesses guesses_of(const Place& place, LeftOut kind) {
  const auto is_anywhere = [](OsmId) { return true; };
  Guesses guesses{
      guessed(place, kind, is_anywhere, kAllAssumptions), guessed(place, kind, is_anywhere, kNoAssumptions), {}};
  if (!looks_at_neighbours(kind)) guesses.blocks = {guesses.assumed, guesses.assumed};
  for (const int colour : {0, 1}) {
    if (!looks_at_neighbours(kind)) break;
    const std::set<OsmId> inside = elements_in_blocks(place.mapped, colour);
    guesses.blocks[static_cast<std::size_t>(colour)] = guessed(
        place, kind, [&](OsmId id) { return inside.contains(id); }, kAllAssumptions);
  }
  return guesses;
}

/// Sets what is built of each sample and drops those of which nothing is built.
void set_built(const Subject& subject, const Guesses& guesses, std::vector<Sample>& samples) {
  const Values assumed = subject.built(guesses.assumed), unassumed = subject.built(guesses.unassumed);
  const std::array blocks = {subject.built(guesses.blocks[0]), subject.built(guesses.blocks[1])};
  const auto value_in = [](const Values& values, const ValueKey& key) {
    const auto found = values.find(key);
    return found == values.end() ? std::nullopt : std::optional(found->second);
  };
  std::vector<Sample> kept;
  for (Sample sample : samples) {
    const auto whole = value_in(assumed, sample.key);
    const auto block = value_in(blocks[static_cast<std::size_t>(block_colour(sample.at))], sample.key);
    if (!whole || !block) continue;
    sample.assumed = *whole, sample.in_block = *block;
    // lamps have no spacing where none are built
    sample.unassumed = value_in(unassumed, sample.key).value_or(0);
    kept.push_back(sample);
  }
  samples = std::move(kept);
}

/// The samples of a subject in all places.
using SamplesOfPlaces = std::vector<std::vector<Sample>>;

/// Returns the samples of each subject. The features of a place are assumed once for each kind of tags.
std::vector<SamplesOfPlaces> all_samples(const std::vector<Place>& places) {
  std::vector<SamplesOfPlaces> all(kSubjects.size(), SamplesOfPlaces(places.size()));
  for (const LeftOut kind : kAllKinds)
    for (std::size_t p = 0; p < places.size(); ++p) {
      std::optional<Guesses> guesses;
      for (std::size_t s = 0; s < kSubjects.size(); ++s) {
        if (kSubjects[s].left_out != kind) continue;
        std::vector<Sample> samples = kSubjects[s].tagged(places[p]);
        if (samples.size() < kFewestSamples) continue;
        if (!guesses) guesses = guesses_of(places[p], kind);
        set_built(kSubjects[s], *guesses, samples);
        all[s][p] = std::move(samples);
      }
    }
  return all;
}

std::string cell_of(const Subject& subject, std::span<const Sample> samples, double Sample::*guess) {
  const Score score = score_of(samples, guess, subject.is_yes_or_no);
  if (subject.is_yes_or_no) return fmt::format(" {:.3f} |", score.half);
  return fmt::format(" {:.2f}, {:.2f} |", score.half, score.tenths);
}

/// The levels of tagged and assumed values: medians; of values of yes and no the share of yes, and the shares of the
/// tagged yes and no that are assumed to be yes.
std::string levels_of(const Subject& subject, std::span<const Sample> samples) {
  if (!subject.is_yes_or_no)
    return fmt::format(" {:.2f} | {:.2f} |", median_of(samples, &Sample::tagged), median_of(samples, &Sample::assumed));
  const YesShares shares = yes_shares_of(samples, &Sample::assumed);
  return fmt::format(" {:.3f} | {:.3f}, {:.3f} |", score_of(samples, &Sample::assumed, true).tenths, shares.of_yes,
                     shares.of_no);
}

/// A row of the table: a place, the number of its values, their levels, and the scores of all guesses.
std::string row_of(const Subject& subject, const std::string& name, std::span<const Sample> samples) {
  std::string row = fmt::format("| {} | {} |", name, samples.size()) + levels_of(subject, samples);
  for (const Guess& guess : kGuesses) row += cell_of(subject, samples, guess.value);
  return row;
}

std::vector<std::string> table_head(const Subject& subject) {
  std::string head = fmt::format("| {} | values |", subject.name), line = "|---|---|---|---|";
  head += subject.is_yes_or_no ? " yes | assumed of yes, of no |" : " median | assumed |";
  for (const Guess& guess : kGuesses) head += fmt::format(" {} |", guess.name), line += "---|";
  return {head, line};
}

/// Points of all places: the score of the simple guess, and that of the assumption.
Series series_of(const Subject& subject, const SamplesOfPlaces& places, const Guess& simple, const Guess& assumed) {
  Series series{fmt::format("{}, {}: places and all together", assumed.name, simple.name), {}, true};
  std::vector<Sample> all;
  const auto add = [&](std::span<const Sample> samples) {
    series.points.emplace_back(score_of(samples, simple.value, subject.is_yes_or_no).half,
                               score_of(samples, assumed.value, subject.is_yes_or_no).half);
  };
  for (const std::vector<Sample>& samples : places) {
    if (!samples.empty()) add(samples);
    all.insert(all.end(), samples.begin(), samples.end());
  }
  add(all);
  return series;
}

double largest_score(const Chart& chart) {
  double largest = 0;
  for (const Series& series : chart.series)
    for (const auto& [x, y] : series.points) largest = std::max({largest, x, y});
  return largest;
}

std::string label_of(const Subject& subject, const char* guess) {
  if (subject.is_yes_or_no) return fmt::format("balanced accuracy of the {}", guess);
  return fmt::format("median error of the {} ({})", guess, subject.unit);
}

Chart subject_chart(const Subject& subject, SamplesOfPlaces& places, const std::vector<Place>& names) {
  set_constants(places, subject.is_yes_or_no);
  for (std::vector<Sample>& samples : places) set_means(samples);
  Chart chart;
  chart.name = fmt::format("assumed_{}", subject.name);
  chart.x = {label_of(subject, "simple guess"), false}, chart.y = {label_of(subject, "assumption"), false};
  chart.notes = table_head(subject);
  std::vector<Sample> all;
  for (std::size_t p = 0; p < places.size(); ++p) {
    if (!places[p].empty()) chart.notes.push_back(row_of(subject, names[p].name, places[p]));
    all.insert(all.end(), places[p].begin(), places[p].end());
  }
  chart.notes.push_back(row_of(subject, "all", all));
  chart.title = fmt::format("{}: {} values left out and assumed again", subject.name, all.size());
  chart.series = {series_of(subject, places, kGuesses[2], kGuesses[0]),
                  series_of(subject, places, kGuesses[4], kGuesses[3])};
  chart.series.push_back({"equal", {{0, 0}, {largest_score(chart), largest_score(chart)}}, false});
  return chart;
}

}  // namespace

Result<std::vector<Chart>> chart_assumed(const ChartRequest& request) {
  if (request.maps.empty()) return Error{"chart assumed", "needs maps (--map FILE)"};
  Report ignored;
  const Result<std::vector<source::Raster>> heightmaps = source::read_heightmaps(request.rasters, nullptr, ignored);
  if (!heightmaps) return heightmaps.error();
  std::vector<Place> places;
  for (const std::string& path : request.maps) {
    Result<Place> place = read_place(path, *heightmaps, request.threads);
    if (!place) return place.error();
    places.push_back(std::move(*place));
  }
  std::vector<SamplesOfPlaces> samples = all_samples(places);
  std::vector<Chart> charts;
  for (std::size_t s = 0; s < kSubjects.size(); ++s) {
    const bool has_any = std::ranges::any_of(samples[s], [](const auto& of_place) { return !of_place.empty(); });
    if (has_any) charts.push_back(subject_chart(kSubjects[s], samples[s], places));
  }
  if (charts.empty()) return Error{"chart assumed", "found no map with at least 20 tags of a kind"};
  return charts;
}

}  // namespace citykiln::charts
