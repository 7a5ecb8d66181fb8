#pragma once
// SIGINT and SIGTERM end the program with exit code 130. They remove unfinished output files and clear the progress
// bar.

#include <csignal>
#include <string>

namespace steadyslide::app {

/// Call it once, at the beginning of main(). Also turns a closed pipe into an error of write(), instead of a silent end
/// of the program.
void handle_signals();

/// Holds the two signals back during its lifetime. Objects may be nested.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_;
};

/// Holds the terminal during its lifetime: a signal, which may end the program from another thread, waits. Not nested.
class TerminalHeld {
 public:
  TerminalHeld();
  ~TerminalHeld();
  TerminalHeld(const TerminalHeld&) = delete;
  TerminalHeld& operator=(const TerminalHeld&) = delete;

 private:
  SignalsHeld signals_;  // of this thread, so that its handler does not wait for itself
};

/// Register a file that a signal removes, at most four at a time, and cancel the registration. Call with signals held.
void remove_when_interrupted(const std::string& file);
void keep_when_interrupted(const std::string& file);

/// Chooses whether a signal clears the current line of the terminal on stderr.
void erase_line_when_interrupted(bool erase);

}  // namespace steadyslide::app
