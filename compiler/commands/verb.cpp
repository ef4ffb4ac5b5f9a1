#include "compiler/commands/verb.h"

#include "compiler/spec.h"

namespace citykiln::commands {

std::function<Result<Done>(const std::string&)> store_text(std::string& text) {
  return [&text](const std::string& given) -> Result<Done> {
    text = given;
    return Done{};
  };
}

std::function<Result<Done>(const std::string&)> append_text(std::vector<std::string>& texts) {
  return [&texts](const std::string& given) -> Result<Done> {
    texts.push_back(given);
    return Done{};
  };
}

std::function<Result<Done>(const std::string&)> store_whole(int& number, int least) {
  return [&number, least](const std::string& text) -> Result<Done> {
    const Result<std::int64_t> whole = parse_whole(text, least);
    if (!whole) return whole.error();
    number = static_cast<int>(*whole);
    return Done{};
  };
}

Option threads_option(int& threads) {
  return {"--threads", "N", "number of threads; 0 uses all processors (default: 0)", false, store_whole(threads, 0)};
}

}  // namespace citykiln::commands
