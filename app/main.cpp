#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "app/commands/command_line.hpp"
#include "app/commands/exponents_command.hpp"
#include "app/commands/figures_command.hpp"
#include "app/commands/report_command.hpp"
#include "app/commands/solve_command.hpp"
#include "app/commands/table_command.hpp"
#include "app/commands/verify_command.hpp"
#include "app/terminal/interrupt.hpp"
#include "app/terminal/output.hpp"

namespace steadyslide::app {
namespace {

ExitCode run(const Message& message) {
  Output output(std::nullopt);
  output.write(message.text);
  output.commit();
  return ExitCode::done;
}

ExitCode end_with(ExitCode code, const char* message) {
  fmt::print(stderr, "steadyslide: {}\n", one_line(message));
  return code;
}

ExitCode run_program(int argc, const char* const* argv) {
  try {
    return std::visit([](const auto& command) { return run(command); }, parse_command_line(argc, argv));
  } catch (const Failure& failure) {
    return end_with(failure.code(), failure.what());
  } catch (const std::bad_alloc&) {
    return end_with(ExitCode::failed, "out of memory");
  } catch (const std::exception& error) {
    return end_with(ExitCode::failed, fmt::format("internal failure: {}", error.what()).c_str());
  }
}

}  // namespace
}  // namespace steadyslide::app

int main(int argc, char** argv) {
  steadyslide::app::handle_signals();
  return static_cast<int>(steadyslide::app::run_program(argc, argv));
}
