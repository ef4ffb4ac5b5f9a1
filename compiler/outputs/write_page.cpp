#include "compiler/outputs/write_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "compiler/contract/system/for_each_slot.h"
#include "compiler/geometry/trig.h"
#include "compiler/outputs/page_records.h"
#include "compiler/sky/generate.h"
#include "compiler/sky/plan.h"
#include "exporters/page/page_files.h"
#include "exporters/page/page_json.h"
#include "exporters/run_files.h"

namespace citykiln::outputs {
namespace {

using exporters::PageRgb;
using exporters::PageSky;
using exporters::PageSkyTable;
constexpr std::size_t kColumns = 48, kRows = 24;
constexpr int kHours = 3, kDayHours = 24;

// Colours outside of the gamut have negative components, which a page cannot show.
PageRgb shown(const sky::Rgb& rgb) { return {std::max(rgb[0], 0.0), std::max(rgb[1], 0.0), std::max(rgb[2], 0.0)}; }

PageRgb shown(const sky::Rgb& rgb, double factor) { return shown({rgb[0] * factor, rgb[1] * factor, rgb[2] * factor}); }

std::vector<PageRgb> radiance_table(const sky::SkyModel& model) {
  std::vector<PageRgb> table;
  for (std::size_t row = 0; row < kRows; ++row) {
    const double share = static_cast<double>(row) / (kRows - 1), z = share * share, flat = std::sqrt(1 - z * z);
    for (std::size_t column = 0; column < kColumns; ++column) {
      const double turn = 2 * kPi * (static_cast<double>(column) + 0.5) / kColumns;
      table.push_back(shown(sky::radiance(model, {flat * std::cos(turn), flat * std::sin(turn), z})));
    }
  }
  return table;
}

// Cost: 0.4 s.
PageSkyTable sky_table(const sky::Sky& sky) {
  const sky::SkyModel model = sky::generate(sky, sky.ground_m);
  const double solid_angle_sr = 2 * kPi * (1 - model.sun_cos_radius);
  return {.to_light = model.to_sun,
          .light = shown(model.sun_radiance, model.to_sun.z > 0 ? solid_angle_sr : 0),
          .disk = shown(model.sun_radiance),
          .white_ground = shown(model.white_ground),
          .ground = shown(sky::ground_radiance(model)),
          .columns = kColumns,
          .rows = kRows,
          .radiance = radiance_table(model)};
}

std::chrono::sys_days date_of(const sky::Moment& time) { return std::chrono::floor<std::chrono::days>(time.at); }

// Hours since midnight, of the solar time at a longitude.
double solar_hours(const sky::Moment& time, double lon_deg) {
  const auto minutes = std::chrono::floor<std::chrono::minutes>(time.at - date_of(time)).count();
  const double utc = static_cast<double>(minutes / 60) + static_cast<double>(minutes % 60) / 60;
  return std::fmod(utc + lon_deg / 15 + 2 * kDayHours, kDayHours);
}

std::string label_of(double hours) {
  const int minutes = static_cast<int>(std::lround(hours * 60)) % (kDayHours * 60);
  return fmt::format("{:02}:{:02} solar time", minutes / 60, minutes % 60);
}

// The sky of the run at another hour of its date.
sky::Sky sky_at(const scene::Header& header, const sky::Moment& time, int solar_hour) {
  const double utc = std::fmod(solar_hour - header.origin.lon_deg / 15 + 2 * kDayHours, kDayHours);
  const int minutes = static_cast<int>(std::lround(utc * 60)) % (kDayHours * 60);
  sky::Sky sky = sky::plan(header.origin, sky::moment_of(date_of(time), minutes, sky::kEndingZ));
  sky.turbidity = header.sky.turbidity, sky.visibility_km = header.sky.visibility_km;
  sky.ground_albedo = header.sky.ground_albedo, sky.ground_m = header.sky.ground_m;
  return sky;
}

std::string sky_name(std::size_t number) { return fmt::format("{}{}.json", exporters::kPageSkyFolder, number); }

/// A sky that the page offers.
struct Hour {
  sky::Sky sky;
  double hours;
  bool is_of_run;
};

std::vector<Hour> hours_of(const scene::Header& header) {
  const sky::Moment time = header.sky.time.value_or(sky::Moment{});
  std::vector<Hour> hours = {{header.sky, solar_hours(time, header.origin.lon_deg), true}};
  for (int hour = 0; hour < kDayHours; hour += kHours)
    hours.push_back({sky_at(header, time, hour), double(hour), false});
  std::ranges::stable_sort(hours, {}, &Hour::hours);
  return hours;
}

// The skies in page.json: that of the run, and one every three hours of local mean solar time on its date, with the
// same air; in the order of the day.
std::vector<PageSky> page_skies(const scene::Header& header, const std::vector<Hour>& hours) {
  std::vector<PageSky> skies;
  for (std::size_t i = 0; i < hours.size(); ++i)
    skies.push_back({.time = sky::text_of(hours[i].sky.time),
                     .label = label_of(hours[i].hours),
                     .is_of_run = hours[i].is_of_run,
                     .are_lamps_lit = scene::are_lamps_lit(header.shown, hours[i].sky),
                     .file = sky_name(i)});
  return skies;
}

/// The name of the map without its ending: "town" of "town.osm.pbf".
std::string title_of(const scene::Header& header) {
  if (header.sources.empty()) return "citykiln";
  const std::string& source = header.sources.front();
  return source.substr(0, source.find('.'));
}

exporters::PageFacts facts_of(const scene::Scene& scene, const Outputs& outputs, const map::Geoid& geoid,
                              const std::vector<Hour>& hours) {
  const scene::Header& header = scene.header;
  const auto keeps_tags = [](const scene::Chunk& chunk) {
    return std::ranges::any_of(chunk.texts, [](const map::ElementText& text) { return !text.tags.empty(); });
  };
  return {.title = title_of(header),
          .attributions = header.attributions,
          .levels_m = outputs.tolerances_m,
          .region_m = header.extent,
          .ground_m = header.sky.ground_m + map::height_m(geoid, header.extent.centre()),
          .visibility_km = header.sky.visibility_km,
          .lights = outputs.lights,
          .has_tags = std::ranges::any_of(scene.chunks, keeps_tags),
          .skies = page_skies(header, hours)};
}

/// The data that several files of the page share. Texts of records are made once, when the first is asked for.
class PageData {
 public:
  PageData(const scene::Scene& scene, const Outputs& outputs, const map::Geoid& geoid)
      : scene_(scene),
        outputs_(outputs),
        geoid_(geoid),
        hours_(hours_of(scene.header)),
        records_(page_records(scene, geoid)) {}

