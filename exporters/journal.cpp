#include "exporters/journal.h"

#include <nlohmann/json.hpp>

#include "compiler/contract/parse.h"

namespace citykiln::exporters {

using OrderedJson = nlohmann::ordered_json;

std::string journal_line(const StagedFile& staged) {
  const OrderedJson json = {{"name", staged.file.name},
                            {"bytes", staged.file.bytes},
                            {"hash", staged.file.hash},
                            {"key", staged.key},
                            {"note", staged.note}};
  return json.dump() + "\n";
}

std::map<std::string, StagedFile> read_journal(const std::string& text) {
  std::map<std::string, StagedFile> files;
  for (const std::string_view line : split(text, '\n')) {
    try {
      const OrderedJson json = OrderedJson::parse(line);
      const std::string name = json.at("name");
      files[name] = {{name, json.at("bytes"), json.at("hash")}, json.at("key"), json.at("note")};
    } catch (const nlohmann::json::exception&) {
      // a torn line
    }
  }
  return files;
}

}  // namespace citykiln::exporters
