#pragma once

#include <string>

namespace seaway::bridge {

/// A door through which others ask a served sea. It takes its address when made, so that a port in
/// use is known before anything is served.
class Endpoint {
 public:
  virtual ~Endpoint() = default;

  /// For the line that a service prints when it starts: what it speaks, and where.
  virtual std::string description() const = 0;

  /// Serves from now on, on threads of its own; once.
  virtual void start() = 0;

  /// Answers what has arrived and ends; returns when nothing of it runs any more. Again: nothing.
  virtual void stop() = 0;
};

}  // namespace seaway::bridge
