#pragma once

#include <grpcpp/alarm.h>
#include <grpcpp/server_context.h>
#include <grpcpp/support/byte_buffer.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "sim_bridge/grpc/call_host.h"
#include "sim_bridge/grpc/call_watch.h"
#include "sim_bridge/grpc/message_codec.h"

namespace seaway::bridge::rpc {

/// What an answerer has done about a request.
struct Outcome {
  std::size_t points = 0;              ///< sampled, for the meter
  bool frame = false;                  ///< a picture was drawn
  std::size_t refused = 0;             ///< parts of the request that the answer says no to
  std::chrono::milliseconds again{0};  ///< where not 0, no answer yet: ask again so much later
};

/// A step of a call: what is done when the completion queue brings it back.
template <class Call, void (Call::*step)(bool)>
class Step : public Arrival {
 public:
  explicit Step(Call& call) : call_(&call) {}
  void arrived(bool ok) override { (call_->*step)(ok); }

 private:
  Call* call_;
};

/// One request at a time of one call, and then of the next call: a slot, its messages and its
/// answerer are used again.
///
/// An `Answerer` has
///   Request, Response                                      messages
///   Lane lane(const Request&)                              where it is answered
///   Outcome answer(const Request&, Response&, const CallWatch&)   throws what faultOf knows
///   void ended()                                           the call is over; all of it may go
///   static bool read(grpc::ByteBuffer&, Request&), where it has that, in place of readMessage
///   isForAnybody, where it has that                        needs no token, counts on no meter
/// and is used by one thread at a time.
///
/// The call itself is in `Derived`, which has sendAnswer() and sendRefusal(status). Two events end
/// a call, in either order: its status was sent, and gRPC has done with it.
template <class Derived, class Answerer>
class CallSlot {
 public:
  using Request = typename Answerer::Request;
  using Response = typename Answerer::Response;

  CallSlot(CallHost& host, Answerer answerer) : host_(host), answerer_(std::move(answerer)) {}
  CallSlot(const CallSlot&) = delete;
  CallSlot& operator=(const CallSlot&) = delete;

  /// Whether the slot holds so much memory that it is better not kept.
  bool isBloated() const { return bloated_; }

 protected:
  /// A context for the next call, whose steps come back through `queue`.
  grpc::ServerContext& renew(grpc::ServerCompletionQueue* queue) {
    queue_ = queue;
    // `done` may come before the call has been looked at.
    left_ = 2;
    watch_.renew();
    context_.emplace();
    context_->AsyncNotifyWhenDone(&done_);
    host_.slotOpens();
    return *context_;
  }
  /// Nothing came: the server is ending.
  void neverBegan() { host_.slotCloses(); }

  /// A call has come. False, and the refusal is sent, where it lacks the token.
  bool begins() {
    watch_.setDeadline(context_->deadline());
    begun_ = std::chrono::steady_clock::now();
    try {
      if (!isForAnybody) host_.authorise(*context_);
      return true;
    } catch (...) {
      refuse(std::current_exception());
      return false;
    }
  }

  /// Reads what has come in `received_` and sees to it that it is answered.
  void take() {
    begun_ = std::chrono::steady_clock::now();
    bloated_ = bloated_ || received_.Length() > mostKept;
    if (const std::size_t length = received_.Length(); length > host_.mostMessageBytes) {
      received_.Clear();
      return refuse(std::make_exception_ptr(
          RpcFault(grpc::StatusCode::RESOURCE_EXHAUSTED, Refusal::tooLarge,
                   "the message has " + std::to_string(length) + " bytes; at most " +
                       std::to_string(host_.mostMessageBytes) + " are allowed")));
    }
    if (!read()) {
      return refuse(
          std::make_exception_ptr(RpcFault(grpc::StatusCode::INVALID_ARGUMENT, Refusal::malformed,
                                           "the request is no " + request_.GetTypeName())));
    }
    const Lane lane = answerer_.lane(request_);
    if (lane == Lane::here) return answer();
    if (host_.lanes.post(lane, [this] { answer(); })) return;
    refuse(std::make_exception_ptr(RpcFault(grpc::StatusCode::RESOURCE_EXHAUSTED, Refusal::tooLarge,
                                            "too many large requests are waiting; try again")));
  }

  void answer() {
    try {
      watch_.check();
      response_.Clear();
      const Outcome outcome = answerer_.answer(request_, response_, watch_);
      if (outcome.again.count() > 0) return wait(outcome.again);
      writeMessage(response_, sent_);
      count(outcome);
    } catch (...) {
      return refuse(std::current_exception());
    }
    derived().sendAnswer();
  }

  void statusSent(bool) { leave(); }

  grpc::ByteBuffer received_, sent_;
  grpc::ServerCompletionQueue* queue_ = nullptr;
  std::optional<grpc::ServerContext> context_;
  CallHost& host_;
  Step<CallSlot, &CallSlot::statusSent> statusSent_{*this};

 private:
  static constexpr std::size_t mostKept = std::size_t{1} << 20;  // bytes
  static constexpr bool isForAnybody = requires { Answerer::isForAnybody; };

  Derived& derived() { return static_cast<Derived&>(*this); }

  bool read() {
    if constexpr (requires { Answerer::read(received_, request_); }) {
      return Answerer::read(received_, request_);
    } else {
      return readMessage(received_, request_);
    }
  }

  void wait(std::chrono::milliseconds time) {
    alarm_.Set(queue_, std::chrono::system_clock::now() + time, &again_);
  }
  void waited(bool) { answer(); }

  void count(const Outcome& outcome) {
    if (isForAnybody) return;
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun_;
    host_.meter.answered(outcome.points, taken.count());
    if (outcome.frame) host_.meter.frameSent(taken.count());
    for (std::size_t i = 0; i < outcome.refused; ++i) host_.meter.refused(Refusal::badValue);
  }

  void refuse(std::exception_ptr thrown) {
    const RpcFault fault = faultOf(std::move(thrown));
    if (!isForAnybody) host_.meter.refused(fault.counted);
    derived().sendRefusal(statusOf(fault));
  }

  void done(bool) {
    if (context_->IsCancelled()) watch_.cancel();
    leave();
  }

  void leave() {
    if (--left_ > 0) return;
    answerer_.ended();
    received_.Clear();
    sent_.Clear();
    CallHost& host = host_;
    derived().retire();  // may do away with this object
    host.slotCloses();
  }

  Answerer answerer_;
  Request request_;
  Response response_;
  CallWatch watch_;
  std::chrono::steady_clock::time_point begun_;
  grpc::Alarm alarm_;
  Step<CallSlot, &CallSlot::done> done_{*this};
  Step<CallSlot, &CallSlot::waited> again_{*this};
  std::atomic<int> left_{0};
  bool bloated_ = false;
};

}  // namespace seaway::bridge::rpc
