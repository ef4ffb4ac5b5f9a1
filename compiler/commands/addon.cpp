// citykiln addon PROGRAM -o FILE.zip: writes the add-on with which another program imports runs.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "compiler/commands/verb.h"
#include "exporters/blender/addon_zip.h"
#include "exporters/file.h"

namespace citykiln::commands {
namespace {

struct AddonRequest {
  std::string program, out_path;
};

Result<Exit> write_addon(const AddonRequest& request, const Console& console) {
  if (request.program != "blender")
    return Error{"", request.program.empty() ? "no program is given; expected blender"
                                             : "there is no add-on for " + request.program + "; expected blender"};
  if (!request.out_path.ends_with(".zip"))
    return Error{request.out_path, "no zip file is given; add -o FILE.zip, such as -o citykiln.zip"};
  const Result<std::vector<std::byte>> zip = exporters::blender_addon_zip();
  if (!zip) return zip.error();
  if (const Result<Done> done = exporters::write_file(request.out_path, *zip); !done) return done.error();
  console.print_line(
      fmt::format("{}: {} bytes; in Blender: Edit > Preferences > Add-ons > Install, then enable citykiln",
                  request.out_path, zip->size()));
  console.print_json(nlohmann::json{{"file", request.out_path}, {"bytes", zip->size()}}.dump());
  return Exit::kDone;
}

}  // namespace

Verb addon_verb() {
  const auto request = std::make_shared<AddonRequest>();
  Verb verb{"addon", "writes the add-on with which Blender imports runs and compiles maps", {}, {}};
  verb.options = {
      {"program", "blender", "the program that the add-on is for", false, store_text(request->program)},
      {"-o,--out", "FILE.zip", "the add-on, as the program installs it", false, store_text(request->out_path)}};
  verb.examples = {"citykiln addon blender -o citykiln.zip"};
  verb.run = [request](const Console& console) { return write_addon(*request, console); };
  return verb;
}

}  // namespace citykiln::commands
