// The citykiln program: passes the command line to its verbs. pipeline.cpp shows what a compile does.
#include <array>
#include <csignal>
#include <vector>

#include "compiler/commands/command_line.h"

int main(int argc, char** argv) {
  using namespace citykiln::commands;
  // makes exceeding the file size limit a write error with a message, instead of ending the process
  std::signal(SIGXFSZ, SIG_IGN);
  const std::array shown = {compile_verb(), bake_verb(), preview_verb(), inspect_verb(), check_verb(),  plan_verb(),
                            gather_verb(),  view_verb(), serve_verb(),   addon_verb(),   invent_verb(), demo_verb()};
  std::vector<Verb> verbs(shown.begin(), shown.end());
  verbs.push_back(man_verb({shown.begin(), shown.end()}));
  verbs.push_back(completion_verb({shown.begin(), shown.end()}));
  return run(verbs, argc, argv);
}
