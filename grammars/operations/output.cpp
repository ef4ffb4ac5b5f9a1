// Operations that return values to the caller or tell the derivation about a shape: report, print, details.
#include "grammars/operations/operations.h"

namespace citykiln::grammars {

void op_report(Execution& execution, const Statement&, Arguments arguments) {
  Run& run = execution.run;
  // the limit of shapes is also that of reports
  if (run.out.reports.size() > run.options.limits.shapes) return;
  run.out.reports.push_back({text_of(arguments[0].value), arguments[1].value, {}});
  run.report_nodes.push_back(execution.shape.node);
}

void op_details(Execution& execution, const Statement&, Arguments) { execution.shape.leaves_out_details = true; }

void op_print(Execution& execution, const Statement&, Arguments arguments) {
  execution.run.depends_on(0);
  constexpr std::size_t kMostLines = 10'000;
  if (execution.run.out.printed.size() >= kMostLines) return;
  std::string line;
  for (const Argument& argument : arguments) line.append(line.empty() ? "" : " ").append(text_of(argument.value));
  execution.run.out.printed.push_back(std::move(line));
}

}  // namespace citykiln::grammars
