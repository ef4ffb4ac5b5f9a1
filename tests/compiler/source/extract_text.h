// Test fixtures: extracts written as text, and OsmData printed for comparison.
#pragma once

#include <string>
#include <string_view>

#include "compiler/source/read_osm.h"
#include "tests/scratch_folder.h"

namespace citykiln::source {

/// An .osm document around the elements.
std::string osm(std::string_view elements);

/// Returns all bytes of a file.
std::string bytes_of(const std::string& path);

/// Returns a text of all of `data` but the file's name, one line for each element: equal texts mean equal data.
std::string text_of(const OsmData& data);

/// Reads an .osm document of these elements; fails the test on an error.
OsmData read(std::string_view elements, Report& report, int threads = 1);

/// The sum of the sizes of all diagnoses of a code.
double size_sum(const Report& report, Code code);

}  // namespace citykiln::source
