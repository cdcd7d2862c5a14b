#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace seaway::bridge {

/// What the command line asks for, once parsed; returns the exit status.
using ChosenCommand = std::function<int()>;

/// Adds a subcommand to the application; when it is parsed it sets `chosen`.
using AddCommand = void (*)(CLI::App& app, ChosenCommand& chosen);

/// Parses and runs a command line. Exit status: 0 done, 1 failed, 2 bad input (also a bad command
/// line); messages go to standard error.
int runCommandLine(int argc, const char* const* argv);

}  // namespace seaway::bridge
