#include "exporters/page/page_files.h"

#include "exporters/run_files.h"

// CMakeLists.txt tells the assembler where the source tree begins, and which files this source depends on.
#define CITYKILN_PAGE_FILE(symbol, name)                                                                    \
  __asm__(".section .rodata\n.balign 16\n" #symbol ":\n.incbin \"exporters/page/files/" name "\"\n" #symbol \
          "_end:\n.byte 0\n.previous\n");                                                                   \
  extern "C" const std::byte symbol[], symbol##_end[];

CITYKILN_PAGE_FILE(citykiln_page_index, "index.html")
CITYKILN_PAGE_FILE(citykiln_page_viewer, "viewer.js")
CITYKILN_PAGE_FILE(citykiln_page_style, "style.css")
CITYKILN_PAGE_FILE(citykiln_page_licences, "licences.txt")
CITYKILN_PAGE_FILE(citykiln_page_draco_wasm, "draco_decoder.wasm")
CITYKILN_PAGE_FILE(citykiln_page_draco_js, "draco_wasm_wrapper.js")

namespace citykiln::exporters {
namespace {

PageFile file_of(const char* name, const std::byte* begin, const std::byte* end) {
  return {std::string(kPageFolder) + "/" + name, {begin, end}};
}

}  // namespace

std::vector<PageFile> page_files() {
  return {{kPageIndexName, {citykiln_page_index, citykiln_page_index_end}},
          file_of("viewer.js", citykiln_page_viewer, citykiln_page_viewer_end),
          file_of("style.css", citykiln_page_style, citykiln_page_style_end),
          file_of("licences.txt", citykiln_page_licences, citykiln_page_licences_end),
          file_of("draco_decoder.wasm", citykiln_page_draco_wasm, citykiln_page_draco_wasm_end),
          file_of("draco_wasm_wrapper.js", citykiln_page_draco_js, citykiln_page_draco_js_end)};
}

}  // namespace citykiln::exporters
