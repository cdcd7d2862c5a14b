#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "sim_bridge/service/socket_address.h"

namespace seaway::bridge::test {

/// `seaway serve` as a child, from the line of its last endpoint on.
class ServedChild {
 public:
  ServedChild(const std::string& scene, std::vector<std::string> options, int endpoints = 1) {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    options.insert(options.begin(), {SEAWAY_COMMAND, "serve", scene});
    std::vector<char*> arguments;
    for (std::string& option : options) arguments.push_back(option.data());
    arguments.push_back(nullptr);
    child_ = fork();
    if (child_ == 0) {
      dup2(ends[1], STDERR_FILENO);
      close(ends[0]);
      close(ends[1]);
      execv(SEAWAY_COMMAND, arguments.data());
      _exit(99);
    }
    close(ends[1]);
    errors_ = ends[0];
    for (int i = 0; i < endpoints; ++i) awaitText(" serves ");
  }
  ~ServedChild() {
    if (child_ > 0) end(SIGKILL);
    close(errors_);
  }

  /// The address that follows a word in its lines: "udp ", "http://".
  SocketAddress address(const std::string& after) const {
    const std::size_t at = text_.find(after + "127.0.0.1:");
    EXPECT_NE(at, std::string::npos) << text_;
    if (at == std::string::npos) return {};
    const std::size_t port = text_.find(':', at + after.size()) + 1;
    return {"127.0.0.1", static_cast<std::uint16_t>(std::stoi(text_.substr(port)))};
  }
  void send(int signal) const { kill(child_, signal); }
  /// Its status; what ended it, negative, for a signal.
  int end(int signal) {
    kill(child_, signal);
    awaitText("");
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  /// Reads on until a word has come that was not read before, or, for none, to the end.
  void awaitText(const std::string& word) {
    char part[512];
    while (true) {
      const std::size_t found = word.empty() ? std::string::npos : text_.find(word, read_);
      if (found != std::string::npos) {
        read_ = found + word.size();
        return;
      }
      const ssize_t size = read(errors_, part, sizeof part);
      if (size <= 0) return;
      text_.append(part, static_cast<std::size_t>(size));
    }
  }
  const std::string& text() const { return text_; }

 private:
  pid_t child_ = 0;
  int errors_ = -1;
  std::string text_;
  std::size_t read_ = 0;
};

}  // namespace seaway::bridge::test
