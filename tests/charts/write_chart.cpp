#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdio>
#include <filesystem>
#include <iterator>

#include "exporters/file.h"
#include "exporters/output_folder.h"
#include "tests/charts/chart.h"

namespace citykiln::charts {
namespace {

std::string csv_of(const Chart& chart) {
  std::string csv = fmt::format("series,{},{}\n", chart.x.label, chart.y.label);
  for (const Series& series : chart.series) {
    for (const auto& [x, y] : series.points) fmt::format_to(std::back_inserter(csv), "{},{},{}\n", series.name, x, y);
  }
  return csv;
}

/// The text as gnuplot quotes it.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? "''" : std::string(1, c);
  return out + "'";
}

using Point = std::pair<double, double>;

/// True if an axis is drawn logarithmic, for which gnuplot needs a value above 0.
bool is_logarithmic(const Chart& chart, const Axis& axis, double Point::*value) {
  const auto has_positive = [&](const Series& series) {
    return std::ranges::any_of(series.points, [&](const Point& point) { return point.*value > 0; });
  };
  return axis.is_logarithmic && std::ranges::any_of(chart.series, has_positive);
}

/// Data are inline blocks, so that only the picture is written.
std::string gnuplot_script(const Chart& chart, const std::string& svg_path) {
  std::string script = fmt::format(
      "set terminal svg size 900,560 font 'Helvetica,14' background '#ffffff'\nset output {}\nset title {}\nset xlabel "
      "{}\nset ylabel {}\n"
      "set grid lc rgb '#dddddd'\nset key outside bottom center maxcols 2\nset border 3\nset tics nomirror\nset "
      "datafile separator ','\n",
      quoted(svg_path), quoted(chart.title), quoted(chart.x.label), quoted(chart.y.label));
  if (is_logarithmic(chart, chart.x, &Point::first)) script += "set logscale x\n";
  if (is_logarithmic(chart, chart.y, &Point::second)) script += "set logscale y\nset format y '%g'\n";
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    fmt::format_to(std::back_inserter(script), "$s{} << EOD\n", i);
    for (const auto& [x, y] : chart.series[i].points) fmt::format_to(std::back_inserter(script), "{},{}\n", x, y);
    script += "EOD\n";
  }
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const char* style = chart.series[i].is_reference ? "points pt 6 ps 1.2" : "linespoints pt 7 ps 0.6 lw 2";
    fmt::format_to(std::back_inserter(script), "{} $s{} using 1:2 with {} title {} noenhanced", i == 0 ? "plot" : ",",
                   i, style, quoted(chart.series[i].name));
  }
  return script + "\n";
}

Result<Done> draw(const Chart& chart, const std::string& svg_path) {
  // written beside the final path, then renamed, so that no partial file remains
  const std::string beside = svg_path + ".part";
  std::FILE* gnuplot = popen("gnuplot 2>/dev/null", "w");
  if (gnuplot == nullptr) return Error{"gnuplot", "cannot be started"};
  const std::string script = gnuplot_script(chart, beside);
  std::fwrite(script.data(), 1, script.size(), gnuplot);
  const int status = pclose(gnuplot);

  std::error_code problem;
  if (status == 0) std::filesystem::rename(beside, svg_path, problem);
  if (status == 0 && !problem) return Done{};
  std::filesystem::remove(beside, problem);
  return Error{svg_path, "cannot be drawn; is gnuplot installed (apt-get install gnuplot-nox)?"};
}

}  // namespace

Result<Done> write_chart(const Chart& chart, const std::string& folder) {
  assert(!chart.name.empty());
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  const std::string path = folder + "/" + chart.name;
  if (Result<Done> csv = exporters::write_file(path + ".csv", exporters::bytes_of(csv_of(chart))); !csv) return csv;
  return draw(chart, path + ".svg");
}

}  // namespace citykiln::charts
