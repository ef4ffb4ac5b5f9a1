#include "compiler/outputs/write_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

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

PageSky page_sky(const scene::Shown& shown_lights, const sky::Sky& sky, std::string label, bool is_of_run) {
  const sky::SkyModel model = sky::generate(sky, sky.ground_m);
  const double solid_angle_sr = 2 * kPi * (1 - model.sun_cos_radius);
  return {.time = sky::text_of(sky.time),
          .label = std::move(label),
          .is_of_run = is_of_run,
          .are_lamps_lit = scene::are_lamps_lit(shown_lights, sky),
          .to_light = model.to_sun,
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

// Returns the sky of the run, and skies every three hours of local mean solar time on its date, with the same air; in
// the order of the day. Cost: 0.4 s each, in parallel.
std::vector<PageSky> page_skies(const scene::Header& header, int threads) {
  const std::vector<Hour> hours = hours_of(header);
  return for_each_slot<PageSky>(hours.size(), threads, [&](std::size_t i) {
    return page_sky(header.shown, hours[i].sky, label_of(hours[i].hours), hours[i].is_of_run);
  });
}

/// The name of the map without its ending: "town" of "town.osm.pbf".
std::string title_of(const scene::Header& header) {
  if (header.sources.empty()) return "citykiln";
  const std::string& source = header.sources.front();
  return source.substr(0, source.find('.'));
}

exporters::PageFacts facts_of(const scene::Scene& scene, const Outputs& outputs, const map::Geoid& geoid, int threads) {
  const scene::Header& header = scene.header;
  const auto keeps_tags = [](const scene::Chunk& chunk) {
    return std::ranges::any_of(chunk.texts, [](const map::ElementText& text) { return !text.tags.empty(); });
  };
  return {.title = title_of(header),
          .attributions = header.attributions,
          .levels_m = outputs.tolerances_m,
          .region_m = header.extent,
          .ground_m = header.sky.ground_m + map::height_m(geoid, header.extent.centre()),
          .lights = outputs.lights,
          .has_tags = std::ranges::any_of(scene.chunks, keeps_tags),
          .skies = page_skies(header, threads)};
}

class PageWriter {
 public:
  explicit PageWriter(exporters::OutputFolder& folder) : folder_(folder) {}

  Result<Done> write(const std::string& name, std::span<const std::byte> bytes) {
    if (const Result<Done> done = folder_.write(name, bytes); !done) return done;
    files.push_back({name, bytes.size()});
    return Done{};
  }
  Result<Done> write(const std::string& name, const std::string& text) {
    return write(name, exporters::bytes_of(text));
  }

  Result<Done> write_program_files() {
    for (const exporters::PageFile& file : exporters::page_files())
      if (const Result<Done> done = write(file.name, file.bytes); !done) return done;
    return Done{};
  }

  Result<Done> write_records(const exporters::FeatureRecords& records) {
    const std::vector<std::string> texts = exporters::feature_files(records, exporters::feature_file_count(records));
    for (std::size_t i = 0; i < texts.size(); ++i)
      if (const auto done = write(fmt::format("{}{}.json", exporters::kPageFeatureFolder, i), texts[i]); !done)
        return done;
    return write(exporters::kPageNamesName, exporters::names_json(records));
  }

  std::vector<WrittenFile> files;

 private:
  exporters::OutputFolder& folder_;
};

}  // namespace

Result<std::vector<WrittenFile>> write_page(const scene::Scene& scene, const Outputs& outputs, const map::Geoid& geoid,
                                            int threads, exporters::OutputFolder& folder) {
  const exporters::FeatureRecords records = page_records(scene, geoid);
  exporters::PageFacts facts = facts_of(scene, outputs, geoid, threads);
  facts.feature_files = exporters::feature_file_count(records);
  PageWriter writer(folder);
  if (const Result<Done> done = writer.write_program_files(); !done) return done.error();
  if (const Result<Done> done = writer.write(exporters::kPageName, exporters::page_json(facts, records)); !done)
    return done.error();
  if (const Result<Done> done = writer.write_records(records); !done) return done.error();
  return std::move(writer.files);
}

}  // namespace citykiln::outputs
