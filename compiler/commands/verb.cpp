#include "compiler/commands/verb.h"

namespace citykiln::commands {

std::function<Result<Done>(const std::string&)> into(std::string& text) {
  return [&text](const std::string& given) -> Result<Done> {
    text = given;
    return Done{};
  };
}

std::function<Result<Done>(const std::string&)> onto(std::vector<std::string>& texts) {
  return [&texts](const std::string& given) -> Result<Done> {
    texts.push_back(given);
    return Done{};
  };
}

}  // namespace citykiln::commands
