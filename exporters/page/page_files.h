// The files of the page, which are part of the program: index.html, the bundle, its style, Draco's decoder and
// licences.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace citykiln::exporters {

/// A file of the page.
struct PageFile {
  std::string name;  ///< Relative to the folder of the run.
  std::span<const std::byte> bytes;
};

/// Returns the files of the page. They are the same for every run; viewer/build.mjs makes them.
std::vector<PageFile> page_files();

}  // namespace citykiln::exporters