  std::size_t skies() const { return hours_.size(); }
  std::string sky(std::size_t number) const { return exporters::sky_json(sky_table(hours_[number].sky)); }

  std::string page() const {
    exporters::PageFacts facts = facts_of(scene_, outputs_, geoid_, hours_);
    facts.feature_files = feature_files();
    return exporters::page_json(facts, records_);
  }

  std::string names() const { return exporters::names_json(records_); }

  std::size_t feature_files() const { return exporters::feature_file_count(records_); }
  std::string features(std::size_t number) const {
    std::call_once(texts_once_, [&] { texts_ = exporters::feature_files(records_, feature_files()); });
    return texts_[number];
  }

 private:
  const scene::Scene& scene_;
  Outputs outputs_;
  const map::Geoid& geoid_;
  std::vector<Hour> hours_;
  exporters::FeatureRecords records_;
  mutable std::once_flag texts_once_;
  mutable std::vector<std::string> texts_;
};

std::string text_in(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

std::vector<PageContent> page_contents(const scene::Scene& scene, const Outputs& outputs, const map::Geoid& geoid) {
  const auto data = std::make_shared<const PageData>(scene, outputs, geoid);
  std::vector<PageContent> files;
  for (const exporters::PageFile& file : exporters::page_files())
    files.push_back({file.name, [bytes = file.bytes] { return text_in(bytes); }});
  files.push_back({exporters::kPageName, [data] { return data->page(); }});
  for (std::size_t i = 0; i < data->skies(); ++i) files.push_back({sky_name(i), [data, i] { return data->sky(i); }});
  for (std::size_t i = 0; i < data->feature_files(); ++i)
    files.push_back(
        {fmt::format("{}{}.json", exporters::kPageFeatureFolder, i), [data, i] { return data->features(i); }});
  files.push_back({exporters::kPageNamesName, [data] { return data->names(); }});
  return files;
}

Result<std::vector<WrittenFile>> write_page(const scene::Scene& scene, const Outputs& outputs, const map::Geoid& geoid,
                                            int threads, exporters::OutputFolder& folder) {
  const std::vector<PageContent> contents = page_contents(scene, outputs, geoid);
  const std::vector<std::string> texts =
      for_each_slot<std::string>(contents.size(), threads, [&](std::size_t i) { return contents[i].make(); });
  std::vector<WrittenFile> files;
  for (std::size_t i = 0; i < contents.size(); ++i) {
    if (const Result<Done> done = folder.write(contents[i].name, exporters::bytes_of(texts[i])); !done)
      return done.error();
    files.push_back({contents[i].name, texts[i].size()});
  }
  return files;
}

}  // namespace citykiln::outputs
