#pragma once
// SIGINT and SIGTERM end the program with exit code 130, and take unfinished output files and
// the progress bar with them.

#include <csignal>
#include <string>

namespace steadyslide::app {

/// Call once, first thing in main(). Also makes a closed pipe an error of write() instead of a silent death.
void handle_signals();

/// While it lives, the two signals wait; one may live within another.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_;
};

/// A file to remove on a signal, one of at most four at a time; no longer so. Call with signals held.
void remove_when_interrupted(const std::string& file);
void keep_when_interrupted(const std::string& file);

/// Does a signal clear the line that the terminal on stderr is in?
void erase_line_when_interrupted(bool erase);

}  // namespace steadyslide::app
